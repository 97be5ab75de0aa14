#include "math/align.h"
#include "renderer.h"

size_t tia_core_view_size(const struct tia_core *core, const struct tia_scene *scene, uint32_t light_capacity)
{
    if (!core || !scene)
        return SIZE_MAX;
    const struct renderer *renderer = tia_renderer_for(core, scene);
    size_t prepared = renderer ? renderer->prepared_size(scene, light_capacity) : 0;
    uint64_t size = ALIGN(sizeof(struct tia_view)) + ALIGN((uint64_t)light_capacity * sizeof(struct tia_light)) +
                    ALIGN((uint64_t)prepared);

    return prepared > SIZE_MAX / 2 || size > SIZE_MAX / 2 ? SIZE_MAX : (size_t)size;
}

static int check(const struct tia_core *core, const struct tia_scene *scene, struct cancel cancel)
{
    int status = core->renderers->check(scene, NULL, &cancel);
    return status && status != TIA_STOPPED ? TIA_ERR_RANGE : status;
}

int tia_core_view_init(const struct tia_core *core, struct tia_view **view, void *memory, size_t size,
                       const struct tia_scene *scene, uint32_t light_capacity, unsigned width, unsigned height,
                       const struct tia_job *job)
{
    struct tia_view *v = memory;

    if (!core || !view || !memory_is_usable(memory) || !scene || width - 1 >= TIA_SIZE_MAX ||
        height - 1 >= TIA_SIZE_MAX || light_capacity < scene->light_count)
        return TIA_ERR_ARGUMENT;
    int status = check(core, scene, cancel_for(job));
    if (status)
        return status;
    if (size < tia_core_view_size(core, scene, light_capacity))
        return TIA_ERR_MEMORY;
    const struct renderer *renderer = tia_renderer_for(core, scene);
    if (!renderer)
        return TIA_ERR_UNSUPPORTED;
    v->core = core;
    v->scene = scene;
    v->renderer = renderer;
    v->simd = NULL;
    v->simd_memory = NULL;
    v->raster_runs = NULL;
    v->lights = (struct tia_light *)(void *)((char *)memory + ALIGN(sizeof *v));
    v->light_count = 0;
    v->light_capacity = light_capacity;
    v->width = (int)width;
    v->height = (int)height;
    v->stop = job ? job->stop : NULL;
    v->stop_ctx = job ? job->ctx : NULL;
    v->prepared = (char *)v->lights + ALIGN(light_capacity * sizeof *v->lights);
    status = renderer->prepare(v);
    if (!status)
        status = tia_drawing_set_lights(v, scene->lights, scene->light_count);
    *view = v;
    return status;
}

static int check_lights(const struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    struct tia_scene alone = {.camera = view->scene->camera,
                              .lights = lights,
                              .light_count = count,
                              .integration = view->scene->integration,
                              .shadows = view->scene->shadows,
                              .shadow_map = view->scene->shadow_map,
                              .scale_bits = view->scene->scale_bits};
    bool (*draws)(const struct tia_scene *scene) = view->renderer->draws;
    int status = check(view->core, &alone, view_cancel(view));

    return !status && draws && !draws(&alone) ? TIA_ERR_RANGE : status;
}

int tia_drawing_set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    if (count > view->light_capacity)
        return TIA_ERR_MEMORY;
    int status = check_lights(view, lights, count);
    if (!status && view->renderer->refuses)
        status = view->renderer->refuses(view, lights, count);
    if (status)
        return status;
    view->light_count = count;
    for (uint32_t i = 0; i < count; i++)
        view->lights[i] = lights[i];
    status = view->renderer->set_lights(view);
    if (!status && view->simd)
        view->simd->enter->prepare(view);
    return status;
}

/* Returns the part of an instruction set's code for a renderer; NULL: there is none, or the code is for a different
 * arithmetic. */
static const struct simd_renderer *drawn_by(const struct tia_core *core, const struct tia_simd *simd,
                                            const struct renderer *renderer)
{
    return simd && renderer && simd->plain == core->renderers->plain ? simd_renderer_for(simd, renderer) : NULL;
}

size_t tia_core_simd_size(const struct tia_core *core, const struct tia_simd *simd, const struct tia_scene *scene,
                          uint32_t light_capacity, unsigned workers)
{
    if (!core || !scene)
        return SIZE_MAX;
    const struct simd_renderer *drawn = drawn_by(core, simd, tia_renderer_for(core, scene));

    return drawn ? simd->enter->size(simd, drawn, scene, light_capacity, workers) : 0;
}

int tia_view_set_simd(struct tia_view *view, const struct tia_simd *simd, void *memory, size_t size)
{
    if (!view)
        return TIA_ERR_ARGUMENT;
    if (!view->core->renderers)
        return TIA_OK;
    const struct simd_renderer *drawn = drawn_by(view->core, simd, view->renderer);

    view->simd = NULL;
    view->raster_runs = simd ? simd->raster : NULL;
    if (!drawn || !drawn->draws(view))
        return TIA_OK;
    if (!memory_is_usable(memory))
        return TIA_ERR_ARGUMENT;
    if (size < tia_core_simd_size(view->core, simd, view->scene, view->light_capacity, 1))
        return TIA_ERR_MEMORY;
    view->simd = simd;
    simd->enter->open(view, memory, size);
    return TIA_OK;
}

const char *tia_view_simd(const struct tia_view *view)
{
    return view && view->core->renderers && view->simd ? view->simd->name : "plain";
}
