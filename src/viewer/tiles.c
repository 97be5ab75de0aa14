/* tiles.c - draws a frame tile by tile. */
#include "loop.h"
#include "math/divisor.h"
#include "math/tile.h"

bool tia_viewer_same_mode(const struct tia_mode *a, const struct tia_mode *b)
{
    return a->width == b->width && a->height == b->height && a->tile_width == b->tile_width &&
           a->tile_height == b->tile_height && a->concurrent == b->concurrent;
}

struct tia_tile tia_viewer_tile(const struct loop *loop, unsigned index)
{
    unsigned x = index % loop->columns * loop->tile_width, y = index / loop->columns * loop->tile_height;
    unsigned width = loop->mode.width - x, height = loop->mode.height - y;
    struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)(width < loop->tile_width ? width : loop->tile_width),
                            (uint16_t)(height < loop->tile_height ? height : loop->tile_height)};

    return tile;
}

/* Tiles of a coarse frame are drawn in steps of the golden section, 40503/65536, of their number, or the next smaller
 * step that comes to each tile: so those drawn so far are always spread over the picture, a fair sample of it. */
void tia_viewer_set_order(struct loop *loop)
{
    loop->step = (uint32_t)((uint64_t)loop->tiles * 40503 >> 16);
    while (loop->step > 1 && common_divisor(loop->step, loop->tiles) != 1)
        loop->step--;
    loop->step += !loop->step;
}

unsigned tia_viewer_in_order(const struct loop *loop, unsigned index)
{
    return (unsigned)((uint64_t)index * loop->step % loop->tiles);
}

static int draw_tile(struct loop *loop, struct tia_tile tile)
{
    const struct tia_viewer *v = loop->viewer;
    const struct tia_options options = {.dither = v->dither};
    struct tia_hits *hits = loop->hits;
    struct tia_surface surface;
    int status = tia_viewer_watch(loop);

    surface_set_swap(&surface, false);
    if (!status && !loop->whole)
        status = tia_hits_init(&hits, loop->hits_memory, loop->hits_size, loop->view, tile);
    if (!status)
        status = v->ports.display->acquire(v->ports.display_ctx, tile, &surface);
    if (!status)
        status = loop->traced == VIEWER_PASSES ? tia_view_light(loop->view, hits, tile, &surface, &options)
                                               : tia_view_draw(loop->view, hits, tile, &surface, &options);
    return status ? status : v->ports.display->submit(v->ports.display_ctx, tile);
}

static void tile_job(void *arg, unsigned index)
{
    struct loop *loop = arg;
    loop->status[index] = (int8_t)draw_tile(loop, tia_viewer_tile(loop, index));
}

int tia_viewer_run_tiles(struct loop *loop, void (*job)(void *loop, unsigned index))
{
    const struct tia_viewer *v = loop->viewer;
    int status = TIA_OK;

    if (v->job.workers && loop->mode.concurrent && loop->whole) {
        v->job.workers->run(v->job.workers->ctx, job, loop, (unsigned)loop->tiles);
        for (unsigned i = 0; status >= 0 && i < loop->tiles; i++)
            status = loop->status[i] ? loop->status[i] : status;
    } else {
        for (unsigned i = 0; !status && i < loop->tiles; i++) {
            job(loop, i);
            status = loop->status[i];
        }
    }
    return status;
}

int tia_viewer_draw_tiles(struct loop *loop)
{
    return tia_viewer_run_tiles(loop, tile_job);
}
