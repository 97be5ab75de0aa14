/* refine.c - a frame that takes long, coarse to fine: every 16th pixel of every 16th row first, each as a block, then
 * the pixels in between, until there are no blocks left. Each pixel is drawn once, so in the end they are those of a
 * frame drawn at once. Blocks do not cross tiles, which may be drawn by several threads.
 *
 * The picture so far is in loop->canvas: a display forgets what it was given before. */
#include "loop.h"

#define PERIOD_US UINT32_C(16666) /* a frame drawn in less is shown whole: that of a display with 60 Hz */
#define REFINE_US 250000      /* between two looks at a pass that takes long; a scene that plays shows nothing sooner */
#define WORTH_LINE_US 1000000 /* a frame that takes less has no line for its progress */
#define FIRST_BLOCK (1u << (VIEWER_PASSES - 1))

static unsigned block_of(unsigned pass)
{
    return FIRST_BLOCK >> pass;
}

static tia_rgb565 *canvas_at(const struct loop *loop, unsigned x, unsigned y)
{
    return loop->canvas + (size_t)y * loop->mode.width + x;
}

static unsigned at_most(unsigned value, unsigned limit)
{
    return value < limit ? value : limit;
}

/* ---- a pass over a tile ---- */

/* Pixels from `x`, `y` of the image on, dx and dy apart. */
struct lattice {
    unsigned x, y, dx, dy;
};

static void fill_block(struct loop *loop, struct tia_tile tile, unsigned x, unsigned y)
{
    unsigned size = block_of(loop->pass), right = at_most(x + size, (unsigned)tile.x + tile.width),
             bottom = at_most(y + size, (unsigned)tile.y + tile.height);
    tia_rgb565 colour = *canvas_at(loop, x, y);

    for (unsigned row = y; row < bottom; row++)
        for (unsigned column = x; column < right; column++)
            *canvas_at(loop, column, row) = colour;
}

static int draw_pixels(struct loop *loop, struct tia_tile pixels)
{
    struct tia_surface surface = {canvas_at(loop, pixels.x, pixels.y), sizeof(tia_rgb565),
                                  (ptrdiff_t)(loop->mode.width * sizeof(tia_rgb565))};
    const struct tia_options *options = &loop->viewer->options;

    return loop->traced > loop->pass ? loop->core->light(loop->view, loop->hits, pixels, &surface, options)
                                     : loop->core->render(loop->view, loop->hits, pixels, &surface, options);
}

/* Neighbours in a row are drawn together. */
static int draw_lattice(struct loop *loop, struct tia_tile tile, struct lattice at)
{
    unsigned right = (unsigned)tile.x + tile.width, bottom = (unsigned)tile.y + tile.height;
    int status = TIA_OK;

    for (unsigned y = at.y; y < bottom; y += at.dy) {
        unsigned run = at.dx > 1 ? 1 : tile.width;
        for (unsigned x = at.x; x < right && !status; x += run > 1 ? run : at.dx) {
            status = draw_pixels(loop, (struct tia_tile){(uint16_t)x, (uint16_t)y, (uint16_t)run, 1});
            if (run == 1 && !status)
                fill_block(loop, tile, x, y);
        }
    }
    return status;
}

/* After the first pass: between the pixels of each row of the passes before, then the rows in between. */
static int refine_tile(struct loop *loop, struct tia_tile tile)
{
    unsigned x = tile.x, y = tile.y, size = block_of(loop->pass);
    int status;

    if (loop->pass == 0)
        return draw_lattice(loop, tile, (struct lattice){x, y, size, size});
    status = draw_lattice(loop, tile, (struct lattice){x + size, y, 2 * size, 2 * size});
    return status ? status : draw_lattice(loop, tile, (struct lattice){x, y + size, size, 2 * size});
}

/* A tile that is not reached before the picture is due stays for the next round. */
static void pass_job(void *arg, unsigned index)
{
    struct loop *loop = arg;
    int status = TIA_OK;

    if (loop->passes[index] <= loop->pass && viewer_now(loop) < loop->show_us) {
        status = tia_viewer_watch(loop);
        if (!status)
            status = refine_tile(loop, tia_viewer_tile(loop, index));
        if (!status)
            loop->passes[index]++;
    }
    loop->status[index] = (int8_t)status;
}

/* ---- the picture so far ---- */

/* Whether the pass being drawn is not over. */
static bool is_left(const struct loop *loop)
{
    bool left = false;

    for (uint32_t i = 0; i < loop->tiles; i++)
        left = left || loop->passes[i] <= loop->pass;
    return left;
}

/* How much of the frame is drawn, in 2^-16; so far at least a pixel of each block. */
static uint32_t share_done(const struct loop *loop)
{
    uint64_t sum = 0;

    for (uint32_t i = 0; i < loop->tiles; i++)
        sum += loop->passes[i] ? UINT32_C(65536) >> 2 * (VIEWER_PASSES - loop->passes[i]) : 0;
    return (uint32_t)(sum / loop->tiles);
}

