/* sure_tile.c - draws a tile block by block: certain pixels become RGB565, undecided samples go to the fixed-point
 * path. */
#include "sure_tile.h"

#include <string.h>

#include "bounds.h"
#include "render/core/dither.h"
#include "simd/simd.h"

_Static_assert(SURE_STRIP >= TIA_SIZE_MAX, "a row fits");

static size_t room(const struct tia_simd *simd)
{
    return simd_room(sizeof(struct sure_drawing), simd->sure->block_memory);
}

/* Returns the first number from `i` on whose flag is set, or `count`. Flags are read in words of eight. */
static int next_set(const bool *flag, int i, int count)
{
    uint64_t word;

    for (; i < count; i++) {
        if (flag[i])
            return i;
        for (; i + 8 < count; i += 8) {
            memcpy(&word, flag + i + 1, sizeof word);
            if (word)
                break;
        }
    }
    return count;
}

/* Replaces undecided samples by fixed-point ones, each of which may take a while. The error of these is only that of
 * the conversion. */
static void replace_samples(struct sure_block *b)
{
    int count = b->width * b->height * b->samples;
    num_length colour[3];

    for (int i = next_set(b->unsure, 0, count); i < count; i = next_set(b->unsure, i + 1, count)) {
        struct sure_place p = sure_place_of(b, i / b->samples);
        if (cancelled(&b->cancel, CANCEL_INTERVAL))
            return;
        tia_sure_sample(b->scene->view, b->x + p.x, b->y + p.y, i % b->samples, colour);
        for (int c = 0; c < 3; c++)
            b->colour[c][i] = sure_length(num_length_clamp(colour[c], 0, NUM_LENGTH_ONE));
        b->error[i] = BOUND(EXACT_SAMPLE);
    }
}

static void trace_samples(struct sure_drawing *d, void *kernels_room)
{
    d->kernels->trace(&d->block, kernels_room);
    tia_sure_add_rests(&d->block);
    replace_samples(&d->block);
}

/* Computes all samples of a pixel by the fixed-point path; returns the pixel. */
static tia_rgb565 exact_pixel(struct sure_drawing *d, int x, int y, num_u threshold)
{
    struct sure_block *b = &d->block;
    num_length mean[3] = {0, 0, 0}, colour[3];

    for (int i = 0; i < b->samples && !cancelled(&b->cancel, CANCEL_INTERVAL); i++) {
        tia_sure_sample(b->scene->view, x, y, i, colour);
        for (int c = 0; c < 3; c++)
            mean[c] += num_length_clamp(colour[c], 0, NUM_LENGTH_ONE) / (num_length)b->samples;
    }
    return (tia_rgb565)(num_levels(mean[0], 31, threshold) << 11 | num_levels(mean[1], 63, threshold) << 5 |
                        num_levels(mean[2], 31, threshold));
}

/* Returns a number for all that the order of the thresholds depends on; never 0. */
static uint32_t layout_of(const struct sure_block *b)
{
    return (uint32_t)b->width << 16 | (uint32_t)b->height << 8 | (uint32_t)b->rows << 6 | (uint32_t)(b->x & 7) << 3 |
           (uint32_t)(b->y & 7);
}

/* Sets the block's thresholds, unless they are those of the last block. */
static void set_thresholds(struct sure_drawing *d)
{
    struct sure_block *b = &d->block;
    num_u threshold[8][8];

    if (d->layout == layout_of(b))
        return;
    d->layout = layout_of(b);
    for (int y = 0; y < 8; y++)
        dither_thresholds(d->dither, y, threshold[y]);
    for (int i = 0; i < b->width * b->height; i++) {
        struct sure_place p = sure_place_of(b, i);
        b->threshold[i] = (double)threshold[(b->y + p.y) & 7][(b->x + p.x) & 7] * SURE_Q30;
    }
}

/* Copies the pixels, whose rows are `pitch` pixels apart. */
static void copy_pixels(const struct sure_block *b, tia_rgb565 *out, int pitch)
{
    const tia_rgb565 *from = b->pixels;

    for (int y = 0; y < b->height; y += b->rows, out += b->rows * pitch)
        for (int x = 0; x < b->width; x += b->across)
            for (int row = 0; row < b->rows; row++, from += b->across)
                memcpy(out + row * pitch + x, from, (size_t)b->across * sizeof *from);
}

