#include "surfaces.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <tia/debug.h>

#include "arithmetic.h"
#include "common/thread_pool.h"
#include "fail.h"
#include "film_plan.h"
#include "film_scene.h"

struct finding {
    struct options options; /* options of a picture of one ray a pixel */
    struct film_scene film_scene;
    struct image_surface *pixels;
    unsigned width, height;
    double unit; /* length of 2^-16 of the scene's unit in the file's unit */
    atomic_int status;
};

struct seen {
    const struct finding *finding;
    struct image_surface *pixel;
    bool known;
};

static void see(void *ctx, const struct tia_traced *traced)
{
    struct seen *seen = ctx;

    if (seen->known || traced->ray != TIA_RAY_PRIMARY)
        return;
    seen->known = true;
    if (traced->length == INT32_MAX)
        return;
    *seen->pixel = (struct image_surface){.depth = (float)(traced->length * seen->finding->unit)};
    if (traced->object == TIA_NO_OBJECT) /* a light */
        return;
    seen->pixel->object = traced->object + 1;
    seen->pixel->normal[0] = (float)traced->normal.x / TIA_Q16_ONE;
    seen->pixel->normal[1] = (float)traced->normal.y / TIA_Q16_ONE;
    seen->pixel->normal[2] = (float)traced->normal.z / TIA_Q16_ONE;
}

static int find_pixel(const struct finding *f, struct tia_hits *hits, struct tia_tile tile)
{
    struct seen seen = {f, &f->pixels[(size_t)tile.y * f->width + tile.x], false};
    struct tia_observer observer = {see, &seen, 0};
    const struct tia_options how = {.debug = &(struct tia_debug){.observer = &observer}};
    tia_rgb565 colour;
    const struct tia_surface surface = {.pixels = &colour, .step = sizeof colour, .pitch = sizeof colour};

    *seen.pixel = (struct image_surface){.depth = INFINITY};
    return tia_view_light(f->film_scene.view, hits, tile, &surface, &how);
}

static void find_row(void *arg, unsigned y)
{
    struct finding *f = arg;
    const struct tia_core *core = f->options.core;
    const struct tia_tile row = {0, (uint16_t)y, (uint16_t)f->width, 1};
    size_t size = core->hits_size(core, f->film_scene.scene, row);
    void *memory = malloc(size);
    struct tia_hits *hits = NULL;
    int status = memory ? tia_hits_init(&hits, memory, size, f->film_scene.view, row) : TIA_ERR_MEMORY;

    status = status ? status : tia_view_trace(f->film_scene.view, hits, row);
    for (unsigned x = 0; x < f->width && !status; x++)
        status = find_pixel(f, hits, (struct tia_tile){(uint16_t)x, (uint16_t)y, 1, 1});
    if (status)
        atomic_store(&f->status, status);
    free(memory);
}

/* Makes options whose scene is drawn by single rays through the middle of the pixels. */
static void prepare(struct finding *f, const struct options *options)
{
    struct tia_scene *scene = &f->options.scene;
    struct rotation rotation = film_rotation(options);

    f->options = *options;
    f->options.core = arithmetic_watched();
    f->options.simd = NULL;
    scene->integration = (struct tia_integration){.integrator = TIA_WHITTED};
    scene->shadows = TIA_SHADOWS_TRACED;
    scene->camera.samples = 1;
    scene->depth = 1;
    views_need_rays(scene);
    f->width = rotation.width;
    f->height = rotation.height;
    f->unit = ldexp(1, -16 - (options->scene_path ? options->file.placement.bits : (int)scene->scale_bits));
}

static int find(struct finding *f, char *why)
{
    struct threads *pool = threads_create(f->options.threads);
    int status = pool && f->pixels ? film_scene_begin(&f->film_scene, &f->options, why) : TIA_ERR_MEMORY;

    status = status ? status : film_scene_update(&f->film_scene, 0);
    if (!status)
        threads_run(pool, find_row, f, f->height);
    film_scene_end(&f->film_scene);
    threads_destroy(pool);
    return status ? status : atomic_load(&f->status);
}

int surfaces_find(struct image_surface **surfaces, const struct options *options, char *why)
{
    struct finding *f;

    *surfaces = NULL;
    if (!arithmetic_watched() || options->core != &tia_core_q16) {
        note("%.200s: without depth, normals and objects: %s", options->output,
             arithmetic_watched() ? "only rays of integers have them" : "not built in (make builds it)");
        return TIA_OK;
    }
    f = calloc(1, sizeof *f);
    if (!f)
        return TIA_ERR_MEMORY;
    prepare(f, options);
    f->pixels = malloc((size_t)f->width * f->height * sizeof *f->pixels);
    int status = find(f, why);
    *surfaces = f->pixels;
    if (status) {
        free(f->pixels);
        *surfaces = NULL;
    }
    free(f);
    return status;
}
