#include "pov.h"

#include <math.h>

/* The distance of a directional light: greater than the distance between any two points of a scene. */
#define FAR 200000.0

/* Returns the number of samples along each side of an area light. */
static unsigned side_of(const struct tia_light *l)
{
    unsigned samples = l->samples > 0 ? l->samples : TIA_LIGHT_SAMPLES_DEFAULT;

    return (unsigned)ceil(sqrt(samples));
}

/* Chooses D and p of POV-Ray's attenuation 2/(1 + (d/D)^p). Returns the factor for the light's colour that makes the
 * attenuation equal to 1/(constant + term d^p). */
static double fade(const struct tia_light *l, double *distance, int *power)
{
    double constant = pov_q16(l->constant), term = pov_q16(l->quadratic != 0 ? l->quadratic : l->linear);

    *power = l->quadratic != 0 ? 2 : 1;
    term = ldexp(term, -*power * l->unit_bits);
    *distance = 0;
    if (term == 0)
        return constant != 0 ? 1 / constant : 1;
    /* without a constant term D would have to be 0: a very small D is used */
    *distance = constant != 0 ? pow(constant / term, 1.0 / *power) : 0.001;
    return constant != 0 ? 1 / (2 * constant) : 1 / (2 * term * pow(*distance, *power));
}

static void write_fade(struct pov *pov, uint32_t index, double distance, int power)
{
    const struct tia_light *l = &pov->scene->lights[index];

    if (distance != 0)
        text_word(&pov->text, "fade_distance %.10g fade_power %d", distance, power);
    if (l->linear != 0 && l->quadratic != 0)
        pov_note(pov, "light %u: its attenuation has no linear term here besides the quadratic one", index);
}

/* Writes an area light. POV-Ray's outermost samples lie on the light's edges; shrinking the light by the width of one
 * cell puts all samples at the centres of cells. */
static void area(struct pov *pov, struct point a, struct point b, unsigned n, const char *form)
{
    double f = 2.0 * (n - 1) / n;

    text_word(&pov->text, "area_light");
    pov_triple(pov, "", pov_scaled(a, f));
    text_word(&pov->text, ",");
    pov_triple(pov, "", pov_scaled(b, f));
    text_word(&pov->text, ", %u, %u area_illumination on %s", n, n, form);
}

static void round_area(struct pov *pov, const struct tia_light *l, struct point normal, const char *form)
{
    struct point a, b;

    pov_axes(normal, &a, &b);
    area(pov, pov_scaled(a, pov_length(pov, l->radius)), pov_scaled(b, pov_length(pov, l->radius)), side_of(l), form);
}

static void spot(struct pov *pov, uint32_t index, const struct tia_light *l)
{
    text_word(&pov->text, "spotlight radius %.10g falloff %.10g tightness 0", pov_q16(l->inner), pov_q16(l->outer));
    pov_triple(pov, "point_at", pov_sum(pov_place(pov, l->centre), pov_dir3(l->direction)));
    if (l->inner != l->outer)
        pov_note(pov, "light %u: between its cones it falls off along a cubic here, linearly in the cosine in tia",
                 index);
}

static void rectangular_area(struct pov *pov, uint32_t index, const struct tia_light *l)
{
    (void)index;
    area(pov, pov_place(pov, l->side[0]), pov_place(pov, l->side[1]), side_of(l), "");
}

static void disc_area(struct pov *pov, uint32_t index, const struct tia_light *l)
{
    (void)index;
    round_area(pov, l, pov_dir3(l->direction), "circular");
}

static void turned_area(struct pov *pov, uint32_t index, const struct tia_light *l)
{
    (void)index;
    round_area(pov, l, (struct point){0, 0, 1}, "circular orient");
}

static void no_area(struct pov *pov, uint32_t index, const struct tia_light *l)
{
    (void)pov;
    (void)index;
    (void)l;
}

