#include "site.h"

#include "common/scene/scene_report.h"
#include "refuse.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- names ---- */

static void keep_name(void *ctx, uint32_t index, const char *name)
{
    struct site *site = ctx;

    if (index >= site->name_count) {
        uint32_t count = index + 16;
        char(*more)[TIA_NAME_MAX + 1] = realloc(site->names, count * sizeof *more);
        if (!more)
            return; /* without memory the material stays unnamed */
        memset(more + site->name_count, 0, (count - site->name_count) * sizeof *more);
        site->names = more;
        site->name_count = count;
    }
    (void)snprintf(site->names[index], sizeof site->names[index], "%s", name);
}

static const char *name_of(const struct site *site, uint32_t material)
{
    return material < site->name_count ? site->names[material] : "";
}

/* ---- materials ---- */

/* Returns the last naming for the material. A naming with the material's name takes precedence over one for all
 * materials. */
static const struct naming *naming_of(const struct options *o, const char *name)
{
    const struct naming *found = NULL;

    for (unsigned i = 0; i < o->namings.count; i++) {
        const struct naming *n = &o->namings.array[i];
        bool named = n->name[0] != '\0';
        if (named ? strcmp(n->name, name) == 0 : !found || found->name[0] == '\0')
            found = n;
    }
    return found;
}

static int set_medium(struct site *site, const struct options *o, uint32_t material)
{
    const char *name = name_of(site, material);
    const struct naming *naming = naming_of(o, name);
    struct medium *medium = &site->media[material];
    const char *itu = naming ? naming->itu : name;
    double low, high;

    medium->thickness = naming ? naming->thickness : 0;
    if (naming && naming->permittivity > 0) {
        medium->permittivity = naming->permittivity;
        medium->conductivity = naming->conductivity;
        medium->eta = medium_eta(naming->permittivity, naming->conductivity, o->frequency);
        return FINE;
    }
    if (name[0] == '\0' && !naming)
        return refuse(REFUSED, "%.300s: a material has no name (--material concrete is for all)", o->scene);
    if (!itu_has(itu))
        return refuse(REFUSED, "%.300s: material %.100s is none of ITU-R P.2040-3 (--material %.100s=concrete)",
                      o->scene, name, name);
    if (!itu_medium(itu, o->frequency, medium, &low, &high))
        return refuse(REFUSED, "--frequency: %g GHz is out of the range of %.60s, %g to %g GHz", o->frequency / 1e9,
                      itu, low, high);
    return FINE;
}

static bool is_named(const struct site *site, const char *name)
{
    for (uint32_t i = 0; i < site->name_count; i++)
        if (strcmp(site->names[i], name) == 0)
            return true;
    return false;
}

/* Sets the media of those materials that faces have. */
static int set_media(struct site *site, const struct options *o)
{
    struct tia_radio_counts counts = tia_radio_count(site->radio);
    int result = FINE;

    for (unsigned i = 0; i < o->namings.count; i++)
        if (o->namings.array[i].name[0] != '\0' && !is_named(site, o->namings.array[i].name))
            return refuse(REFUSED, "--material: %.100s: the scene has no such material", o->namings.array[i].name);
    site->media = calloc(site->file.scene.material_count + 1u, sizeof *site->media);
    if (!site->media)
        return refuse(FAILED, "memory: exhausted");
    for (uint32_t f = 0; f < counts.faces && result == FINE; f++) {
        uint32_t material = tia_radio_face(site->radio, f).material;
        if (site->media[material].permittivity == 0)
            result = set_medium(site, o, material);
    }
    return result;
}

/* ---- faces ---- */

static int find_faces(struct site *site, const struct options *o)
{
    size_t size = tia_radio_size(&site->file.scene);
    struct tia_fault fault;

    site->memory = size < SIZE_MAX ? malloc(size) : NULL;
    if (!site->memory)
        return refuse(FAILED, "memory: exhausted");
    if (tia_radio_init(&site->radio, site->memory, size, &site->file.scene, &fault) == TIA_ERR_RANGE)
        return refuse(REFUSED, "%.300s: %s %" PRIu32 ": %s: %s", o->scene, fault.thing, fault.index, fault.field,
                      fault.rule);
    struct tia_radio_counts counts = tia_radio_count(site->radio);
    if (counts.faces == 0)
        return refuse(REFUSED, "%.300s: no flat face: nothing to reflect a wave", o->scene);
    if (counts.left_out > 0)
        (void)refuse(FINE, "%.300s: objects without flat faces are left out: %" PRIu32, o->scene, counts.left_out);
    if (o->method == METHOD_IMAGE && tia_radio_sequences(site->radio, o->order) > SEQUENCES_MOST)
        return refuse(REFUSED,
                      "%.300s: too many faces for the image method: %" PRIu32 " planes and %" PRIu32
                      " reflections make more than %" PRIu64 " sequences (--method hybrid)",
                      o->scene, counts.planes, o->order, SEQUENCES_MOST);
    return FINE;
}

/* Returns the largest absolute coordinate of a transmitter, a receiver or the map, in units of 2^-16 m, rounded up. */
static tia_q16 reach_of(const struct options *o)
{
    double most = fabs(o->map.at);

    for (unsigned i = 0; i < PLACES_MOST; i++)
        for (int k = 0; k < 3; k++)
            most = fmax(most, fmax(fabs(o->tx.metres[i][k]), fabs(o->rx.metres[i][k])));
    for (int k = 0; k < 4; k++)
        most = fmax(most, fabs(o->area[k]));
    return (tia_q16)fmin(ceil(most * 65536) + 1, 2147483647.0);
}

void site_place(const struct site *site, struct options *o)
{
    for (unsigned i = 0; i < o->tx.count; i++)
        o->tx.array[i] = place_at(&site->world, o->tx.metres[i]);
    for (unsigned i = 0; i < o->rx.count; i++)
        o->rx.array[i] = place_at(&site->world, o->rx.metres[i]);
}

int site_open(struct site *site, const struct options *o)
{
    const struct scene_wish wish = {
        .reach = reach_of(o), .threads = o->threads, .hashed = true, .material = keep_name, .ctx = site};
    int format = scene_format_of(o->scene);

    *site = (struct site){.radio = NULL};
    if (format == SCENE_UNKNOWN && strcmp(o->scene, "-") == 0)
        format = TIA_FORMAT_TIA;
    if (format == SCENE_UNKNOWN)
        return refuse(REFUSED, "%.300s: unknown scene format (name it .tia, .nff, .obj, .stl, .ply, .off or .pgm)",
                      o->scene);
    int status = scene_open_for(&site->file, o->scene, format, false, &wish);
    if (status)
        return scene_report_print(&site->file, "tia-radio", status == TIA_ERR_MEMORY ? FAILED : REFUSED);
    int result = find_faces(site, o);
    if (result == FINE)
        result = set_media(site, o);
    site->world = (struct world){site->radio, site->media, o->frequency, o->up, site->file.scene.scale_bits};
    return result;
}

void site_close(struct site *site)
{
    scene_close(&site->file);
    free(site->names);
    free(site->media);
    free(site->memory);
}

int site_check_place(const struct site *site, const char *option, struct tia_vec3 place)
{
    uint32_t object = tia_radio_inside(site->radio, place);

    if (object == TIA_RADIO_NO_OBJECT)
        return FINE;
    return refuse(REFUSED, "%s: %g,%g,%g is inside a wall, object %" PRIu32, option, metres_of(&site->world, place.x),
                  metres_of(&site->world, place.y), metres_of(&site->world, place.z), object);
}
