/* refine.c - draws a slow frame coarse to fine: first every 16th pixel of every 16th row, each as a block, then the
 * pixels in between, until there are no blocks left. The pixels of sampled pictures have one sample at first; further
 * passes double the number, up to that of the scene. Each pixel or sample is drawn once, so the finished frame is the
 * same as one drawn at once. The rasteriser's frames are drawn in rows, see refine_pass.c. Blocks do not cross tiles,
 * which may be drawn by several threads.
 *
 * The picture so far is in loop->canvas: a display does not keep earlier pictures. */
#include "loop.h"
#include "math/align.h"
#include "math/tile.h"

/* Time between two pictures of a long pass, or of a playing scene. Shorter frames in rows are not refined. */
#define REFINE_US 250000
#define WORTH_LINE_US 1000000 /* a shorter frame has no progress line */

/* True if a user waits for frames. */
static bool is_watched(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    return v->ports.clock && v->ports.input && !v->pacing.frame_limit;
}

/* ---- a pass ---- */

/* Draws the current pass's part of a tile. A tile that is not reached before the picture is due remains for the next
 * round. */
static void pass_job(void *arg, unsigned index)
{
    struct loop *loop = arg;
    unsigned tile = tia_viewer_in_order(loop, index);
    struct tile_work *work = &loop->work[tile];
    uint64_t begun = viewer_now(loop);
    uint32_t pixels = 0;
    int status = TIA_OK;

    if (loop->passes[tile] <= loop->pass && begun < loop->show_us) {
        status = tia_viewer_watch(loop);
        if (!status)
            status = tia_viewer_refine_tile(loop, tia_viewer_tile(loop, tile), &pixels);
        if (!status)
            loop->passes[tile]++;
        work->drawn += pixels;
        work->us += viewer_now(loop) - begun;
        if (loop->pass + 1 < VIEWER_PASSES)
            work->alone_us = work->us;
    }
    loop->status[index] = (int8_t)status;
}

/* ---- the picture so far ---- */

/* True if the pass being drawn is not finished. */
static bool is_left(const struct loop *loop)
{
    bool left = false;

    for (uint32_t i = 0; i < loop->tiles; i++)
        left = left || loop->passes[i] <= loop->pass;
    return left;
}

/* Returns the share of the frame's samples that is drawn, in units of 2^-16. */
static uint32_t share_done(const struct loop *loop)
{
    uint64_t sum = 0;

    for (uint32_t i = 0; i < loop->tiles; i++)
        sum += tia_viewer_share(loop, loop->passes[i]);
    return (uint32_t)(sum / loop->tiles);
}

static uint32_t sum_drawn(const struct loop *loop)
{
    uint32_t sum = 0;

    for (uint32_t i = 0; i < loop->tiles; i++)
        sum += (uint32_t)loop->work[i].drawn;
    return sum;
}

/* Draws the progress line at the picture's lower edge; its length is the share of the frame that is done. */
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
    struct tia_surface surface = {.pixels = NULL};
    int status = v->ports.display->acquire(v->ports.display_ctx, tile, &surface);

    for (unsigned y = 0; !status && y < tile.height; y++) {
        const tia_rgb565 *from = viewer_canvas_at(loop, tile.x, tile.y + y);
        char *row = (char *)surface.pixels + (ptrdiff_t)y * surface.pitch;
        for (unsigned x = 0; x < tile.width; x++)
            *(tia_rgb565 *)(void *)(row + (ptrdiff_t)x * surface.step) = surface_order(&surface, from[x]);
    }
    if (!status && loop->line)
        draw_line(loop, tile, &surface);
    return status ? status : v->ports.display->submit(v->ports.display_ctx, tile);
}

static void copy_job(void *arg, unsigned index)
{
    struct loop *loop = arg;
    loop->status[index] = (int8_t)copy_tile(loop, tia_viewer_tile(loop, index));
}