static void rectangle(struct pov *pov, const struct tia_light *l)
{
    static const int corners[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};

    text_word(&pov->text, "polygon { 5,");
    for (int i = 0; i < 5; i++) {
        struct point p = pov_sum(pov_scaled(pov_place(pov, l->side[0]), corners[i][0]),
                                 pov_scaled(pov_place(pov, l->side[1]), corners[i][1]));
        pov_triple(pov, "", pov_sum(pov_place(pov, l->centre), p));
    }
}

static void disc(struct pov *pov, const struct tia_light *l)
{
    pov_triple(pov, "disc {", pov_place(pov, l->centre));
    pov_triple(pov, ",", pov_dir3(l->direction));
    text_word(&pov->text, ", %.10g", pov_length(pov, l->radius));
}

static void ball(struct pov *pov, const struct tia_light *l)
{
    pov_triple(pov, "sphere {", pov_place(pov, l->centre));
    text_word(&pov->text, ", %.10g", pov_length(pov, l->radius));
}

static void no_surface(struct pov *pov, const struct tia_light *l)
{
    (void)pov;
    (void)l;
}

struct pov_light {
    void (*area)(struct pov *pov, uint32_t index, const struct tia_light *l); /* writes the keywords of a spot or an
                                                                                 area */
    void (*surface)(struct pov *pov, const struct tia_light *l);              /* writes the beginning of the light's
                                                                                 object */
};

/* A row for each of TIA_LIGHTS. */
#define LIGHT(name, area, surface) static const struct pov_light name##_light = {area, surface}
LIGHT(point, no_area, ball);
LIGHT(directional, no_area, no_surface);
LIGHT(ambient, no_area, no_surface);
LIGHT(spot, spot, no_surface);
LIGHT(rectangle, rectangular_area, rectangle);
LIGHT(disc, disc_area, disc);
LIGHT(sphere, turned_area, ball);

static const struct pov_light *kind_of(const struct tia_light *l)
{
#define ENTRY(KIND, name, what, traits) [KIND] = &name##_light,
    static const struct pov_light *const kinds[] = {TIA_LIGHTS(ENTRY)};
#undef ENTRY

    return kinds[l->kind];
}

static void write_light(struct pov *pov, uint32_t index)
{
    const struct tia_light *l = &pov->scene->lights[index];
    double distance = 0, factor = 1;
    int power = 0;

    text_print(&pov->text, "light_source {\n");
    if (tia_light_has(l->kind, TIA_LIGHT_FAR)) {
        pov_triple(pov, "", pov_scaled(pov_dir3(l->direction), -FAR));
        pov_triple(pov, "rgb", pov_rgb(l->emission));
        text_word(&pov->text, "parallel point_at 0");
    } else {
        factor = fade(l, &distance, &power);
        pov_triple(pov, "", pov_place(pov, l->centre));
        pov_triple(pov, "rgb", pov_scaled(pov_rgb(l->emission), factor));
        kind_of(l)->area(pov, index, l);
        write_fade(pov, index, distance, power);
    }
    text_print(&pov->text, "\n}\n");
}

/* Writes the visible surface of a light; it casts no shadow. */
static void write_seen(struct pov *pov, const struct tia_light *l)
{
    if (!tia_light_has(l->kind, TIA_LIGHT_SURFACE) || (tia_light_has(l->kind, TIA_LIGHT_RADIUS) && l->radius == 0))
        return;
    kind_of(l)->surface(pov, l);
    pov_triple(pov, "no_shadow pigment { rgb", pov_rgb(l->emission));
    text_word(&pov->text, "} finish { emission 1 diffuse 0 } }");
    text_print(&pov->text, "\n");
}

void pov_lights(struct pov *pov)
{
    for (uint32_t i = 0; i < pov->scene->light_count; i++) {
        if (tia_light_has(pov->scene->lights[i].kind, TIA_LIGHT_EVERYWHERE))
            continue;
        write_light(pov, i);
        write_seen(pov, &pov->scene->lights[i]);
    }
    text_print(&pov->text, "\n");
}
