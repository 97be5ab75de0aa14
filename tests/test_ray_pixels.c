/* src/simd/rays, pixels by every instruction set: samples and their errors in RGB565, close to where colours change. A
 * certain result must be that of the fixed-point samples, which are off by as much as the errors allow. */
#include <math.h>
#include <tia/simd.h>

#include "check.h"
#include "float_modes.h"
#include "random.h"
#include "render/core/dither.h"
#include "simd/rays/sure.h"
#include "simd/simd.h"

#define WITHIN .9999 /* used part of a bound */

static double some_part(void)
{
    return fabs(random_double());
}

/* A block, and the fixed-point samples, from which those of the block differ by their errors. */
struct drawn {
    struct sure_block block;
    num_length sample[3][SURE_SLOTS];
    num_u threshold[SURE_SIDE][8];
};

static void open_block(struct drawn *d)
{
    struct sure_block *b = &d->block;
    int side = 1 + (int)(random_bits() % 4);

    memset(b, 0, sizeof *b);
    b->samples = side * side;
    b->height = 1 + (int)(random_bits() % (unsigned)(SURE_SIDE / side));
    b->width = 1 + (int)(random_bits() % (unsigned)(SURE_SLOTS / b->samples / b->height));
    b->x = (int)(random_bits() % 100);
    b->y = (int)(random_bits() % 100);
    for (int y = 0; y < b->height; y++) {
        dither_thresholds(random_bits() % 2, b->y + y, d->threshold[y]);
        for (int x = 0; x < b->width; x++)
            b->threshold[y * b->width + x] = (double)d->threshold[y][(b->x + x) & 7] * P2M(30);
    }
}

/* Returns a mean close to the lower end of one of the levels, within the error of the pixel's samples and some units,
 * or a random one. */
static double some_mean(unsigned levels, num_u threshold, double error)
{
    double level = (double)(1 + random_bits() % levels), near = error + 32 * SURE_UNIT;

    if (random_bits() % 2)
        return some_part();
    return (level - (double)threshold * P2M(30)) / levels + 1.5 * near * random_double();
}

static num_length clamped(num_length x)
{
    return num_length_clamp(x, 0, NUM_LENGTH_ONE);
}

/* Sets a pixel's samples in one colour, in pairs: one above the mean and one as much below it. Some are outside of a
 * picture's range. */
static void set_samples(struct drawn *d, int first, int colour, double mean, const double *error, double turn)
{
    struct sure_block *b = &d->block;
    double away = 0;

    for (int i = 0; i < b->samples; i++) {
        bool pair = i + 1 < b->samples || b->samples % 2 == 0;
        away = i % 2 ? -away : pair ? fmin(mean, 1 - mean) * random_double() : 0;
        num_length v = clamped((num_length)((mean + away) / SURE_UNIT));
        if (random_bits() % 32 == 0)
            v = 4 * v - NUM_LENGTH_ONE;
        d->sample[colour][first + i] = v;
        b->colour[colour][first + i] = sure_length(v) + turn * error[i];
    }
}

static void set_pixel(struct drawn *d, int first, num_u threshold)
{
    struct sure_block *b = &d->block;
    double size = random_bits() % 2 ? ldexp(some_part(), -3 - (int)(random_bits() % 38)) : 0, mean = 0;
    double turn = random_bits() % 2 ? WITHIN : -WITHIN;

    for (int i = 0; i < b->samples; i++) {
        b->error[first + i] = size * some_part() + P2M(50);
        mean += b->error[first + i] / b->samples;
    }
    for (int c = 0; c < 3; c++)
        set_samples(d, first, c, some_mean(c == 1 ? 63 : 31, threshold, mean), &b->error[first], turn);
}

/* Packs a pixel as the fixed-point code does. */
static tia_rgb565 packed(const struct drawn *d, int first, num_u threshold)
{
    num_length mean[3] = {0, 0, 0};

    for (int c = 0; c < 3; c++)
        for (int i = 0; i < d->block.samples; i++)
            mean[c] += clamped(d->sample[c][first + i]) / d->block.samples;
    return (tia_rgb565)(num_levels(mean[0], 31, threshold) << 11 | num_levels(mean[1], 63, threshold) << 5 |
                        num_levels(mean[2], 31, threshold));
}

static unsigned long sure, open, wrong;

static void try_block(const struct sure_kernels *kernels)
{
    static struct drawn d;
    struct sure_block *b = &d.block;

    open_block(&d);
    for (int y = 0, i = 0; y < b->height; y++)
        for (int x = 0; x < b->width; x++, i++)
            set_pixel(&d, i * b->samples, d.threshold[y][(b->x + x) & 7]);
    kernels->set_pixels(b);
    for (int y = 0, i = 0; y < b->height; y++)
        for (int x = 0; x < b->width; x++, i++) {
            sure += !b->open[i];
            open += b->open[i];
            wrong += !b->open[i] && b->pixels[i] != packed(&d, i * b->samples, d.threshold[y][(b->x + x) & 7]);
        }
}

TEST(pixels)
{
    for (unsigned i = 0; tia_simd_at(i); i++) {
        sure = open = wrong = 0;
        for (int k = 0; k < 2000; k++)
            try_block(tia_simd_at(i)->sure);
        printf("# %s: %lu sure, %lu open\n", tia_simd_at(i)->name, sure, open);
        CHECK_MSG(wrong == 0, "%s: %lu of %lu pixels are not the integers'", tia_simd_at(i)->name, wrong, sure);
        CHECK(sure > open / 16);
    }
}

int main(void)
{
    float_mode_of_simd();
    RUN(pixels);
    return check_status();
}