/* Returns VIEWER_OUTDATED if the display is hidden or its mode has changed. */
static int same_display(struct loop *loop)
{
    struct tia_mode mode;
    int status = viewer_mode(loop, &mode);

    if (status == TIA_HIDDEN || (!status && !tia_viewer_same_mode(&mode, &loop->mode)))
        return VIEWER_OUTDATED;
    return status;
}

/* Returns the block size to report for an incomplete picture: at least 2, even if only samples are missing. */
static uint16_t coarse_block(unsigned block)
{
    return (uint16_t)(block > 1 ? block : 2);
}

static int show_so_far(struct loop *loop, struct tia_frame *frame)
{
    const struct tia_viewer *v = loop->viewer;
    uint64_t now = viewer_now(loop), spent = now - loop->begun_us - loop->showing_us;
    uint32_t done = share_done(loop);
    bool left = is_left(loop);
    int status = same_display(loop);

    frame->draw_us = spent;
    frame->block = coarse_block(tia_viewer_block(loop->pass) << left);
    frame->samples = loop->sums ? tia_viewer_samples(loop, loop->pass + !left) : 0;
    frame->done = (uint16_t)done;
    frame->pixels = sum_drawn(loop);
    frame->left_us = tia_viewer_left_us(loop, spent);
    loop->line = spent + frame->left_us >= WORTH_LINE_US ? done : 0;
    if (!status)
        status = tia_viewer_run_tiles(loop, copy_job);
    loop->line = 0;
    tia_viewer_take_quiet(loop);
    viewer_tell(loop);
    if (!status && v->hooks.frame_drawn)
        v->hooks.frame_drawn(v->hooks.ctx, frame);
    if (!status)
        status = tia_viewer_present(loop);
    loop->shown_us = viewer_now(loop);
    loop->show_cost_us = loop->shown_us - now;
    loop->showing_us += loop->show_cost_us;
    frame->key_us = loop->key_us && !loop->answered ? loop->shown_us - loop->key_us : 0;
    loop->answered = loop->answered || !status;
    return !status && v->hooks.frame_done ? v->hooks.frame_done(v->hooks.ctx, frame) : status;
}

/* ---- the frame ---- */

/* Returns the status of a pass: VIEWER_OUTDATED, too, if the frame is to be given up and a job has not noticed, because
 * another job was polling at that moment. */
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
    if (!status && loop->traced == loop->pass && loop->traced < VIEWER_PASSES)
        loop->traced = loop->pass + 1 < tia_viewer_passes(loop) ? loop->pass + 1 : VIEWER_PASSES;
    if (!status)
        tia_viewer_learn(loop, sum_drawn(loop) - drawn_before, viewer_now(loop) - begun - (loop->showing_us - showing));
    return status;
}

/* True if the rasteriser draws the frames, without a gaze or a pace. Such frames are refined by rows, each of which is
 * repeated in the rows below it. Frames of spans are not refined. */
static bool is_rasterised(const struct loop *loop)
{
    return loop->base->shadows != TIA_SHADOWS_TRACED && !loop->gazes && !loop->viewer->pacing.pace[0];
}

static uint64_t pixels_size(const struct loop *loop)
{
    return ALIGN((uint64_t)loop->mode.width * loop->mode.height * sizeof(tia_rgb565));
}

/* Returns the size of the canvas. Only frames that can be drawn pixel by pixel or row by row have a canvas, if a user
 * waits for them or a gaze is set. */
uint64_t tia_viewer_canvas_size(const struct loop *loop, bool sums)
{
    bool refines = (is_watched(loop) || loop->gazes) && loop->core->draws_by_pixel &&
                   (!tia_viewer_by_rows(loop) || is_rasterised(loop));

    return refines ? pixels_size(loop) + (sums ? tia_viewer_sums_size(loop) : 0) : 0;
}

