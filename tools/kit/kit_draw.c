/* kit_draw.c - a scene file drawn in one call, on one thread, as `tia -n 1` draws it. */
#include <stdlib.h>
#include <tia/tia.h>

#include "common/scene/moment.h"
#include "common/scene/scene_load.h"
#include "common/scene/scene_report.h"
#include "kit.h"

/* The memory of a picture. */
struct drawing {
    struct moment moment;
    void *view, *simd, *hits;
};

static int exhausted(void)
{
    kit_refuse("memory: exhausted");
    return TIA_ERR_MEMORY;
}

static int refuse_scene(int status, const char *name, const struct tia_scene *scene)
{
    struct tia_fault fault;

    if (status == TIA_ERR_MEMORY)
        return exhausted();
    if (tia_scene_check(scene, &fault))
        kit_refuse("%.300s: %s %u: %s: %s", name, fault.thing, (unsigned)fault.index, fault.field, fault.rule);
    else
        kit_refuse("%.300s: this scene cannot be drawn so", name);
    return status;
}

static void *get(void **memory, size_t size)
{
    *memory = size < SIZE_MAX ? malloc(size ? size : 1) : NULL;
    return *memory;
}

static void set_options(struct tia_scene *scene, const int32_t *options)
{
    struct tia_integration *how = &scene->integration;

    if (options[KIT_INTEGRATOR] >= 0)
        how->integrator = (enum tia_integrator)options[KIT_INTEGRATOR];
    if (options[KIT_SEED] >= 0)
        how->seed = (uint32_t)options[KIT_SEED];
    if (how->integrator != TIA_WHITTED)
        scene->shadows = TIA_SHADOWS_TRACED;
    if (options[KIT_SAMPLES] > 0 && how->integrator == TIA_WHITTED)
        scene->camera.samples = (uint32_t)options[KIT_SAMPLES];
    else if (options[KIT_SAMPLES] > 0)
        how->spp = (uint32_t)options[KIT_SAMPLES];
}

static int draw_view(struct drawing *drawing, const struct tia_scene *scene, const int32_t *options, uint16_t *pixels)
{
    const struct tia_simd *simd = tia_simd_best();
    struct tia_tile area = {0, 0, (uint16_t)options[KIT_WIDTH], (uint16_t)options[KIT_HEIGHT]};
    struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * (ptrdiff_t)area.width};
    struct tia_options how = {.dither = options[KIT_DITHER] != 0};
    size_t view_size = tia_view_size(scene, scene->light_count), hits_size = tia_hits_size(scene, area),
           simd_size = tia_simd_size(simd, scene, scene->light_count, 1);
    struct tia_view *view;
    struct tia_hits *hits;

    if (!get(&drawing->view, view_size) || !get(&drawing->hits, hits_size) || !get(&drawing->simd, simd_size))
        return TIA_ERR_MEMORY;
    int status =
        tia_view_init(&view, drawing->view, view_size, scene, scene->light_count, area.width, area.height, NULL);
    if (!status)
        status = tia_view_set_lights(view, scene->lights, scene->light_count);
    if (!status)
        status = tia_view_set_simd(view, simd, drawing->simd, simd_size);
    if (!status)
        status = tia_hits_init(&hits, drawing->hits, hits_size, view, area);
    return status ? status : tia_view_draw(view, hits, area, &surface, &how);
}

static int draw(const char *name, struct tia_scene *scene, const int32_t *options, uint16_t *pixels)
{
    struct drawing drawing = {.view = NULL};
    struct tia_fault fault;

    set_options(scene, options);
    int status = tia_scene_check(scene, &fault);
    if (!status)
        status = moment_begin(&drawing.moment, scene, options[KIT_TIME]);
    if (!status)
        status = tia_scene_check(scene, &fault);
    if (!status)
        status = draw_view(&drawing, scene, options, pixels);
    if (status)
        (void)refuse_scene(status, name, scene);
    moment_end(&drawing.moment);
    free(drawing.view);
    free(drawing.simd);
    free(drawing.hits);
    return status;
}

/* True if the options are in their ranges; else the reason is stored. */
static bool are_valid(const int32_t *options)
{
    static const char *const names[KIT_OPTIONS] = {"width", "height", "integrator", "samples",
                                                   "seed",  "dither", "time"};
    static const int32_t ranges[KIT_OPTIONS][2] = {
        [KIT_WIDTH] = {1, TIA_SIZE_MAX},  [KIT_HEIGHT] = {1, TIA_SIZE_MAX}, [KIT_INTEGRATOR] = {-1, TIA_PATHS},
        [KIT_SAMPLES] = {0, TIA_SPP_MAX}, [KIT_SEED] = {-1, INT32_MAX},     [KIT_DITHER] = {0, 1},
        [KIT_TIME] = {0, INT32_MAX}};

    for (int i = 0; i < KIT_OPTIONS; i++) {
        if (options[i] < ranges[i][0] || options[i] > ranges[i][1]) {
            kit_refuse("%s: %d is not in %d..%d", names[i], (int)options[i], (int)ranges[i][0], (int)ranges[i][1]);
            return false;
        }
    }
    return true;
}

int kit_draw(const char *name, const int32_t *options, uint16_t *pixels)
{
    struct scene_file file;
    int format = scene_format_of(name);

    if (!are_valid(options))
        return TIA_ERR_ARGUMENT;
    if (format == SCENE_UNKNOWN || format == SCENE_MODEL) {
        kit_refuse("%.300s: not a scene of a format that the kit reads (.tia, .nff, .obj, .stl, .ply, .off, .pgm)",
                   name);
        return TIA_ERR_ARGUMENT;
    }
    int status = scene_open(&file, name, format, false);
    if (status) {
        kit_refuse("%s", file.why);
        scene_report_free(&file);
        return status;
    }
    struct tia_scene scene = file.scene;
    status = draw(name, &scene, options, pixels);
    scene_close(&file);
    return status;
}
