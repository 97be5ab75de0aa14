/* draw.c - a tile, block by block: what is sure becomes levels of RGB565, samples that are not go to the integers. */
#include "levels/level.h"
#include "render/dither.h"
#include "sure.h"

#define STRIP 16384 /* pixels: as many rows as fit, so that they are written in order */

_Static_assert(STRIP >= TIA_SIZE_MAX, "a row fits");

struct drawing {
    const struct tia_view *view;
    const struct sure_kernels *kernels;
    bool dither;
    struct sure_block block;
};

static double clamped(double c)
{
    return c < 0 ? 0 : c > 1 ? 1 : c;
}

/* A colour's level: floor(c n + threshold), see num_levels. False when mean +- error has several. 2^-40 is for the sums
 * here and the integers' division by the samples. */
static bool level_of(double mean, double error, int levels, double threshold, unsigned *level)
{
    double low = clamped(mean - error) * levels + threshold - SURE_2(40);
    double high = clamped(mean + error) * levels + threshold + SURE_2(40);

    *level = (unsigned)(low < 0 ? 0 : low);
    return *level == (unsigned)high;
}

static bool pack(const double mean[3], double error, double threshold, tia_rgb565 *pixel)
{
    unsigned r, g, b;
    bool sure = error < 1 && level_of(mean[0], error, 31, threshold, &r) &&
                level_of(mean[1], error, 63, threshold, &g) && level_of(mean[2], error, 31, threshold, &b);

    if (sure)
        *pixel = (tia_rgb565)(r << 11 | g << 5 | b);
    return sure;
}

/* A sample by the integers: then it is off by no more than its conversion. */
static void replace(struct drawing *d, int slot, int x, int y)
{
    struct sure_block *b = &d->block;
    num_length colour[3];

    tia_sure_sample(b->scene->view, x, y, slot % b->samples, colour);
    for (int c = 0; c < 3; c++)
        b->colour[slot][c] = sure_length(num_length_clamp(colour[c], 0, NUM_LENGTH_ONE));
    b->error[slot] = SURE_2(50);
    b->unsure[slot] = false;
}

/* False: not all of mean +- error is one pixel. */
static bool pixel_of(const struct sure_block *b, int first, double threshold, tia_rgb565 *pixel)
{
    double mean[3] = {0, 0, 0}, error = SURE_2(40), part = 1.0 / b->samples;

    for (int i = first; i < first + b->samples; i++) {
        for (int c = 0; c < 3; c++)
            mean[c] += clamped(b->colour[i][c]) * part;
        error += b->error[i] * part;
    }
    return pack(mean, error, threshold, pixel);
}

/* A pixel whose samples are all the integers'. */
static tia_rgb565 exact_pixel(const struct sure_block *b, int x, int y, num_u threshold)
{
    num_length mean[3] = {0, 0, 0}, colour[3];

    for (int i = 0; i < b->samples; i++) {
        tia_sure_sample(b->scene->view, x, y, i, colour);
        for (int c = 0; c < 3; c++)
            mean[c] += num_length_clamp(colour[c], 0, NUM_LENGTH_ONE) / (num_length)b->samples;
    }
    return (tia_rgb565)(num_levels(mean[0], 31, threshold) << 11 | num_levels(mean[1], 63, threshold) << 5 |
                        num_levels(mean[2], 31, threshold));
}

static void draw_pixel(struct drawing *d, int x, int y, int first, num_u threshold, tia_rgb565 *pixel)
{
    struct sure_block *b = &d->block;

    for (int k = first; k < first + b->samples; k++)
        if (b->unsure[k] && !view_stops(d->view))
            replace(d, k, x, y);
    if (!pixel_of(b, first, (double)threshold * SURE_2(30), pixel) && !view_stops(d->view))
        *pixel = exact_pixel(b, x, y, threshold);
}

static void draw_block(struct drawing *d, tia_rgb565 *out, int pitch)
{
    const struct sure_block *b = &d->block;
    num_u threshold[8];
    int first = 0;

    d->kernels->trace(&d->block);
    for (int y = b->y; y < b->y + b->height; y++, out += pitch) {
        dither_thresholds(d->dither, y, threshold);
        for (int x = 0; x < b->width; x++, first += b->samples)
            draw_pixel(d, b->x + x, y, first, threshold[(b->x + x) & 7], &out[x]);
    }
}

static void draw_strip(struct drawing *d, struct tia_tile strip, tia_rgb565 *pixels)
{
    struct sure_block *b = &d->block;
    int width = SURE_SLOTS / b->samples / strip.height, left = strip.width;

    b->y = strip.y;
    b->height = strip.height;
    for (int x = 0; x < (int)strip.width && !view_stops(d->view); x += width, left -= width) {
        b->x = strip.x + x;
        b->width = left < width ? left : width;
        draw_block(d, pixels + x, strip.width);
    }
}

static void write_strip(struct tia_tile strip, const tia_rgb565 *pixels, char *out, const struct tia_surface *surface)
{
    for (int y = 0; y < strip.height; y++, out += surface->pitch)
        for (int x = 0; x < strip.width; x++)
            *(tia_rgb565 *)(void *)(out + x * surface->step) = *pixels++;
}

static void light(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                  const struct tia_options *options)
{
    const struct sure_scene *s = tia_sure_scene(view);
    struct drawing d = {.view = view, .kernels = view->level->sure, .dither = options->dither};
    int side = s->camera.side, most = SURE_SIDE / side;
    int rows = STRIP / tile.width < most ? STRIP / tile.width : most;
    tia_rgb565 pixels[STRIP];

    if (options->path_hash || options->lit) {
        tia_level_light_plain(view, tile, surface, options);
        return;
    }
    d.block.scene = s;
    d.block.samples = side * side;
    for (int y = 0; y < (int)tile.height && !view_stops(view); y += rows) {
        int left = tile.height - y;
        struct tia_tile strip = {tile.x, (uint16_t)(tile.y + y), tile.width, (uint16_t)(left < rows ? left : rows)};
        draw_strip(&d, strip, pixels);
        write_strip(strip, pixels, (char *)surface->pixels + y * surface->pitch, surface);
    }
}

/* Without a hierarchy there are no boxes. A light field's neighbours have eyes of their own. */
static bool draws(const struct tia_view *view)
{
    return view->scene->bvh && !view->scene->field;
}

const struct level_renderer tia_level_rays = {tia_sure_size, draws, tia_sure_prepare, tia_sure_set_lights, light, NULL};
