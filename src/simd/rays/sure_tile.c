/* sure_tile.c - draws a tile block by block: certain pixels become RGB565, undecided samples go to the fixed-point
 * path. */
#include "bounds.h"
#include "render/core/dither.h"
#include "simd/simd.h"

#define STRIP 16384 /* number of pixels of a strip: as many whole rows as fit are written to the surface at once */

_Static_assert(STRIP >= TIA_SIZE_MAX, "a row fits");

struct drawing {
    const struct sure_kernels *kernels;
    bool dither;
    struct sure_block block;
    tia_rgb565 pixels[STRIP];
};

static size_t room(const struct tia_simd *simd)
{
    return simd_room(sizeof(struct drawing), simd->sure->block_memory);
}

/* Replaces undecided samples by fixed-point ones, each of which may take a while. The error of these is only that of
 * the conversion. */
static void replace_samples(struct sure_block *b)
{
    num_length colour[3];

    for (int i = 0; i < b->width * b->height * b->samples; i++) {
        int pixel = i / b->samples;
        if (!b->unsure[i] || cancelled(&b->cancel, CANCEL_INTERVAL))
            continue;
        tia_sure_sample(b->scene->view, b->x + pixel % b->width, b->y + pixel / b->width, i % b->samples, colour);
        for (int c = 0; c < 3; c++)
            b->colour[c][i] = sure_length(num_length_clamp(colour[c], 0, NUM_LENGTH_ONE));
        b->error[i] = BOUND(EXACT_SAMPLE);
    }
}

/* Computes all samples of a pixel by the fixed-point path; returns the pixel. */
static tia_rgb565 exact_pixel(struct sure_block *b, int x, int y, num_u threshold)
{
    num_length mean[3] = {0, 0, 0}, colour[3];

    for (int i = 0; i < b->samples && !cancelled(&b->cancel, CANCEL_INTERVAL); i++) {
        tia_sure_sample(b->scene->view, x, y, i, colour);
        for (int c = 0; c < 3; c++)
            mean[c] += num_length_clamp(colour[c], 0, NUM_LENGTH_ONE) / (num_length)b->samples;
    }
    return (tia_rgb565)(num_levels(mean[0], 31, threshold) << 11 | num_levels(mean[1], 63, threshold) << 5 |
                        num_levels(mean[2], 31, threshold));
}

static void draw_block(struct drawing *d, tia_rgb565 *out, int pitch)
{
    struct sure_block *b = &d->block;
    num_u threshold[SURE_SIDE][8];

    for (int y = 0; y < b->height; y++) {
        dither_thresholds(d->dither, b->y + y, threshold[y]);
        for (int x = 0; x < 16; x++)
            b->threshold[y][x] = (double)threshold[y][x & 7] * SURE_Q30;
    }
    d->kernels->trace(b, simd_kernels_room(d, sizeof *d));
    replace_samples(b);
    d->kernels->set_pixels(b);
    for (int y = 0, i = 0; y < b->height; y++, out += pitch)
        for (int x = 0; x < b->width; x++, i++)
            out[x] = b->open[i] ? exact_pixel(b, b->x + x, b->y + y, threshold[y][(b->x + x) & 7]) : b->pixels[i];
}

static void draw_strip(struct drawing *d, struct tia_tile strip, tia_rgb565 *pixels)
{
    struct sure_block *b = &d->block;
    int width = SURE_SLOTS / b->samples / strip.height, left = strip.width;

    b->y = strip.y;
    b->height = strip.height;
    for (int x = 0; x < (int)strip.width && !d->block.cancel.stopped; x += width, left -= width) {
        b->x = strip.x + x;
        b->width = left < width ? left : width;
        draw_block(d, pixels + x, strip.width);
    }
}

static void write_strip(struct tia_tile strip, const tia_rgb565 *pixels, char *out, const struct tia_surface *surface)
{
    for (int y = 0; y < strip.height; y++, out += surface->pitch)
        for (int x = 0; x < strip.width; x++)
            *(tia_rgb565 *)(void *)(out + x * surface->step) = surface_order(surface, *pixels++);
}

static void light(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                  const struct tia_options *options, void *memory)
{
    const struct sure_scene *s = tia_sure_scene(view);
    struct drawing *d = memory;
    int side = s->camera.side, most = SURE_SIDE / side;
    int rows = STRIP / tile.width < most ? STRIP / tile.width : most;

    if (options_debug(options).path_hash || options_debug(options).lit || s->occluded || s->fixed_only) {
        tia_simd_light_plain(view, tile, surface, options);
        return;
    }
    d->kernels = view->simd->sure;
    d->dither = options->dither;
    d->block.scene = s;
    d->block.cancel = view_cancel(view);
    d->block.samples = side * side;
    for (int y = 0; y < (int)tile.height && !d->block.cancel.stopped; y += rows) {
        int left = tile.height - y;
        struct tia_tile strip = {tile.x, (uint16_t)(tile.y + y), tile.width, (uint16_t)(left < rows ? left : rows)};
        draw_strip(d, strip, d->pixels);
        write_strip(strip, d->pixels, (char *)surface->pixels + y * surface->pitch, surface);
    }
}

/* True if the SIMD kernels draw the view. They need the boxes of a hierarchy, and draw no light fields, whose
 * neighbouring pixels have different eyes. */
static bool draws(const struct tia_view *view)
{
    return view->scene->bvh && !view->scene->field;
}

const struct simd_renderer tia_simd_rays = {tia_sure_size, draws, tia_sure_prepare, tia_sure_set_lights, room,
                                            light,         NULL};
