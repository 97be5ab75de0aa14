/* steps_walk.c - the innermost loop of steps.h. */
#include "math/fast.h"

#include "steps_row.h"

#define STEPS_RUN 16 /* pixels after which it is looked whether u has turned */
#define FRACTION 8   /* bits of D's step below those of D's upper word */

/* Returns x/2^(32 - FRACTION) to nearest: the upper word with a fraction. */
static int32_t with_fraction(uint64_t x)
{
    return (int32_t)((int64_t)(x + (UINT64_C(1) << (31 - FRACTION))) >> (32 - FRACTION));
}

/* Moves the row on by `count` pixels. */
static void move(struct step_row *row, int count)
{
    row->d += steps_times(row->d_step, count) + steps_times(row->d_twice, count * (count - 1) / 2);
    row->d_step += steps_times(row->d_twice, count);
    row->at += count;
}

/* True if D's upper word changes by less than 2^22 a pixel: its step by less than 2^21, as steps with a fraction have
 * it. */
static bool is_smooth(const struct step_row *row)
{
    int32_t step = steps_top((int64_t)row->d_step), twice = steps_top((int64_t)row->d_twice);

    return step / (1 << 14) < 128 && step / (1 << 14) > -128 && twice / (1 << 14) == 0;
}

/* What a step adds to the pixel, by its channels. */
static const TIA_FLASH uint16_t grown[8] = {0, 0x0800, 0x0020, 0x0820, 0x0001, 0x0801, 0x0021, 0x0821};

void steps_pass(struct step_row *row, int by)
{
    uint8_t channels = row->steps->channels[by > 0 ? row->index : row->index - 1];

    row->pixel = (tia_rgb565)(by > 0 ? row->pixel + grown[channels] : row->pixel - grown[channels]);
    row->index += by;
}

tia_rgb565 steps_pixel(const struct colour_steps *steps, int index)
{
    tia_rgb565 pixel = steps->dark;

    for (int k = 0; k < index; k++)
        pixel = (tia_rgb565)(pixel + grown[steps->channels[k]]);
    return pixel;
}

int steps_walk(struct step_row *row, int dir, int count, int *passed, tia_rgb565 *pixels)
{
    int32_t d = steps_top((int64_t)row->d) + STEPS_BOUND(STEPS_WALKED);
    int32_t d_step = with_fraction(row->d_step), d_twice = with_fraction(row->d_twice);
    int32_t b = steps_top(steps_b(row)), b_step = steps_top(row->b_step + STEPS_HALF);
    int32_t g = dir * steps_top(steps_g(row)), g_step = dir * steps_top(row->g_step + STEPS_HALF);
    int32_t margin = row->steps->walk_margin, more = 0;
    int i = 0, limit = row->turned || count < STEPS_RUN ? count : STEPS_RUN;

    *passed = 0;
    if (!is_smooth(row))
        limit = 0;
    while (i < limit) {
        int k = dir > 0 ? row->index : row->index - 1;
        bool any = k >= 0 && k < row->steps->count;
        int32_t w = any ? dir * row->steps->at[k] : 0, square = steps_square(w), least = any ? -margin : INT32_MAX;
        tia_rgb565 pixel = steps_shown(row);
        for (; i < limit; i++) {
            more = steps_square(g - steps_high(w, b)) - steps_high(square, d);
            if (more >= least)
                break;
            pixels[i] = pixel;
            d += d_step >> FRACTION;
            d_step += d_twice;
            b += b_step;
            g += g_step;
        }
        if (i == limit || more <= margin)
            break;
        steps_pass(row, dir);
        *passed = i;
        limit = row->turned || count - i < STEPS_RUN ? count : i + STEPS_RUN;
    }
    row->slow = i < limit || limit == 0;
    move(row, i);
    return i;
}
