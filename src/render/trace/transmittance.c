/* transmittance.c - what stands between a point and a light.
 *
 * An object that lets nothing through ends the search. The others multiply what is left, and since products
 * are rounded, always in the order of their indices, in whatever order they are found: the lowest few are
 * kept, and where there are more, the search is made again for those above. */
#include "render/geometry/walk.h"
#include "scene/colour.h"
#include "trace.h"

#define KEPT 16

/* The objects with the lowest indices that let something through, in rising order. */
struct veils {
    uint32_t object[KEPT], material[KEPT];
    uint32_t count, from; /* only objects from this index on */
    uint32_t blocker;     /* the object that takes all light */
    bool more;
};

static void keep(struct veils *veils, uint32_t object, uint32_t material)
{
    uint32_t i = veils->count;

    if (i == KEPT) {
        veils->more = true;
        if (veils->object[KEPT - 1] < object)
            return;
        i--;
    }
    for (; i > 0 && veils->object[i - 1] > object; i--) {
        veils->object[i] = veils->object[i - 1];
        veils->material[i] = veils->material[i - 1];
    }
    veils->object[i] = object;
    veils->material[i] = material;
    veils->count += veils->count < KEPT;
}

static bool is_grid(const struct ray_view *view, uint32_t object)
{
    uint32_t spheres = view->scene->sphere_count;

    return object >= spheres && view->scene->shapes[object - spheres].kind == TIA_GRID;
}

/* False when the object takes all light. */
static bool passes_object(const struct ray_view *view, const struct ray *ray, uint32_t object, num_x limit,
                          struct veils *veils)
{
    const struct tia_material *materials = view->scene->materials;
    bool grid = is_grid(view, object);
    uint32_t element = 0;

    if (object < veils->from || !ray_occluded(view, ray, object, limit, grid ? &element : NULL))
        return true;
    uint32_t material = ray_material(view, object, element);
    if (colour_is_black(&materials[material].transmission)) {
        veils->blocker = object;
        return false;
    }
    keep(veils, object, material);
    return true;
}

static bool passes_all(const struct ray_view *view, const struct ray *ray, num_x limit, struct veils *veils)
{
    struct candidates candidates;
    uint32_t object;

    candidates_start(&candidates, view->scene, ray);
    while ((object = candidates_next(&candidates, limit)) != TIA_NO_OBJECT)
        if (!passes_object(view, ray, object, limit, veils))
            return false;
    return true;
}

static void multiply(const struct ray_view *view, const struct veils *veils, num_x through[3])
{
    for (uint32_t i = 0; i < veils->count; i++) {
        num_x t[3];

        ray_rgb(&view->scene->materials[veils->material[i]].transmission, t);
        for (int c = 0; c < 3; c++)
            through[c] = num_product(through[c], t[c]);
    }
}

bool ray_passes(const struct ray_view *view, const struct ray *ray, num_x limit, uint32_t *blocker, num_x through[3])
{
    struct veils veils = {.from = 0};

    if (*blocker != TIA_NO_OBJECT && !passes_object(view, ray, *blocker, limit, &veils))
        return false;
    through[0] = through[1] = through[2] = NUM_X_ONE;
    do {
        veils.count = 0;
        veils.more = false;
        if (!passes_all(view, ray, limit, &veils)) {
            *blocker = veils.blocker;
            return false;
        }
        multiply(view, &veils, through);
        veils.from = veils.count ? veils.object[veils.count - 1] + 1 : 0;
    } while (veils.more);
    return through[0] > 0 || through[1] > 0 || through[2] > 0;
}
