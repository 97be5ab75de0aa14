/* steps_row.h - what the parts of steps.h share: products, and a row's steps. */
#ifndef TIA_RENDER_SPAN_STEPS_STEPS_ROW_H
#define TIA_RENDER_SPAN_STEPS_STEPS_ROW_H

#include "steps.h"

#include "math/integer.h"
#include "steps_proved.h"

#define STEPS_HALF ((int64_t)1 << 31)

/* 1: products are made of halves of 16 bits, for processors without products of 64 bits. */
#ifndef STEPS_HALVES
#define STEPS_HALVES (TIA_HALF_PRODUCTS || TIA_SHIFTS_BITS)
#endif

/* Returns a b/2^32, too small by less than 3: of halves the lowest product is left out, and the middle
 * ones are cut off. |a b| < 2^62. */
static inline int32_t steps_high(int32_t a, int32_t b)
{
    if (!STEPS_HALVES)
        return (int32_t)(tia_mul_s32(a, b) >> 32);
    int16_t a1 = (int16_t)(a >> 16), b1 = (int16_t)(b >> 16);
    uint16_t a0 = (uint16_t)a, b0 = (uint16_t)b;
    return (int32_t)a1 * b1 + ((int32_t)((int32_t)a1 * b0) >> 16) + ((int32_t)((int32_t)b1 * a0) >> 16);
}

/* Returns x |x|/2^32, as steps_high does. */
static inline int32_t steps_square(int32_t x)
{
    return steps_high(x, x < 0 ? -x : x);
}

/* Returns the upper word. */
static inline int32_t steps_top(int64_t x)
{
    return (int32_t)(x >> 32);
}

/* Returns n x modulo 2^64; n is less than 2^16. */
static inline uint64_t steps_times(uint64_t x, int n)
{
    return tia_mul_u32((uint32_t)x, (uint32_t)n) + ((uint64_t)((uint32_t)(x >> 32) * (uint32_t)n) << 32);
}

/* Returns the accumulators of L.v and G.v at the row's pixel. */
static inline int64_t steps_b(const struct step_row *row)
{
    return row->b + (int64_t)steps_times((uint64_t)row->b_step, row->at);
}

static inline int64_t steps_g(const struct step_row *row)
{
    return row->g + (int64_t)steps_times((uint64_t)row->g_step, row->at);
}

/* Returns the pixel above `index` steps. */
tia_rgb565 steps_pixel(const struct colour_steps *steps, int index);

/* Passes the next step upwards, with `by` 1, or the last one downwards, with -1. */
void steps_pass(struct step_row *row, int by);

/* Draws up to `count` pixels, at most STEPS_BLOCK, by the steps in the direction of u alone, +1 or -1, until one is in
 * doubt, which `slow` counts, or, before the extremum, until STEPS_RUN have passed no step; returns how many. `passed`
 * receives the last one that did. */
int steps_walk(struct step_row *row, int dir, int count, int *passed, tia_rgb565 *pixels);

#endif
