/* refine_pass.c - draws a pass of refine.c in a tile: pixels of a grid, each as a block; or more samples of each pixel;
 * or whole rows. */
#include "loop.h"

#define ROW_PASSES 2u
#define SUMS_MAX (UINT32_C(1) << 23) /* largest number of pixels with sums: 192 MiB; 3840x2160 is just below */

unsigned tia_viewer_block(unsigned pass)
{
    return pass < VIEWER_PASSES ? VIEWER_FIRST_BLOCK >> pass : 1;
}

bool tia_viewer_by_rows(const struct loop *loop)
{
    return !loop->core->draws_by_pixel(loop->core, loop->base);
}

/* True if there is an estimator, and it supports the core's views. */
static bool samples_apart(const struct loop *loop)
{
    const struct tia_estimator *estimator = loop->viewer->estimator;
    const char *a = estimator ? estimator->name : NULL, *b = loop->core->name;

    while (a && b && *a && *a == *b)
        a++, b++;
    return a && b && *a == *b;
}

uint64_t tia_viewer_sums_size(const struct loop *loop)
{
    uint64_t pixels = (uint64_t)loop->mode.width * loop->mode.height;
    const struct tia_integration *how = &loop->base->integration;

    if (!samples_apart(loop) || how->integrator == TIA_WHITTED || how->spp == 1 || pixels > SUMS_MAX)
        return 0;
    return pixels * sizeof(struct tia_sum);
}

uint32_t tia_viewer_samples(const struct loop *loop, unsigned passes)
{
    unsigned doubled = passes > VIEWER_PASSES ? passes - VIEWER_PASSES : 0;
    uint32_t all = viewer_spp(loop);

    if (!passes)
        return 0;
    return doubled < 31 && UINT32_C(1) << doubled < all ? UINT32_C(1) << doubled : all;
}

unsigned tia_viewer_passes(const struct loop *loop)
{
    unsigned passes = VIEWER_PASSES;

    if (tia_viewer_by_rows(loop))
        return ROW_PASSES;
    while (tia_viewer_samples(loop, passes) < viewer_spp(loop))
        passes++;
    return passes;
}

uint32_t tia_viewer_share(const struct loop *loop, unsigned passes)
{
    unsigned left = passes < VIEWER_PASSES ? VIEWER_PASSES - passes : 0;

    if (!passes || tia_viewer_by_rows(loop))
        return passes < ROW_PASSES ? passes * (UINT32_C(65536) / VIEWER_FIRST_BLOCK) : 65536;
    return (uint32_t)((UINT64_C(65536) >> 2 * left) * tia_viewer_samples(loop, passes) / viewer_spp(loop));
}

static unsigned at_most(unsigned value, unsigned limit)
{
    return value < limit ? value : limit;
}

/* ---- pixels ---- */

/* Returns the part of the canvas for these pixels. */
static struct tia_surface surface_of(const struct loop *loop, struct tia_tile pixels)
{
    return (struct tia_surface){.pixels = viewer_canvas_at(loop, pixels.x, pixels.y),
                                .step = sizeof(tia_rgb565),
                                .pitch = (ptrdiff_t)(loop->mode.width * sizeof(tia_rgb565))};
}

/* Draws the samples that this pass adds to the pixels of a row. */
static int draw_samples(struct loop *loop, struct tia_tile row)
{
    const struct tia_viewer *v = loop->viewer;
    uint32_t end = tia_viewer_samples(loop, loop->pass + 1);
    uint32_t first = loop->pass < VIEWER_PASSES ? 0 : tia_viewer_samples(loop, loop->pass);
    struct tia_sum *sums = loop->sums + (size_t)row.y * loop->mode.width + row.x;
    struct tia_surface surface = surface_of(loop, row);
    int status;

    for (unsigned i = 0; !first && i < row.width; i++)
        sums[i] = (struct tia_sum){{0, 0, 0}};
    status = v->estimator->sample(loop->view, row, first, end, sums, row.width);
    return status ? status : v->estimator->show(loop->view, row, sums, end, &surface, v->dither);
}

static int draw_pixels(struct loop *loop, struct tia_tile pixels)
{
    struct tia_surface surface = surface_of(loop, pixels);
    const struct tia_options options = {.dither = loop->viewer->dither};

    return loop->traced > loop->pass ? tia_view_light(loop->view, loop->hits, pixels, &surface, &options)
                                     : tia_view_draw(loop->view, loop->hits, pixels, &surface, &options);
}

/* ---- blocks ---- */

/* A grid of pixels that begins at (x, y) of the image, with steps of dx and dy; `size` is that of the blocks that they
 * represent. */
struct pixel_grid {
    unsigned x, y, dx, dy, size;
};

