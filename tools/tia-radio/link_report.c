#include "link_report.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#define DEGREES (180 / 3.14159265358979323846)

static const char *const polarisations[POLARISATIONS] = {"vertical", "horizontal"};

/* ---- a table ---- */

static void print_faces(const struct link_report *r, const struct tia_radio_path *path)
{
    for (uint32_t i = 0; i < path->order; i++)
        (void)printf(" %" PRIu32, tia_radio_face(r->world->radio, path->face[i]).object);
    for (uint32_t i = 0; i < path->wall_count; i++)
        (void)printf(" (%" PRIu32 ")", tia_radio_face(r->world->radio, path->wall[i].face).object);
    (void)putchar('\n');
}

static void print_path(const struct link_report *r, unsigned i)
{
    const struct field *f = &r->fields[i];

    (void)printf("%4u %2" PRIu32 " %12.6f %11.4f %8.2f %7.2f %8.2f %7.2f", i + 1, r->paths[i].order, f->length,
                 f->delay * 1e9, f->departure[0], f->departure[1], f->arrival[0], f->arrival[1]);
    for (int p = 0; p < POLARISATIONS; p++)
        (void)printf(" %9.3f %8.2f", 20 * log10(cabs(f->gain[p])), carg(f->gain[p]) * DEGREES);
    print_faces(r, &r->paths[i]);
}

void report_table(const struct link_report *r)
{
    struct summary s;

    (void)printf("# tx %g,%g,%g rx %g,%g,%g  %g GHz  %s, %" PRIu32 " reflections, %" PRIu32 " transmissions\n",
                 metres_of(r->world, r->tx.x), metres_of(r->world, r->tx.y), metres_of(r->world, r->tx.z),
                 metres_of(r->world, r->rx.x), metres_of(r->world, r->rx.y), metres_of(r->world, r->rx.z),
                 r->options->frequency / 1e9, method_name(r->options->method), r->options->order, r->options->walls);
    (void)printf("#path  n     length m    delay ns   az dep  el dep   az arr  el arr   gain V dB   phase   "
                 "gain H dB   phase objects (walls)\n");
    for (unsigned i = 0; i < r->count; i++)
        print_path(r, i);
    summarise(r->fields, r->paths, r->count, &s);
    for (int p = 0; p < POLARISATIONS && r->count > 0; p++) {
        (void)printf("# %-10s coherent %.3f dB, incoherent %.3f dB, delay spread %.4f ns, ", polarisations[p],
                     decibels(s.coherent[p]), decibels(s.incoherent[p]), s.delay_spread[p] * 1e9);
        if (s.rician[p] > 0)
            (void)printf("Rician factor %.3f dB\n", decibels(s.rician[p]));
        else
            (void)printf("no line of sight\n");
    }
    if (r->count == 0)
        (void)printf("# no path\n");
}

/* ---- JSON ---- */

/* Prints a value; JSON has no infinity. */
static void put(const char *key, double value, const char *after)
{
    if (isfinite(value))
        (void)printf("\"%s\": %.17g%s", key, value, after);
    else
        (void)printf("\"%s\": null%s", key, after);
}

static void put_vector(const struct link_report *r, const char *key, struct tia_vec3 v, const char *after)
{
    (void)printf("\"%s\": [%.17g, %.17g, %.17g]%s", key, metres_of(r->world, v.x), metres_of(r->world, v.y),
                 metres_of(r->world, v.z), after);
}

static void put_coefficients(struct coefficients c)
{
    (void)printf("\"te\": [%.17g, %.17g], \"tm\": [%.17g, %.17g]}", creal(c.te), cimag(c.te), creal(c.tm), cimag(c.tm));
}

static void put_meetings(const struct link_report *r, unsigned i)
{
    const struct tia_radio_path *path = &r->paths[i];

    (void)printf("      \"reflections\": [");
    for (uint32_t k = 0; k < path->order; k++) {
        struct tia_radio_face face = tia_radio_face(r->world->radio, path->face[k]);
        (void)printf("%s\n        {\"object\": %" PRIu32 ", \"face\": %" PRIu32 ", ", k > 0 ? "," : "", face.object,
                     path->face[k]);
        put_vector(r, "point", path->point[k], ", ");
        put_coefficients(r->fields[i].reflection[k]);
    }
    (void)printf("],\n      \"walls\": [");
    for (uint32_t k = 0; k < path->wall_count; k++) {
        struct tia_radio_face face = tia_radio_face(r->world->radio, path->wall[k].face);
        (void)printf("%s\n        {\"object\": %" PRIu32 ", \"face\": %" PRIu32 ", \"segment\": %" PRIu32 ", ",
                     k > 0 ? "," : "", face.object, path->wall[k].face, path->wall[k].segment);
        put_coefficients(r->fields[i].transmission[k]);
    }
    (void)printf("]}");
}

static void put_path(const struct link_report *r, unsigned i)
{
    const struct field *f = &r->fields[i];

    (void)printf("%s\n     {", i > 0 ? "," : "");
    put("length", f->length, ", ");
    put("delay", f->delay, ", ");
    (void)printf("\"departure\": [%.17g, %.17g], \"arrival\": [%.17g, %.17g],\n      ", f->departure[0],
                 f->departure[1], f->arrival[0], f->arrival[1]);
    for (int p = 0; p < POLARISATIONS; p++)
        (void)printf("\"%s\": [%.17g, %.17g],%s", polarisations[p], creal(f->gain[p]), cimag(f->gain[p]),
                     p == 0 ? " " : "\n");
    put_meetings(r, i);
}

static void put_summary(const struct link_report *r)
{
    struct summary s;

    summarise(r->fields, r->paths, r->count, &s);
    for (int p = 0; p < POLARISATIONS; p++) {
        (void)printf(",\n    \"%s\": {", polarisations[p]);
        put("coherent_dB", decibels(s.coherent[p]), ", ");
        put("incoherent_dB", decibels(s.incoherent[p]), ", ");
        put("delay_spread", s.delay_spread[p], ", ");
        put("rician_dB", decibels(s.rician[p]), "}");
    }
}

void report_json(const struct link_report *r, bool first)
{
    (void)printf("%s\n   {", first ? "" : ",");
    put_vector(r, "tx", r->tx, ", ");
    put_vector(r, "rx", r->rx, ",\n    \"paths\": [");
    for (unsigned i = 0; i < r->count; i++)
        put_path(r, i);
    (void)printf("]");
    put_summary(r);
    (void)printf("}");
}

void report_json_begin(const struct options *o, const struct world *world)
{
    struct tia_radio_counts counts = tia_radio_count(world->radio);

    (void)printf("{\"frequency\": %.17g, \"method\": \"%s\", \"reflections\": %" PRIu32 ", \"transmissions\": %" PRIu32
                 ",\n \"faces\": %" PRIu32 ", \"planes\": %" PRIu32 ",\n \"units\": \"metres, seconds, degrees\","
                 "\n \"links\": [",
                 o->frequency, method_name(o->method), o->order, o->walls, counts.faces, counts.planes);
}

void report_json_end(void)
{
    (void)printf("]}\n");
}
