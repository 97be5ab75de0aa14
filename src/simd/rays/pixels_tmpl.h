/* pixels_tmpl.h - conversion of a block's samples to RGB565, where all of mean +- error gives the same colour.
 *
 * Parameters: the doubles of isa/isa.h. Defines: set_pixels(). */
#ifndef TIA_SIMD_RAYS_PIXELS_TMPL_H
#define TIA_SIMD_RAYS_PIXELS_TMPL_H

#include "vector_tmpl.h"

LANE_OP vd clamped(vd c)
{
    return vmin(vmax(c, vset(0)), vset(1));
}

/* Returns a colour's level: floor(c n + threshold), see num_levels(). *one is cleared where mean +- error includes
 * several levels. PIXEL_LEVEL covers the roundings of this function, which no test notices. Those of the mean are part
 * of `error`. */
LANE_OP vd level_of(vd mean, vd error, double levels, vd threshold, vm *one)
{
    vd low = vfloor(vmax(clamped(mean - error) * vset(levels) + threshold - BOUND(PIXEL_LEVEL), vset(0)));
    vd high = vfloor(clamped(mean + error) * vset(levels) + threshold + BOUND(PIXEL_LEVEL));

    *one = mand(*one, vle(high, low));
    return low;
}

/* Packs LANES pixels, beginning with pixel `first` of the block. */
LANE_OP void pack_pixels(struct sure_block *b, const vd mean[3], vd error, int first)
{
    const vd threshold = vload(&b->threshold[first]);
    vd sum = BOUND_OF(PIXEL_ERROR, error) + BOUND(PIXEL_MEAN);
    vm one = vlt(sum, vset(1));
    vd r = level_of(mean[0], sum, 31, threshold, &one), g = level_of(mean[1], sum, 63, threshold, &one);
    vd blue = level_of(mean[2], sum, 31, threshold, &one);
    vi pixel = whole_words(r * 2048 + g * 32 + blue);
    unsigned fine = mbits(one);
    int64_t bits[LANES];

    __builtin_memcpy(bits, &pixel, sizeof bits);
    for (int k = 0; k < LANES; k++)
        b->pixels[first + k] = (tia_rgb565)bits[k];
    for (int k = 0; k < LANES; k++)
        b->open[first + k] = !(fine >> k & 1);
}

/* Computes means over the samples of LANES pixels. */
LANE_OP void mean_of_samples(const struct sure_block *b, int first, vd mean[3], vd *error)
{
    double sum[4][LANES] = {{0}}, part = 1.0 / b->samples;

    for (int k = 0; k < LANES && (first + k) * b->samples < SURE_SLOTS; k++)
        for (int i = (first + k) * b->samples, end = i + b->samples; i < end; i++) {
            for (int c = 0; c < 3; c++) {
                double v = b->colour[c][i];
                sum[c][k] += (v < 0 ? 0 : v > 1 ? 1 : v) * part;
            }
            sum[3][k] += b->error[i] * part;
        }
    for (int c = 0; c < 3; c++)
        mean[c] = vload(sum[c]);
    *error = vload(sum[3]);
}

static void set_pixels(struct sure_block *b)
{
    vd mean[3], error;

    for (int first = 0; first < b->width * b->height; first += LANES) {
        if (b->samples == 1) {
            for (int c = 0; c < 3; c++)
                mean[c] = clamped(vload(&b->colour[c][first]));
            error = vload(&b->error[first]);
        } else {
            mean_of_samples(b, first, mean, &error);
        }
        pack_pixels(b, mean, error, first);
    }
}

#endif
