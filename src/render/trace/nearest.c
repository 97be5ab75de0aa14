/* nearest.c - what a ray meets first. Whether by a hierarchy or by trying all, it is the same: of several
 * objects at the same distance the lowest index. */
#include "render/geometry/walk.h"
#include "trace.h"

static bool meet_shape(const struct shape *shape, const struct ray *ray, num_x limit, struct crossing *crossing)
{
    const struct placement *placement = shape->placement;
    struct placed_ray placed;

    if (!placement)
        return shape->kind->intersect(shape, ray, limit, crossing);
    placement_ray(placement, ray, &placed);
    num_x within = placement_limit(&placed, limit);
    if (within < 0 || !shape->kind->intersect(shape, &placed.ray, within, crossing))
        return false;
    crossing->t = placement_distance_back(&placed, crossing->t);
    return crossing->t <= limit;
}

static bool meet(const struct ray_view *view, const struct ray *ray, uint32_t object, num_x limit,
                 struct crossing *crossing)
{
    const struct tia_scene *scene = view->scene;

    if (object >= scene->sphere_count)
        return meet_shape(&view->shapes[object - scene->sphere_count], ray, limit, crossing);
    const struct tia_sphere *s = &scene->spheres[object];
    crossing->element = 0;
    return sphere_intersect(num_point_of(s->centre), num_x_of(s->radius), ray, limit, &crossing->t);
}

static bool occludes_placed(const struct shape *shape, const struct ray *ray, num_x limit)
{
    struct placed_ray placed;

    placement_ray(shape->placement, ray, &placed);
    limit = placement_distance(&placed, limit);
    return limit >= 0 && shape->kind->occluded(shape, &placed.ray, limit);
}

bool ray_occluded(const struct ray_view *view, const struct ray *ray, uint32_t object, num_x limit, uint32_t *element)
{
    uint32_t spheres = view->scene->sphere_count;
    struct crossing crossing;

    if (object >= spheres && !element) {
        const struct shape *shape = &view->shapes[object - spheres];
        return shape->placement ? occludes_placed(shape, ray, limit) : shape->kind->occluded(shape, ray, limit);
    }
    bool met = meet(view, ray, object, limit, &crossing);
    if (met && element)
        *element = crossing.element;
    return met;
}

static void try_object(const struct ray_view *view, const struct ray *ray, uint32_t object, struct hit *hit)
{
    struct crossing crossing;

    if (meet(view, ray, object, hit->t, &crossing) &&
        (crossing.t < hit->t || (crossing.t == hit->t && object < hit->object))) {
        hit->t = crossing.t;
        hit->object = object;
        hit->element = crossing.element;
    }
}

static void clear(struct hit *hit)
{
    *hit = (struct hit){NUM_X_MOST, TIA_NO_OBJECT, 0, TIA_NO_OBJECT};
}

void ray_nearest(const struct ray_view *view, const struct ray *ray, struct hit *hit)
{
    struct candidates candidates;
    uint32_t object;

    clear(hit);
    candidates_start(&candidates, view->scene, ray);
    while ((object = candidates_next(&candidates, hit->t)) != TIA_NO_OBJECT)
        try_object(view, ray, object, hit);
}

void ray_meet(const struct ray_view *view, const struct ray *ray, uint32_t object, struct hit *hit)
{
    clear(hit);
    if (object != TIA_NO_OBJECT)
        try_object(view, ray, object, hit);
}

void ray_see_lights(const struct ray_view *view, const struct ray *ray, struct hit *hit)
{
    for (uint32_t n = 0; n < view->light_count; n++) {
        num_x t;
        if (ray_light_seen(&view->lights[n], ray, hit->t, &t)) {
            hit->t = t;
            hit->object = TIA_NO_OBJECT;
            hit->light = n;
        }
    }
}

void ray_surface(const struct ray_view *view, const struct hit *hit, struct num_point point, struct surface *surface)
{
    const struct tia_scene *scene = view->scene;

    if (hit->object < scene->sphere_count) {
        sphere_surface(num_point_of(scene->spheres[hit->object].centre), point, surface);
        return;
    }
    const struct shape *shape = &view->shapes[hit->object - scene->sphere_count];
    const struct placement *placement = shape->placement;
    if (placement)
        point = placement_point(placement, point);
    shape->kind->surface(shape, point, hit->element, surface);
    if (placement) {
        surface->normal = placement_normal(placement, surface->normal);
        surface->smooth = placement_normal(placement, surface->smooth);
    }
}

void ray_uv(const struct ray_view *view, const struct hit *hit, struct num_point point, num_x uv[2])
{
    const struct tia_scene *scene = view->scene;

    if (hit->object < scene->sphere_count) {
        sphere_uv(num_point_of(scene->spheres[hit->object].centre), point, uv);
        return;
    }
    const struct shape *shape = &view->shapes[hit->object - scene->sphere_count];
    if (shape->placement)
        point = placement_point(shape->placement, point);
    shape->kind->uv(shape, point, hit->element, uv);
}

uint32_t ray_material(const struct ray_view *view, uint32_t object, uint32_t element)
{
    const struct tia_scene *scene = view->scene;

    if (object < scene->sphere_count)
        return scene->spheres[object].material;
    return shape_material(&view->shapes[object - scene->sphere_count], element);
}
