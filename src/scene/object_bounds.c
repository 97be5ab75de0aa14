/* object_bounds.c - boxes around objects. */
#include "object_bounds.h"

#include "math/integer.h"
#include "scene/shapes/description.h"

/* Returns the most by which the scene's fine digits enlarge a box, in units of 2^-16: half a unit each for centre and
 * radius. */
static int64_t fine_margin(const struct tia_scene *scene)
{
    return scene->fine ? 1 : 0;
}

static void around_sphere(const struct tia_scene *scene, const struct tia_sphere *s, struct bounds_wide *bounds)
{
    const tia_q16 centre[3] = {s->centre.x, s->centre.y, s->centre.z};
    int64_t reach = s->radius + fine_margin(scene);

    for (int k = 0; k < 3; k++) {
        bounds->min[k] = centre[k] - reach;
        bounds->max[k] = centre[k] + reach;
    }
}

static bool around_shape(const struct frame *frame, const struct tia_scene *scene, const struct tia_shape *shape,
                         const struct tia_bounds *own, struct bounds_wide *bounds)
{
    struct hull hull = {frame, {INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};
    const struct shape_description *description = tia_shape_description(shape->kind);

    if (!description || !description->add_bounds)
        return false;
    if (own && shape->kind == TIA_MESH)
        tia_hull_add_box(&hull, own);
    else
        description->add_bounds(&hull, scene, shape);
    if (hull.max[0] < hull.min[0])
        return false;
    for (int k = 0; k < 3; k++) {
        bounds->min[k] = (hull.min[k] >> 16) - fine_margin(scene);
        bounds->max[k] = ((hull.max[k] + 0xffff) >> 16) + fine_margin(scene);
    }
    return true;
}

bool tia_bounds_in_world(const struct tia_scene *scene, uint32_t object, const struct tia_bounds *own,
                         struct bounds_wide *bounds)
{
    struct frame frame;

    if (object < scene->sphere_count) {
        around_sphere(scene, &scene->spheres[object], bounds);
        return true;
    }
    const struct tia_shape *shape = &scene->shapes[object - scene->sphere_count];
    tia_frame_prepare(&frame, shape->transform ? &scene->transforms[shape->transform - 1] : NULL);
    return around_shape(&frame, scene, shape, own, bounds);
}

void tia_bounds_in_own_axes(const struct tia_scene *scene, const struct tia_shape *shape, const struct tia_bounds *own,
                            struct bounds_wide *bounds)
{
    struct frame none;

    tia_frame_prepare(&none, NULL);
    *bounds = (struct bounds_wide){{0, 0, 0}, {0, 0, 0}};
    (void)around_shape(&none, scene, shape, own, bounds);
    for (int k = 0; k < 3; k++) {
        bounds->min[k]--;
        bounds->max[k]++;
    }
}

/* Returns x as Q16.16; if it does not fit, clamps it and sets *fits to false. */
static tia_q16 cut(int64_t x, bool *fits)
{
    tia_q16 nearest = tia_saturate_s32(x);

    *fits = *fits && nearest == x;
    return nearest;
}

bool tia_bounds_with_margin(const struct bounds_wide *bounds, struct tia_bounds *out)
{
    const int64_t *min = bounds->min, *max = bounds->max;
    bool fits = true;

    out->min = (struct tia_vec3){cut(min[0] - 1, &fits), cut(min[1] - 1, &fits), cut(min[2] - 1, &fits)};
    out->max = (struct tia_vec3){cut(max[0] + 1, &fits), cut(max[1] + 1, &fits), cut(max[2] + 1, &fits)};
    return fits;
}

struct tia_bounds tia_object_bounds(const struct tia_scene *scene, uint32_t index)
{
    struct bounds_wide wide;
    struct tia_bounds bounds = BOUNDS_NOTHING;

    if (scene && index < (uint64_t)scene->sphere_count + scene->shape_count &&
        tia_bounds_in_world(scene, index, NULL, &wide))
        (void)tia_bounds_with_margin(&wide, &bounds);
    return bounds;
}
