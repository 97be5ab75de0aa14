/* transmittance.c - what stands between a point and a light.
 *
 * An object that lets nothing through ends the search. The others multiply what is left. Products are rounded,
 * so this is always done in the order of the indices, whatever order they are found in: one search keeps the
 * lowest few, and if there are more, another one looks for those above. */
#include "render/geometry/walk.h"
#include "scene/colour.h"
#include "trace.h"

#define KEPT 16

/* The objects with the lowest indices that let something through, in rising order. */
struct filters {
    uint32_t object[KEPT], material[KEPT], times[KEPT];
    uint32_t count, from; /* only objects from this index on */
    uint32_t blocker;     /* the object that takes all light */
    bool more;
};

static void keep(struct filters *filters, uint32_t object, uint32_t material, uint32_t times)
{
    uint32_t i = filters->count;

    if (i == KEPT) {
        filters->more = true;
        if (filters->object[KEPT - 1] < object)
            return;
        i--;
    }
    for (; i > 0 && filters->object[i - 1] > object; i--) {
        filters->object[i] = filters->object[i - 1];
        filters->material[i] = filters->material[i - 1];
        filters->times[i] = filters->times[i - 1];
    }
    filters->object[i] = object;
    filters->material[i] = material;
    filters->times[i] = times;
    filters->count += filters->count < KEPT;
}

static bool is_grid(const struct ray_view *view, uint32_t object)
{
    uint32_t spheres = view->scene->sphere_count;

    return object >= spheres && view->scene->shapes[object - spheres].kind == TIA_GRID;
}

/* False when the object takes all light. */
static bool object_transmits(const struct ray_view *view, const struct ray *ray, uint32_t object, num_length limit,
                             struct filters *filters)
{
    const struct tia_material *materials = view->scene->materials;
    bool grid = is_grid(view, object);
    uint32_t element = 0;

    if (object < filters->from || !ray_occluded_by(view, ray, object, limit, grid ? &element : NULL))
        return true;
    uint32_t material = ray_material(view, object, element);
    if (colour_is_black(&materials[material].transmission)) {
        filters->blocker = object;
        return false;
    }
    keep(filters, object, material, ray_groups_met(view, ray, object, limit));
    return true;
}

static bool all_transmit(const struct ray_view *view, const struct ray *ray, num_length limit, struct filters *filters)
{
    struct candidates candidates;
    struct asker asker = view_asker(view->view);
    uint32_t object;

    candidates_start(&candidates, view->scene, ray);
    while ((object = candidates_next(&candidates, limit)) != TIA_NO_OBJECT && !asker_stops(&asker, 1))
        if (!object_transmits(view, ray, object, limit, filters))
            return false;
    return true;
}

static void multiply(const struct ray_view *view, const struct filters *filters, num_length through[3])
{
    for (uint32_t i = 0; i < filters->count; i++) {
        num_length t[3];

        ray_rgb(&view->scene->materials[filters->material[i]].transmission, t);
        for (uint32_t n = 0; n < filters->times[i]; n++)
            for (int c = 0; c < 3; c++)
                through[c] = num_product(through[c], t[c]);
    }
}

bool ray_transmittance(const struct ray_view *view, const struct ray *ray, num_length limit, uint32_t *blocker,
                       num_length through[3])
{
    struct filters filters = {.from = 0};

    if (*blocker != TIA_NO_OBJECT && !object_transmits(view, ray, *blocker, limit, &filters))
        return false;
    through[0] = through[1] = through[2] = NUM_LENGTH_ONE;
    do {
        filters.count = 0;
        filters.more = false;
        if (!all_transmit(view, ray, limit, &filters)) {
            *blocker = filters.blocker;
            return false;
        }
        multiply(view, &filters, through);
        filters.from = filters.count ? filters.object[filters.count - 1] + 1 : 0;
    } while (filters.more && !view_stops(view->view));
    return through[0] > 0 || through[1] > 0 || through[2] > 0;
}
