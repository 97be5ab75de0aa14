#include "math/align.h"
#include "renderer.h"

size_t tia_view_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    size_t prepared = renderer_for(scene)->prepared_size(scene, light_capacity);
    uint64_t size = ALIGN(sizeof(struct tia_view)) + ALIGN((uint64_t)light_capacity * sizeof(struct tia_light)) +
                    ALIGN((uint64_t)prepared);

    return prepared > SIZE_MAX / 2 || size > SIZE_MAX / 2 ? SIZE_MAX : (size_t)size;
}

int tia_view_init(struct tia_view **view, void *memory, size_t size, const struct tia_scene *scene,
                  uint32_t light_capacity, unsigned width, unsigned height)
{
    struct tia_view *v = memory;
    int status;

    if (!width || !height || width > TIA_SIZE_MAX || height > TIA_SIZE_MAX || light_capacity < scene->light_count)
        return TIA_ERR_ARGUMENT;
    if (tia_scene_check(scene, NULL))
        return TIA_ERR_RANGE;
    if (size < tia_view_size(scene, light_capacity))
        return TIA_ERR_MEMORY;
    v->scene = scene;
    v->renderer = renderer_for(scene);
    v->lights = (struct tia_light *)(void *)((char *)memory + ALIGN(sizeof *v));
    v->light_count = 0;
    v->light_capacity = light_capacity;
    v->width = (int)width;
    v->height = (int)height;
    v->stop = NULL;
    v->prepared = (char *)v->lights + ALIGN(light_capacity * sizeof *v->lights);
    status = v->renderer->prepare(v);
    *view = v;
    return status ? status : tia_view_set_lights(v, scene->lights, scene->light_count);
}

static bool are_acceptable(const struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    struct tia_scene alone = {
        .camera = view->scene->camera, .lights = lights, .light_count = count, .shadows = view->scene->shadows};

    return !tia_scene_check(&alone, NULL) && view->renderer->draws(&alone);
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
    view->renderer->set_lights(view);
    return TIA_OK;
}

void tia_view_set_stop(struct tia_view *view, bool (*stop)(void *ctx), void *ctx)
{
    view->stop = stop;
    view->stop_ctx = ctx;
}
