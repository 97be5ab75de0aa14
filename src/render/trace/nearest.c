/* nearest.c - the nearest hit of a ray. The hit does not depend on the hierarchy: of several objects at the same
 * distance, the one with the lowest index is hit. */
#include "render/geometry/walk.h"
#include "trace.h"

struct num_point ray_sphere_centre(const struct tia_scene *scene, uint32_t sphere)
{
    struct num_point centre = num_point_of(scene->spheres[sphere].centre);

    return scene->fine ? num_point_add(centre, num_point_fine(scene->fine->spheres[sphere].centre)) : centre;
}

num_length ray_sphere_radius(const struct tia_scene *scene, uint32_t sphere)
{
    num_length radius = num_length_of(scene->spheres[sphere].radius);

    return scene->fine ? radius + num_fine(scene->fine->spheres[sphere].radius) : radius;
}

static bool meet_shape(const struct shape *shape, const struct ray *ray, num_length limit,
                       struct intersection *intersection)
{
    const struct instance *instance = shape->instance;
    struct instance_ray placed;

    if (!instance)
        return shape->kind->intersect(shape, ray, limit, intersection);
    instance_transform_ray(instance, ray, &placed);
    num_length within = instance_limit(&placed, limit);
    if (within < 0 || !shape->kind->intersect(shape, &placed.ray, within, intersection))
        return false;
    intersection->t = instance_distance_back(&placed, intersection->t);
    return intersection->t <= limit;
}

static bool meet(const struct ray_view *view, const struct ray *ray, uint32_t object, num_length limit,
                 struct intersection *intersection)
{
    const struct tia_scene *scene = view->scene;

    if (object >= scene->sphere_count)
        return meet_shape(&view->shapes[object - scene->sphere_count], ray, limit, intersection);
    intersection->element = 0;
    return sphere_intersect(ray_sphere_centre(scene, object), ray_sphere_radius(scene, object), ray, limit,
                            &intersection->t);
}

static bool occludes_placed(const struct shape *shape, const struct ray *ray, num_length limit)
{
    struct instance_ray placed;

    instance_transform_ray(shape->instance, ray, &placed);
    limit = instance_distance(&placed, limit);
    return limit >= 0 && shape->kind->occluded(shape, &placed.ray, limit);
}

bool ray_occluded_by(const struct ray_view *view, const struct ray *ray, uint32_t object, num_length limit,
                     uint32_t *element)
{
    uint32_t spheres = view->scene->sphere_count;
    struct intersection intersection;

    if (object >= spheres && !element) {
        const struct shape *shape = &view->shapes[object - spheres];
        return shape->instance ? occludes_placed(shape, ray, limit) : shape->kind->occluded(shape, ray, limit);
    }
    bool met = meet(view, ray, object, limit, &intersection);
    if (met && element)
        *element = intersection.element;
    return met;
}

uint32_t ray_groups_met(const struct ray_view *view, const struct ray *ray, uint32_t object, num_length limit)
{
    const struct tia_scene *scene = view->scene;
    uint32_t spheres = scene->sphere_count;
    struct instance_ray placed;

    if (object < spheres || scene->shapes[object - spheres].kind != TIA_MESH ||
        !scene->meshes[scene->shapes[object - spheres].mesh].groups)
        return 1;
    const struct shape *shape = &view->shapes[object - spheres];
    if (!shape->instance)
        return mesh_groups_met(shape, ray, limit);
    instance_transform_ray(shape->instance, ray, &placed);
    return mesh_groups_met(shape, &placed.ray, instance_distance(&placed, limit));
}

bool ray_is_layered(const struct ray_view *view, uint32_t object)
{
    const struct tia_scene *scene = view->scene;

    if (object < scene->sphere_count)
        return scene->materials[scene->spheres[object].material].opacity;
    return view->shapes[object - scene->sphere_count].layered;
}

enum inside ray_inside(const struct ray_view *view, uint32_t object)
{
    uint32_t spheres = view->scene->sphere_count;

    return object < spheres ? INSIDE_WHOLE : view->shapes[object - spheres].inside;
}

static void try_object(const struct ray_view *view, const struct ray *ray, uint32_t object, struct hit *hit)
{
    struct intersection intersection;

    if (meet(view, ray, object, hit->t, &intersection) &&
        (intersection.t < hit->t || (intersection.t == hit->t && object < hit->object))) {
        hit->t = intersection.t;
        hit->object = object;
        hit->element = intersection.element;
    }
}

