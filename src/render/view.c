#include "view.h"

#include "choose.h"
#include "math/align.h"
#include "render/span/span.h"
#include "render/whitted/rays.h"

size_t tia_view_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    size_t room = scene_needs_rays(scene) ? ray_size(scene, light_capacity) : span_size(scene, light_capacity);
    uint64_t size = ALIGN(sizeof(struct tia_view)) + ALIGN((uint64_t)light_capacity * sizeof(struct tia_light)) +
                    ALIGN((uint64_t)room);

    return room > SIZE_MAX / 2 || size > SIZE_MAX / 2 ? SIZE_MAX : (size_t)size;
}

static int prepare(struct tia_view *view, char *memory)
{
    view->lights = (struct tia_light *)(void *)memory;
    view->light_count = 0;
    view->rays = NULL;
    memory += ALIGN(view->light_capacity * sizeof *view->lights);
    if (scene_needs_rays(view->scene))
        return ray_prepare(view, memory);
    span_prepare(view, memory);
    return TIA_OK;
}

int tia_view_init(struct tia_view **view, void *memory, size_t size, const struct tia_scene *scene,
                  uint32_t light_capacity, unsigned width, unsigned height)
{
    struct tia_view *v = memory;
    int status;

    if (!width || !height || width > TIA_SIZE_MAX || height > TIA_SIZE_MAX || light_capacity < scene->light_count)
        return TIA_ERR_ARGUMENT;
    if (tia_scene_check(scene, NULL) != TIA_OK)
        return TIA_ERR_RANGE;
    if (size < tia_view_size(scene, light_capacity))
        return TIA_ERR_MEMORY;
    v->scene = scene;
    v->light_capacity = light_capacity;
    v->width = (int)width;
    v->height = (int)height;
    status = prepare(v, (char *)memory + ALIGN(sizeof *v));
    *view = v;
    return status ? status : tia_view_set_lights(v, scene->lights, scene->light_count);
}

static bool are_acceptable(const struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    struct tia_scene alone = {.camera = view->scene->camera, .lights = lights, .light_count = count};

    return tia_scene_check(&alone, NULL) == TIA_OK && (view->rays || !scene_needs_rays(&alone));
}

int tia_view_set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    if (count > view->light_capacity)
        return TIA_ERR_MEMORY;
    if (!are_acceptable(view, lights, count))
        return TIA_ERR_RANGE;
    view->light_count = count;
    for (uint32_t i = 0; i < count; i++)
        view->lights[i] = lights[i];
    if (view->rays)
        ray_set_lights(view);
    else
        span_set_lights(view);
    return TIA_OK;
}