/* A line at the lower edge, as long as what is done of the frame. */
static void draw_line(const struct loop *loop, struct tia_tile tile, const struct tia_surface *surface)
{
    unsigned height = loop->mode.height, thick = height / 400 + 1, bottom = (unsigned)tile.y + tile.height;
    unsigned end = (unsigned)((uint64_t)loop->mode.width * loop->line >> 16);

    for (unsigned y = tile.y; y < bottom; y++)
        for (unsigned x = tile.x; y + thick >= height && x < (unsigned)tile.x + tile.width; x++) {
            char *row = (char *)surface->pixels + (ptrdiff_t)(y - tile.y) * surface->pitch;
            *(tia_rgb565 *)(void *)(row + (ptrdiff_t)(x - tile.x) * surface->step) = x < end ? 0xffff : 0;
        }
}

static int copy_tile(struct loop *loop, struct tia_tile tile)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_surface surface;
    int status = v->display->acquire(v->display_ctx, tile, &surface);

    for (unsigned y = 0; !status && y < tile.height; y++) {
        const tia_rgb565 *from = canvas_at(loop, tile.x, tile.y + y);
        char *row = (char *)surface.pixels + (ptrdiff_t)y * surface.pitch;
        for (unsigned x = 0; x < tile.width; x++)
            *(tia_rgb565 *)(void *)(row + (ptrdiff_t)x * surface.step) = from[x];
    }
    if (!status && loop->line)
        draw_line(loop, tile, &surface);
    return status ? status : v->display->submit(v->display_ctx, tile);
}

static void copy_job(void *arg, unsigned index)
{
    struct loop *loop = arg;
    loop->status[index] = (int8_t)copy_tile(loop, tia_viewer_tile(loop, index));
}

/* Another screen or size ends the frame. */
static int same_display(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_mode mode;
    int status = v->display->mode(v->display_ctx, &mode);

    if (status == TIA_HIDDEN || (!status && !tia_viewer_same_mode(&mode, &loop->mode)))
        return VIEWER_OUTDATED;
    return status;
}

static int show_so_far(struct loop *loop, struct tia_frame *frame)
{
    const struct tia_viewer *v = loop->viewer;
    uint64_t now = viewer_now(loop), spent = now - loop->begun_us - loop->showing_us;
    uint32_t done = share_done(loop);
    int status = same_display(loop);

    frame->draw_us = spent;
    frame->block = (uint16_t)(block_of(loop->pass) << is_left(loop));
    frame->done = (uint16_t)done;
    frame->left_us = (spent << 16) / (done + !done) - spent;
    loop->line = spent + frame->left_us >= WORTH_LINE_US ? done : 0;
    if (!status)
        status = tia_viewer_run_tiles(loop, copy_job);
    loop->line = 0;
    if (!status && v->frame_drawn)
        v->frame_drawn(v->frame_ctx, frame);
    if (!status)
        status = v->display->present(v->display_ctx);
    loop->shown_us = viewer_now(loop);
    loop->showing_us += loop->shown_us - now;
    frame->key_us = loop->key_us && !loop->answered ? loop->shown_us - loop->key_us : 0;
    loop->answered = true;
    return !status && v->frame_done ? v->frame_done(v->frame_ctx, frame) : status;
}

/* ---- the frame ---- */

/* A job that was told to stop may not have heard it when it asked again, since another one was asking. */
static int drawn(const struct loop *loop, int status)
{
    if (status >= 0 && !loop->ends && (loop->gives_up || loop->queued == VIEWER_QUEUE))
        return VIEWER_OUTDATED;
    return status;
}

static int draw_pass(struct loop *loop, struct tia_frame *frame)
{
    bool left;
    int status;

    do {
        loop->show_us = loop->pass ? loop->shown_us + REFINE_US : UINT64_MAX;
        status = drawn(loop, tia_viewer_run_tiles(loop, pass_job));
        left = is_left(loop);
        if (!status && left)
            status = show_so_far(loop, frame);
    } while (!status && left);
    if (!status && loop->traced == loop->pass)
        loop->traced++;
    return status;
}

/* For frames that someone waits for and that can be drawn pixel by pixel. */
uint64_t tia_viewer_canvas_size(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    bool refines =
        v->clock && v->input && !v->frame_limit && loop->core->draws_by_pixel && loop->core->draws_by_pixel(loop->base);

    return refines ? (uint64_t)loop->mode.width * loop->mode.height * sizeof(tia_rgb565) : 0;
}

bool tia_viewer_refines(const struct loop *loop)
{
    return loop->canvas && (!loop->last_us || loop->last_us > PERIOD_US * 3 / 4);
}

int tia_viewer_draw_passes(struct loop *loop, struct tia_frame *frame)
{
    uint64_t wait = loop->plays ? REFINE_US : PERIOD_US;
    struct tia_frame coarse = *frame;
    int status = TIA_OK;

    loop->refining = true;
    loop->shown_us = loop->begun_us;
    for (uint32_t i = 0; i < loop->tiles; i++)
        loop->passes[i] = 0;
    for (loop->pass = 0; !status && loop->pass < VIEWER_PASSES; loop->pass++) {
        status = draw_pass(loop, &coarse);
        if (!status && loop->pass + 1 < VIEWER_PASSES && viewer_now(loop) >= loop->shown_us + wait)
            status = show_so_far(loop, &coarse);
    }
    loop->refining = false;
    frame->draw_us = viewer_now(loop) - loop->begun_us - loop->showing_us;
    return status ? status : tia_viewer_run_tiles(loop, copy_job);
}