bool ray_meets(const struct ray_view *view, const struct ray *ray, uint32_t object, num_length limit, struct hit *hit)
{
    struct intersection intersection;

    if (!meet(view, ray, object, limit, &intersection))
        return false;
    *hit = (struct hit){intersection.t, object, intersection.element, TIA_NO_OBJECT};
    return true;
}

static void clear(struct hit *hit)
{
    *hit = (struct hit){NUM_LENGTH_MAX, TIA_NO_OBJECT, 0, TIA_NO_OBJECT};
}

void ray_intersect(const struct ray_view *view, const struct ray *ray, struct hit *hit)
{
    struct candidates candidates;
    struct cancel cancel = view_cancel(view->view);
    uint32_t object;

    clear(hit);
    candidates_start(&candidates, view->scene, ray);
    while ((object = candidates_next(&candidates, hit->t)) != TIA_NO_OBJECT && !cancelled(&cancel, 1))
        try_object(view, ray, object, hit);
}

void ray_intersect_object(const struct ray_view *view, const struct ray *ray, uint32_t object, struct hit *hit)
{
    clear(hit);
    if (object != TIA_NO_OBJECT)
        try_object(view, ray, object, hit);
}

void ray_intersect_lights(const struct ray_view *view, const struct ray *ray, struct hit *hit)
{
    ray_intersect_lights_of(view, ray, ~0u, hit);
}

void ray_intersect_lights_of(const struct ray_view *view, const struct ray *ray, unsigned kinds, struct hit *hit)
{
    struct cancel cancel = view_cancel(view->view);

    for (uint32_t n = 0; view->lit && n < view->light_count && !cancelled(&cancel, 1); n++) {
        num_length t;
        if ((kinds >> view->lights[n].kind & 1) && ray_light_intersect(&view->lights[n], ray, hit->t, &t)) {
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
        sphere_surface(ray_sphere_centre(scene, hit->object), point, surface);
        return;
    }
    const struct shape *shape = &view->shapes[hit->object - scene->sphere_count];
    const struct instance *instance = shape->instance;
    if (instance)
        point = instance_point(instance, point);
    shape->kind->surface(shape, point, hit->element, surface);
    if (instance) {
        surface->normal = instance_normal(instance, surface->normal);
        surface->smooth = instance_normal(instance, surface->smooth);
    }
}

struct num_point ray_own_point(const struct ray_view *view, const struct hit *hit, struct num_point point)
{
    const struct tia_scene *scene = view->scene;

    if (hit->object < scene->sphere_count)
        return num_point_sub(point, ray_sphere_centre(scene, hit->object));
    const struct shape *shape = &view->shapes[hit->object - scene->sphere_count];
    if (shape->instance)
        point = instance_point(shape->instance, point);
    return shape->kind == &SHAPE_KIND(sphere) ? num_point_sub(point, shape->sphere.centre) : point;
}

int ray_uv(const struct ray_view *view, const struct hit *hit, struct num_point point, num_length uv[2])
{
    const struct tia_scene *scene = view->scene;

    if (hit->object < scene->sphere_count) {
        sphere_uv(ray_sphere_centre(scene, hit->object), point, uv);
        return 0;
    }
    const struct shape *shape = &view->shapes[hit->object - scene->sphere_count];
    if (shape->instance)
        point = instance_point(shape->instance, point);
    shape->kind->uv(shape, point, hit->element, uv);
    uint32_t element = hit->element;
    return shape_part(shape, &element)->uv_bits;
}

const struct shape_kind *ray_kind(const struct ray_view *view, const struct hit *hit, uint32_t *element)
{
    uint32_t spheres = view->scene->sphere_count;

    *element = hit->element;
    return hit->object < spheres ? &SHAPE_KIND(sphere)
                                 : shape_part(&view->shapes[hit->object - spheres], element)->kind;
}

uint32_t ray_material(const struct ray_view *view, uint32_t object, uint32_t element)
{
    const struct tia_scene *scene = view->scene;

    if (object < scene->sphere_count)
        return scene->spheres[object].material;
    return shape_material(&view->shapes[object - scene->sphere_count], element);
}
