/* prepare.c - a scene for general rays: the camera, the lights, shapes and their instances. */
#include "math/align.h"
#include "scene/bounds.h"
#include "scene/colour.h"
#include "trace.h"

size_t ray_prepared_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t size = ALIGN(sizeof(struct ray_view)) + ALIGN((uint64_t)light_capacity * sizeof(struct ray_light)) +
                    (uint64_t)scene->shape_count * (sizeof(struct shape) + sizeof(struct instance));

    return size < SIZE_MAX / 2 ? (size_t)size : SIZE_MAX;
}

/* What refracted rays can enter. */
static enum inside inside_of(const struct tia_scene *scene, const struct tia_shape *given)
{
    switch (given->kind) {
    case TIA_GRID:
        return INSIDE_CELLS;
    case TIA_CYLINDER:
        return given->cylinder.capped ? INSIDE_WHOLE : INSIDE_NONE;
    case TIA_CONE:
        return given->cone.capped ? INSIDE_WHOLE : INSIDE_NONE;
    case TIA_MESH:
        return !colour_is_black(&scene->materials[given->material].refraction) &&
                       mesh_is_closed(&scene->meshes[given->mesh])
                   ? INSIDE_WHOLE
                   : INSIDE_NONE;
    case TIA_DISC:
    case TIA_TRIANGLE:
        return INSIDE_NONE;
    default:
        return INSIDE_WHOLE;
    }
}

/* Whether one of some materials has an opacity texture. */
static bool have_opacity(const struct tia_scene *scene, uint32_t first, uint32_t count)
{
    bool found = false;

    for (uint32_t m = first; m < scene->material_count && m - first < count; m++)
        found = found || scene->materials[m].opacity;
    return found;
}

/* False: the shape has no transform. */
static bool place(const struct tia_scene *scene, const struct tia_shape *given, struct instance *instance)
{
    struct bounds_wide box;

    if (!given->transform)
        return false;
    tia_bounds_in_own_axes(scene, given, &box);
    instance_prepare(instance, &scene->transforms[given->transform - 1], &box);
    return true;
}

static void prepare_shapes(struct ray_view *view)
{
    const struct tia_scene *scene = view->scene;
    struct instance *instance = view->instances;

    for (uint32_t i = 0; i < scene->shape_count; i++) {
        const struct tia_shape *given = &scene->shapes[i];
        struct shape *shape = &view->shapes[i];

        shape->material = given->material;
        shape->inside = inside_of(scene, given);
        shape->layered = have_opacity(scene, given->material, given->kind == TIA_GRID ? UINT8_MAX : 1);
        shape->instance = NULL;
        shape_prepare(shape, scene, given);
        if (place(scene, given, instance))
            shape->instance = instance++;
    }
}

int ray_prepare(struct tia_view *view)
{
    const struct tia_scene *scene = view->scene;
    struct ray_view *rays = view->prepared;

    rays->view = view;
    rays->scene = scene;
    rays->lights = (struct ray_light *)(void *)((char *)view->prepared + ALIGN(sizeof *rays));
    rays->shapes = (struct shape *)(void *)((char *)rays->lights + ALIGN(view->light_capacity * sizeof *rays->lights));
    rays->instances = (struct instance *)(rays->shapes + scene->shape_count);
    rays->light_count = 0;
    rays->depth = scene->depth ? scene->depth : TIA_DEPTH;
    ray_camera_prepare(&rays->camera, scene, view->width, view->height);
    rays->bias = num_scene_bias(scene->fine, scene->scale_bits);
    rays->layered = have_opacity(scene, 0, scene->material_count);
    prepare_shapes(rays);
    return TIA_OK;
}

void ray_set_lights(struct tia_view *view)
{
    struct ray_view *rays = view->prepared;

    rays->light_count = view->light_count;
    for (uint32_t i = 0; i < view->light_count; i++)
        ray_light_prepare(&rays->lights[i], &view->lights[i], view->scene->scale_bits);
}