static void draw_block(struct sure_drawing *d, tia_rgb565 *out, int pitch, void *kernels_room)
{
    struct sure_block *b = &d->block;
    int count = b->width * b->height;

    d->trace(d, kernels_room);
    set_thresholds(d);
    d->kernels->set_pixels(b);
    copy_pixels(b, out, pitch);
    for (int i = next_set(b->open, 0, count); i < count; i = next_set(b->open, i + 1, count)) {
        struct sure_place p = sure_place_of(b, i);
        num_u threshold[8];
        dither_thresholds(d->dither, b->y + p.y, threshold);
        out[p.y * pitch + p.x] = d->exact_pixel(d, b->x + p.x, b->y + p.y, threshold[(b->x + p.x) & 7]);
    }
}

static void draw_strip(struct sure_drawing *d, struct tia_tile strip, void *kernels_room)
{
    struct sure_block *b = &d->block;
    int width = SURE_SLOTS / b->samples / strip.height, left = strip.width;

    b->y = strip.y;
    b->height = strip.height;
    for (int x = 0; x < (int)strip.width && !d->block.cancel.stopped; x += width, left -= width) {
        b->x = strip.x + x;
        b->width = left < width ? left : width;
        draw_block(d, d->pixels + x, strip.width, kernels_room);
    }
}

static void write_strip(struct tia_tile strip, const tia_rgb565 *pixels, char *out, const struct tia_surface *surface)
{
    bool plain = surface->step == sizeof *pixels && !surface_swaps(surface);

    for (int y = 0; y < strip.height && plain; y++, out += surface->pitch, pixels += strip.width)
        memcpy(out, pixels, strip.width * sizeof *pixels);
    for (int y = 0; y < strip.height && !plain; y++, out += surface->pitch)
        for (int x = 0; x < strip.width; x++)
            *(tia_rgb565 *)(void *)(out + x * surface->step) = surface_order(surface, *pixels++);
}

void tia_sure_draw(struct sure_drawing *d, const struct tia_view *view, struct tia_tile tile,
                   const struct tia_surface *surface, const struct tia_options *options, void *kernels_room)
{
    const struct sure_scene *s = tia_sure_scene(view);
    int side = s->camera.side, most = SURE_SIDE / side;
    int rows = SURE_STRIP / tile.width < most ? SURE_STRIP / tile.width : most;

    d->kernels = view->simd->sure;
    d->dither = options->dither;
    d->block.scene = s;
    d->block.cancel = view_cancel(view);
    d->block.samples = side * side;
    d->layout = 0;
    for (int y = 0; y < (int)tile.height && !d->block.cancel.stopped; y += rows) {
        int left = tile.height - y;
        struct tia_tile strip = {tile.x, (uint16_t)(tile.y + y), tile.width, (uint16_t)(left < rows ? left : rows)};
        draw_strip(d, strip, kernels_room);
        write_strip(strip, d->pixels, (char *)surface->pixels + y * surface->pitch, surface);
    }
}

static void light(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                  const struct tia_options *options, void *memory)
{
    const struct sure_scene *s = tia_sure_scene(view);
    struct sure_drawing *d = memory;

    if (options_debug(options).path_hash || options_debug(options).lit || s->occluded || s->fixed_only) {
        tia_simd_light_plain(view, tile, surface, options);
        return;
    }
    d->trace = trace_samples;
    d->exact_pixel = exact_pixel;
    d->block.seen = NULL;
    tia_sure_draw(d, view, tile, surface, options, simd_kernels_room(d, sizeof *d));
}

/* True if the SIMD kernels draw the view. They need the boxes of a hierarchy, and draw no light fields, whose
 * neighbouring pixels have different eyes, and no filtered textures. */
static bool draws(const struct tia_view *view)
{
    const struct ray_view *rays = view->prepared;

    return view->scene->bvh && !view->scene->field && !rays->filtered;
}

const struct simd_renderer tia_simd_rays = {tia_sure_size, draws, tia_sure_prepare, tia_sure_set_lights, room, light,
                                            NULL,          NULL};
