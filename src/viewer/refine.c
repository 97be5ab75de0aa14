/* refine.c - a frame that takes long, coarse to fine: every 16th pixel of every 16th row first, each as a block, then
 * the pixels in between, until there are no blocks left. Each pixel is drawn once, so in the end they are those of a
 * frame drawn at once. Blocks do not cross tiles, which may be drawn by several threads.
 *
 * The picture so far is in loop->canvas: a display forgets what it was given before. */
#include "loop.h"

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

/* Whether somebody waits for frames. */
static bool is_watched(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    return v->clock && v->input && !v->frame_limit;
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

/* How many pixels from (x, y) on are drawn together: neighbours in a row are. 0: the pixels drawn already suffice for
 * the eye there. */
static unsigned run_at(const struct loop *loop, struct lattice at, unsigned right)
{
    unsigned run = 0;

    right = at.dx > 1 ? at.x + 1 : right;
    if (!loop->gazes)
        return right - at.x;
    while (at.x + run < right && tia_acuity_block(&loop->acuity, at.x + run, at.y) <= block_of(loop->pass))
        run++;
    return run;
}

static int draw_row(struct loop *loop, struct tia_tile tile, struct lattice at, uint32_t *drawn)
{
    unsigned right = (unsigned)tile.x + tile.width, run;
    int status = TIA_OK;

    for (; at.x < right && !status; at.x += run > 1 ? run : at.dx) {
        run = run_at(loop, at, right);
        if (run)
            status = draw_pixels(loop, (struct tia_tile){(uint16_t)at.x, (uint16_t)at.y, (uint16_t)run, 1});
        if (run == 1 && !status)
            fill_block(loop, tile, at.x, at.y);
        *drawn += run;
    }
    return status;
}

static int draw_lattice(struct loop *loop, struct tia_tile tile, struct lattice at, uint32_t *drawn)
{
    unsigned bottom = (unsigned)tile.y + tile.height;
    int status = TIA_OK;

    for (; at.y < bottom && !status; at.y += at.dy)
        status = draw_row(loop, tile, at, drawn);
    return status;
}

/* After the first pass: between the pixels of each row of the passes before, then the rows in between. */
static int refine_tile(struct loop *loop, struct tia_tile tile, uint32_t *drawn)
{
    unsigned x = tile.x, y = tile.y, size = block_of(loop->pass);
    int status;

    if (loop->pass == 0)
        return draw_lattice(loop, tile, (struct lattice){x, y, size, size}, drawn);
    status = draw_lattice(loop, tile, (struct lattice){x + size, y, 2 * size, 2 * size}, drawn);
    return status ? status : draw_lattice(loop, tile, (struct lattice){x, y + size, size, 2 * size}, drawn);
}

/* A tile that is not reached before the picture is due stays for the next round. */
static void pass_job(void *arg, unsigned index)
{
    struct loop *loop = arg;
    int status = TIA_OK;

    if (loop->passes[index] <= loop->pass && viewer_now(loop) < loop->show_us) {
        status = tia_viewer_watch(loop);
        if (!status)
            status = refine_tile(loop, tia_viewer_tile(loop, index), &loop->drawn[index]);
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

/* The share of the frame that is drawn, in 2^-16; at this point at least a pixel of each block. */
static uint32_t share_done(const struct loop *loop)
{
    uint64_t sum = 0;

    for (uint32_t i = 0; i < loop->tiles; i++)
        sum += loop->passes[i] ? UINT32_C(65536) >> 2 * (VIEWER_PASSES - loop->passes[i]) : 0;
    return (uint32_t)(sum / loop->tiles);
}

static uint32_t sum_drawn(const struct loop *loop)
{
    uint32_t sum = 0;

    for (uint32_t i = 0; i < loop->tiles; i++)
        sum += loop->drawn[i];
    return sum;
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
    frame->pixels = sum_drawn(loop);
    frame->left_us = (spent << 16) / (done + !done) - spent;
    loop->line = spent + frame->left_us >= WORTH_LINE_US ? done : 0;
    if (!status)
        status = tia_viewer_run_tiles(loop, copy_job);
    loop->line = 0;
    viewer_tell(loop);
    if (!status && v->frame_drawn)
        v->frame_drawn(v->frame_ctx, frame);
    if (!status)
        status = v->display->present(v->display_ctx);
    loop->shown_us = viewer_now(loop);
    loop->show_cost_us = loop->shown_us - now;
    loop->showing_us += loop->show_cost_us;
    frame->key_us = loop->key_us && !loop->answered ? loop->shown_us - loop->key_us : 0;
    loop->answered = true;
    return !status && v->frame_done ? v->frame_done(v->frame_ctx, frame) : status;
}

/* ---- the frame ---- */

/* A job asked to stop may have missed it, since another job was calling `stop` at that moment. */
static int drawn(const struct loop *loop, int status)
{
    if (status >= 0 && !loop->ends && (loop->gives_up || loop->queued == VIEWER_QUEUE))
        return VIEWER_OUTDATED;
    return status;
}

static int draw_pass(struct loop *loop, struct tia_frame *frame)
{
    uint64_t begun = viewer_now(loop), showing = loop->showing_us;
    uint32_t drawn_before = sum_drawn(loop);
    bool left;
    int status;

    do {
        loop->show_us = loop->pass && is_watched(loop) ? loop->shown_us + REFINE_US : UINT64_MAX;
        status = drawn(loop, tia_viewer_run_tiles(loop, pass_job));
        left = is_left(loop);
        if (!status && left)
            status = show_so_far(loop, frame);
    } while (!status && left);
    if (!status && loop->traced == loop->pass)
        loop->traced++;
    if (!status)
        tia_viewer_learn(loop, sum_drawn(loop) - drawn_before, viewer_now(loop) - begun - (loop->showing_us - showing));
    return status;
}

/* For frames that someone waits for, or looks at in one place, and that can be drawn pixel by pixel. */
uint64_t tia_viewer_canvas_size(const struct loop *loop)
{
    bool refines =
        (is_watched(loop) || loop->gazes) && loop->core->draws_by_pixel && loop->core->draws_by_pixel(loop->base);

    return refines ? (uint64_t)loop->mode.width * loop->mode.height * sizeof(tia_rgb565) : 0;
}

bool tia_viewer_refines(const struct loop *loop)
{
    return loop->canvas && (loop->gazes || !loop->last_us || loop->last_us > tia_viewer_period_us(loop) * 3 / 4);
}

int tia_viewer_copy(struct loop *loop)
{
    return tia_viewer_run_tiles(loop, copy_job);
}

static void begin_passes(struct loop *loop)
{
    loop->refining = true;
    loop->complete = loop->unfinished = false;
    loop->shown_us = loop->begun_us;
    for (uint32_t i = 0; i < loop->tiles; i++) {
        loop->passes[i] = 0;
        loop->drawn[i] = 0;
    }
}

/* When the pass is done, or before it at a pace: whether to show what there is. The first picture at a pace is as fine
 * as there is time for. */
static bool is_due(const struct loop *loop)
{
    uint64_t wait = loop->plays ? REFINE_US : tia_viewer_period_us(loop);

    if (!is_watched(loop) || loop->pass + 1 == VIEWER_PASSES)
        return false;
    return viewer_now(loop) >= loop->shown_us + wait && (!loop->viewer->pace[0] || loop->answered);
}

/* Draws the passes that there is time for; all of them, unless something moves. */
static int draw_in_time(struct loop *loop, struct tia_frame *coarse)
{
    bool moving = tia_viewer_is_moving(loop), paced = is_watched(loop) && loop->viewer->pace[0];
    int status = TIA_OK;

    for (loop->pass = 0; !status && loop->pass < VIEWER_PASSES; loop->pass++) {
        if (paced && loop->pass && !loop->answered && !tia_viewer_has_time(loop)) {
            loop->unfinished = moving;
            if (moving)
                return TIA_OK;
            loop->pass--;
            status = show_so_far(loop, coarse);
            loop->pass++;
        }
        if (!status)
            status = draw_pass(loop, coarse);
        if (!status && is_due(loop))
            status = show_so_far(loop, coarse);
    }
    return status;
}

int tia_viewer_draw_passes(struct loop *loop, struct tia_frame *frame)
{
    struct tia_frame coarse = *frame;
    int status;

    begin_passes(loop);
    status = draw_in_time(loop, &coarse);
    loop->refining = false;
    if (!status && !loop->unfinished)
        status = tia_viewer_fill(loop);
    loop->complete = !status && !loop->unfinished;
    frame->block = (uint16_t)(loop->unfinished ? block_of(loop->pass - 1) : 1);
    frame->pixels = sum_drawn(loop);
    frame->draw_us = viewer_now(loop) - loop->begun_us - loop->showing_us;
    return status ? status : tia_viewer_copy(loop);
}