static void fill_block(struct loop *loop, struct tia_tile tile, struct pixel_grid at)
{
    unsigned right = at_most(at.x + at.size, (unsigned)tile.x + tile.width),
             bottom = at_most(at.y + at.size, (unsigned)tile.y + tile.height);
    tia_rgb565 colour = *viewer_canvas_at(loop, at.x, at.y);

    for (unsigned row = at.y; row < bottom; row++)
        for (unsigned column = at.x; column < right; column++)
            *viewer_canvas_at(loop, column, row) = colour;
}

/* Returns the number of pixels of a row, beginning with `at`, that are drawn together; 0: the pixels already drawn
 * suffice for the eye there. */
static unsigned run_at(const struct loop *loop, struct pixel_grid at, unsigned right)
{
    unsigned run = 0;

    right = at.dx > 1 ? at.x + 1 : right;
    if (!loop->gazes)
        return right - at.x;
    while (at.x + run < right && tia_acuity_block(&loop->acuity, at.x + run, at.y) <= at.size)
        run++;
    return run;
}

static int draw_row(struct loop *loop, struct tia_tile tile, struct pixel_grid at, uint32_t *drawn)
{
    unsigned right = (unsigned)tile.x + tile.width, run;
    int status = TIA_OK;

    for (; at.x < right && !status; at.x += run > 1 ? run : at.dx) {
        struct tia_tile pixels = {(uint16_t)at.x, (uint16_t)at.y, 0, 1};
        run = run_at(loop, at, right);
        pixels.width = (uint16_t)run;
        if (run)
            status = loop->sums ? draw_samples(loop, pixels) : draw_pixels(loop, pixels);
        if (run == 1 && !status)
            fill_block(loop, tile, at);
        *drawn += run;
    }
    return status;
}

static int draw_grid(struct loop *loop, struct tia_tile tile, struct pixel_grid at, uint32_t *drawn)
{
    unsigned bottom = (unsigned)tile.y + tile.height;
    int status = TIA_OK;

    for (; at.y < bottom && !status; at.y += at.dy)
        status = draw_row(loop, tile, at, drawn);
    return status;
}

/* Draws the blocks of a size: all blocks of the first size; of other sizes, those between the drawn blocks of each row,
 * then those of the rows in between. */
static int draw_blocks(struct loop *loop, struct tia_tile tile, unsigned size, uint32_t *drawn)
{
    unsigned x = tile.x, y = tile.y;
    int status;

    if (size == VIEWER_FIRST_BLOCK)
        return draw_grid(loop, tile, (struct pixel_grid){x, y, size, size, size}, drawn);
    status = draw_grid(loop, tile, (struct pixel_grid){x + size, y, 2 * size, 2 * size, size}, drawn);
    return status ? status : draw_grid(loop, tile, (struct pixel_grid){x, y + size, size, 2 * size, size}, drawn);
}

/* Adds this pass's samples to the drawn pixels: all pixels or, with a gaze, those that the acuity requires. */
static int draw_more(struct loop *loop, struct tia_tile tile)
{
    uint32_t counted = 0;
    int status = TIA_OK;

    if (!loop->gazes)
        return draw_grid(loop, tile, (struct pixel_grid){tile.x, tile.y, 1, 1, 1}, &counted);
    for (unsigned size = VIEWER_FIRST_BLOCK; size && !status; size /= 2)
        status = draw_blocks(loop, tile, size, &counted);
    return status;
}

/* ---- rows ---- */

static void repeat_row(struct loop *loop, struct tia_tile row, unsigned bottom)
{
    for (unsigned y = row.y + 1u; y < bottom; y++)
        for (unsigned x = 0; x < row.width; x++)
            *viewer_canvas_at(loop, row.x + x, y) = *viewer_canvas_at(loop, row.x + x, row.y);
}

/* Draws rows: in the first pass every 16th row, repeated below it; in the second pass all rows between two of these at
 * once. */
static int draw_rows(struct loop *loop, struct tia_tile tile, uint32_t *drawn)
{
    unsigned bottom = (unsigned)tile.y + tile.height, skipped = loop->pass ? 1 : 0;
    int status = TIA_OK;

    for (unsigned y = tile.y; y + skipped < bottom && !status; y += VIEWER_FIRST_BLOCK) {
        unsigned end = at_most(y + VIEWER_FIRST_BLOCK, bottom), rows = loop->pass ? end - y - skipped : 1;
        struct tia_tile pixels = {tile.x, (uint16_t)(y + skipped), tile.width, (uint16_t)rows};

        status = draw_pixels(loop, pixels);
        if (!loop->pass && !status)
            repeat_row(loop, pixels, end);
        *drawn += rows * tile.width;
    }
    return status;
}

int tia_viewer_refine_tile(struct loop *loop, struct tia_tile tile, uint32_t *drawn)
{
    if (tia_viewer_by_rows(loop))
        return draw_rows(loop, tile, drawn);
    if (loop->pass >= VIEWER_PASSES)
        return draw_more(loop, tile);
    return draw_blocks(loop, tile, tia_viewer_block(loop->pass), drawn);
}