void tia_viewer_set_canvas(struct loop *loop, void *memory, uint64_t size)
{
    uint64_t pixels = pixels_size(loop);

    loop->canvas = size ? (tia_rgb565 *)memory : NULL;
    loop->sums = size > pixels ? (struct tia_sum *)(void *)((char *)memory + pixels) : NULL;
}

/* True if the frame is refined. Frames in rows are refined only if they are slow, since refinement makes the rasteriser
 * process all faces twice. */
bool tia_viewer_refines(const struct loop *loop)
{
    if (!loop->canvas || loop->gazes || !loop->last_us)
        return loop->canvas != NULL;
    if (tia_viewer_by_rows(loop) && !loop->key_us && loop->last_us < REFINE_US)
        return false;
    return loop->last_us > tia_viewer_period_us(loop) * 3 / 4;
}

int tia_viewer_copy(struct loop *loop)
{
    return tia_viewer_run_tiles(loop, copy_job);
}

void tia_viewer_copy_last(struct loop *loop)
{
    if (loop->canvas && loop->answered && !loop->complete && !same_display(loop))
        (void)tia_viewer_copy(loop);
}

static void begin_passes(struct loop *loop)
{
    loop->refining = true;
    loop->complete = loop->unfinished = false;
    loop->shown_us = loop->begun_us;
    tia_viewer_set_order(loop);
    for (uint32_t i = 0; i < loop->tiles; i++) {
        loop->passes[i] = 0;
        loop->work[i] = (struct tile_work){0};
    }
}

/* Returns the minimum time between two intermediate pictures. A pass of blocks takes about four times as long as the
 * one before, but the second pass of rows about fifteen times as long: so rows are shown sooner. */
static uint64_t wait_us(const struct loop *loop)
{
    uint64_t period = tia_viewer_period_us(loop);

    return loop->plays && !loop->key_us ? REFINE_US : tia_viewer_by_rows(loop) ? period / 4 : period;
}

/* True if the picture so far is to be shown after a pass. With a pace, draw_in_time shows the first picture itself, as
 * fine as time allows. */
static bool is_due(const struct loop *loop)
{
    if (!is_watched(loop) || loop->pass + 1 == tia_viewer_passes(loop))
        return false;
    return viewer_now(loop) >= loop->shown_us + wait_us(loop) && (!loop->viewer->pacing.pace[0] || loop->answered);
}

/* Draws the passes for which there is time; all passes, unless the picture moves. */
static int draw_in_time(struct loop *loop, struct tia_frame *frame)
{
    bool moving = tia_viewer_is_moving(loop), paced = is_watched(loop) && loop->viewer->pacing.pace[0];
    unsigned passes = tia_viewer_passes(loop);
    int status = TIA_OK;

    for (loop->pass = 0; !status && loop->pass < passes; loop->pass++) {
        if (paced && loop->pass && !loop->answered && !tia_viewer_has_time(loop)) {
            loop->unfinished = moving;
            if (moving)
                return TIA_OK;
            loop->pass--;
            status = show_so_far(loop, frame);
            loop->pass++;
        }
        if (!status)
            status = draw_pass(loop, frame);
        if (!status && is_due(loop))
            status = show_so_far(loop, frame);
    }
    return status;
}

int tia_viewer_draw_passes(struct loop *loop, struct tia_frame *frame)
{
    int status;

    begin_passes(loop);
    status = draw_in_time(loop, frame);
    loop->refining = false;
    if (!status && !loop->unfinished)
        status = tia_viewer_fill(loop);
    loop->complete = !status && !loop->unfinished;
    frame->done = 0; /* show_so_far may have set these */
    frame->left_us = frame->key_us = 0;
    frame->block = loop->unfinished ? coarse_block(tia_viewer_block(loop->pass - 1)) : 1;
    frame->samples = loop->unfinished && loop->sums ? tia_viewer_samples(loop, loop->pass) : 0;
    frame->pixels = sum_drawn(loop);
    frame->draw_us = viewer_now(loop) - loop->begun_us - loop->showing_us;
    return status ? status : tia_viewer_copy(loop);
}
