#include "stage.h"

#include <stdlib.h>
#include <string.h>

#include <tia/debug.h>

#include "common/crc_join.h"
#include "pixels/pages.h"

/* Threads share a frame in jobs of whole rows: of one row if rays draw them, since a pixel takes long then and jobs
 * cost nothing; else of as many as tia draws at once into a file. */
enum { JOB_PIXELS = 1 << 13, RAY_JOB_PIXELS = 1, UNDRAWN = 0x5a };

/* Makes the memory at least `size` bytes large; its contents may be lost. */
static bool get_memory(struct benchmark_memory *memory, size_t size)
{
    if (memory->at && memory->size >= size)
        return true;
    free(memory->at);
    memory->at = size < SIZE_MAX ? pages_alloc(size + !size) : NULL;
    memory->size = memory->at ? size : 0;
    return memory->at;
}

/* ---- the scene ---- */

static int read_scene(struct benchmark_stage *stage)
{
    struct tia_reader reader = {
        .format = TIA_FORMAT_TIA, .text = stage->frame->scene, .length = strlen(stage->frame->scene)};
    size_t need = 0;
    int status = tia_read(&reader, &stage->scene, NULL, 0, &need);

    if (status != TIA_ERR_MEMORY)
        return status;
    if (!get_memory(&stage->scene_memory, need))
        return TIA_ERR_MEMORY;
    status = tia_read(&reader, &stage->scene, stage->scene_memory.at, need, &need);
    size_t size = status ? 0 : tia_bvh_size(&stage->scene);
    if (!status && !get_memory(&stage->boxes, size))
        return TIA_ERR_MEMORY;
    return status ? status : tia_bvh_build(&stage->scene.bvh, stage->boxes.at, size, NULL, &stage->scene, NULL);
}

/* The built-in scene with the light of key a. */
static int take_built_in(struct benchmark_stage *stage)
{
    stage->scene = tia_thesis_scene;
    stage->scene.lights = &tia_thesis_scene.bindings[0].state;
    stage->scene.light_count = 1;
    return TIA_OK;
}

static unsigned job_count(const struct benchmark_stage *stage)
{
    return (stage->frame->height + stage->job_rows - 1) / stage->job_rows;
}

int benchmark_open(struct benchmark_stage *stage, const struct benchmark_frame *frame)
{
    size_t count = (size_t)frame->width * frame->height;

    *stage = (struct benchmark_stage){.frame = frame};
    int status = frame->scene ? read_scene(stage) : take_built_in(stage);
    if (status)
        return status;
    unsigned pixels = tia_draws_by_pixel(&stage->scene) ? (unsigned)RAY_JOB_PIXELS : (unsigned)JOB_PIXELS;
    stage->job_rows = (pixels + frame->width - 1) / frame->width;
    stage->pixels = pages_alloc(count * sizeof *stage->pixels);
    stage->crcs = malloc(job_count(stage) * sizeof *stage->crcs);
    if (!stage->pixels || !stage->crcs)
        return TIA_ERR_MEMORY;
    memset(stage->pixels, UNDRAWN, count * sizeof *stage->pixels);
    return TIA_OK;
}

void benchmark_close(struct benchmark_stage *stage)
{
    free(stage->pixels);
    free(stage->crcs);
    free(stage->scene_memory.at);
    free(stage->boxes.at);
    free(stage->view_memory.at);
    free(stage->hits_memory.at);
    free(stage->simd_memory.at);
}

/* ---- drawing ---- */

static struct tia_tile tile_of(const struct benchmark_stage *stage, unsigned job)
{
    unsigned y = job * stage->job_rows, left = stage->frame->height - y;

    return (struct tia_tile){0, (uint16_t)y, stage->frame->width,
                             (uint16_t)(left < stage->job_rows ? left : stage->job_rows)};
}

static tia_rgb565 *pixels_of(const struct benchmark_stage *stage, struct tia_tile tile)
{
    return stage->pixels + (size_t)tile.y * stage->frame->width;
}

static void draw_rows(void *arg, unsigned job)
{
    struct benchmark_stage *stage = arg;
    struct tia_tile tile = tile_of(stage, job);
    const struct tia_surface surface = {.pixels = pixels_of(stage, tile),
                                        .step = sizeof(tia_rgb565),
                                        .pitch = (ptrdiff_t)(tile.width * sizeof(tia_rgb565))};
    int status = tia_view_draw(stage->view, stage->hits, tile, &surface, NULL);

    if (status)
        atomic_store(&stage->status, status);
}

int benchmark_prepare(struct benchmark_stage *stage, const struct tia_simd *simd, unsigned threads)
{
    const struct benchmark_frame *frame = stage->frame;
    const struct tia_tile all = {0, 0, frame->width, frame->height};
    uint32_t lights = stage->scene.light_count;
    size_t view = tia_view_size(&stage->scene, lights), hits = tia_hits_size(&stage->scene, all);
    size_t more = tia_simd_size(simd, &stage->scene, lights, threads);

    if (!get_memory(&stage->view_memory, view) || !get_memory(&stage->hits_memory, hits) ||
        !get_memory(&stage->simd_memory, more))
        return TIA_ERR_MEMORY;
    int status = tia_view_init(&stage->view, stage->view_memory.at, view, &stage->scene, lights, frame->width,
                               frame->height, NULL);
    status = status ? status : tia_view_set_simd(stage->view, simd, stage->simd_memory.at, more);
    return status ? status : tia_hits_init(&stage->hits, stage->hits_memory.at, hits, stage->view, all);
}

int benchmark_draw(struct benchmark_stage *stage, const struct tia_simd *simd, struct threads *pool)
{
    int status = benchmark_prepare(stage, simd, threads_count(pool));

    if (status)
        return status;
    atomic_store(&stage->status, TIA_OK);
    threads_run(pool, draw_rows, stage, job_count(stage));
    return atomic_load(&stage->status);
}

/* ---- the CRC ---- */

/* All threads compute it, so that none of them sleeps when the next frame begins. */
static void check_rows(void *arg, unsigned job)
{
    struct benchmark_stage *stage = arg;
    struct tia_tile tile = tile_of(stage, job);
    size_t count = (size_t)tile.width * tile.height;
    tia_rgb565 *pixels = pixels_of(stage, tile);

    stage->crcs[job] = tia_crc32(0, pixels, count);
    memset(pixels, UNDRAWN, count * sizeof *pixels);
}

uint32_t benchmark_check_pixels(struct benchmark_stage *stage, struct threads *pool)
{
    uint32_t crc = 0;

    threads_run(pool, check_rows, stage, job_count(stage));
    for (unsigned job = 0; job < job_count(stage); job++) {
        struct tia_tile tile = tile_of(stage, job);
        crc = crc_join(crc, stage->crcs[job], (uint64_t)tile.width * tile.height * sizeof *stage->pixels);
    }
    return crc;
}
