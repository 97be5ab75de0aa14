/* view_memory.c - memory and a view for the display's mode. */
#include "loop.h"
#include "math/align.h"

static void set_tiles(struct loop *loop, unsigned height)
{
    const struct tia_mode *m = &loop->mode;

    loop->tile_width = m->tile_width && m->tile_width < m->width ? m->tile_width : m->width;
    loop->tile_height = m->tile_height && m->tile_height < height ? m->tile_height : height;
    loop->columns = (m->width + loop->tile_width - 1) / loop->tile_width;
    loop->tiles = (uint32_t)loop->columns * ((m->height + loop->tile_height - 1) / loop->tile_height);
}

enum { PARTS = 9 };

/* Gets memory from the caller for the current scene, its hierarchy, the view, two bytes for each tile, the hits of an
 * area, the vector units, and a canvas of `canvas` bytes with the work of its tiles. False: there is not enough. */
static bool get_memory(struct loop *loop, struct tia_tile hits, uint64_t canvas)
{
    const struct tia_viewer *v = loop->viewer;
    uint64_t sizes[PARTS] = {loop->current_size,
                             loop->bvh_size,
                             loop->view_size,
                             loop->tiles,
                             loop->core->hits_size(loop->core, loop->base, hits),
                             loop->simd_size,
                             loop->tiles,
                             canvas,
                             canvas ? (uint64_t)loop->tiles * sizeof *loop->work : 0};
    size_t sum = 0;
    char *parts[PARTS] = {NULL}, *memory;

    for (int i = 0; i < PARTS; i++) {
        if (sizes[i] >= SIZE_MAX / 8)
            return false;
        sum += ALIGN((size_t)sizes[i]);
    }
    memory = v->hooks.memory(v->hooks.ctx, sum);
    if (!memory_is_usable(memory))
        return false;
    for (int i = 0; i < PARTS; i++) {
        parts[i] = memory;
        memory += ALIGN((size_t)sizes[i]);
    }
    loop->current = (struct tia_scene *)(void *)parts[0];
    loop->bvh_memory = parts[1];
    loop->view = (struct tia_view *)(void *)parts[2];
    loop->status = (int8_t *)parts[3];
    loop->hits_memory = parts[4];
    loop->hits_size = (size_t)sizes[4];
    loop->simd_memory = parts[5];
    loop->passes = (uint8_t *)parts[6];
    loop->work = (struct tile_work *)(void *)parts[8];
    if (loop->more)
        loop->more->set_canvas(loop, parts[7], canvas);
    return true;
}

/* Gets memory for as much as the caller allows. Tries in turn: the whole frame's hits, a canvas and sums of samples;
 * the same without sums; the hits alone; the hits of one tile, of as many rows as fit. */
static bool get_most_memory(struct loop *loop)
{
    struct tia_tile frame = {0, 0, loop->mode.width, loop->mode.height};

    set_tiles(loop, loop->more ? loop->more->strip_rows(loop) : VIEWER_STRIP);
    loop->last_us = 0;
    loop->whole = (loop->more && (get_memory(loop, frame, loop->more->canvas_size(loop, true)) ||
                                  get_memory(loop, frame, loop->more->canvas_size(loop, false)))) ||
                  get_memory(loop, frame, 0);
    if (loop->whole)
        return true;
    for (unsigned rows = VIEWER_STRIP; rows > 0; rows /= 2) {
        set_tiles(loop, rows);
        struct tia_tile tile = {0, 0, (uint16_t)loop->tile_width, (uint16_t)loop->tile_height};
        if (get_memory(loop, tile, 0))
            return true;
    }
    return false;
}

int tia_viewer_prepare(struct loop *loop)
{
    loop->view_ready = loop->complete = false;
    if (loop->more)
        loop->more->gaze(loop);
    for (unsigned i = 0; i < VIEWER_PASSES; i++)
        loop->pass_pixels[i] = 0;
    loop->view_size = loop->core->view_size(loop->core, loop->base, loop->viewer->lights.capacity);
    loop->simd_size = loop->viewer->simd && loop->core->simd_size
                          ? loop->core->simd_size(loop->core, loop->viewer->simd, loop->base,
                                                  loop->viewer->lights.capacity, viewer_workers(loop))
                          : 0;
    return get_most_memory(loop) ? TIA_OK : TIA_ERR_MEMORY;
}

int tia_viewer_prepare_view(struct loop *loop)
{
    const struct tia_job job = {.stop = tia_viewer_stops, .ctx = loop};
    struct tia_tile frame = {0, 0, loop->mode.width, loop->mode.height};
    int status = loop->core->view_init(loop->core, &loop->view, loop->view, loop->view_size, loop->scene,
                                       loop->viewer->lights.capacity, loop->mode.width, loop->mode.height, &job);

    if (!status && loop->viewer->simd)
        status = tia_view_set_simd(loop->view, loop->viewer->simd, loop->simd_memory, loop->simd_size);
    if (!status && loop->whole)
        status = tia_hits_init(&loop->hits, loop->hits_memory, loop->hits_size, loop->view, frame);
    loop->view_ready = !status;
    loop->traced = 0;
    loop->changed = true;
    return status;
}
