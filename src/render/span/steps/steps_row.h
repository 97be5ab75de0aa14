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

/* STEPS_MARGIN as it is on this processor. */
#define STEPS_PRODUCTS (STEPS_HALVES ? STEPS_BOUND(STEPS_HALVES_MARGIN) : STEPS_BOUND(STEPS_MARGIN))

/* Returns a b/2^32, too small by less than 3: of halves the lowest product is left out, and the middle
 * ones are cut off. |a b| < 2^62. */
static inline int32_t steps_high(int32_t a, int32_t b)
{
    if (!STEPS_HALVES)
        return tia_high_s32(a, b);
    int16_t a1 = (int16_t)(a >> 16), b1 = (int16_t)(b >> 16);
    uint16_t a0 = (uint16_t)a, b0 = (uint16_t)b;
    return (int32_t)a1 * b1 + ((int32_t)((int32_t)a1 * b0) >> 16) + ((int32_t)((int32_t)b1 * a0) >> 16);
}

/* Returns (a b + c d)/2^32, too small by less than 6. */
static inline int32_t steps_high_sum(int32_t a, int32_t b, int32_t c, int32_t d)
{
    return STEPS_HALVES ? steps_high(a, b) + steps_high(c, d) : tia_high_sum_s32(a, b, c, d);
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

/* Returns n x modulo 2^64; n is at least 0, and below 2^16 where products are made of halves. */
static inline uint64_t steps_times(uint64_t x, int n)
{
    uint32_t high = (uint32_t)(x >> 32) * (uint32_t)n, factor = (uint16_t)n;

    if (!STEPS_HALVES)
        return tia_mul_u32((uint32_t)x, (uint32_t)n) + ((uint64_t)high << 32);
    return ((uint64_t)high << 32) + (uint16_t)x * factor + ((uint64_t)(((uint32_t)x >> 16) * factor) << 16);
}

/* Returns a b/2^64, too small by less than 3. */
int64_t steps_upper(int64_t a, int64_t b);

/* Returns how much too large D's upper word may be in steps_walk. */
static inline int32_t steps_above(const struct colour_steps *steps)
{
    return STEPS_BOUND(STEPS_WALKED) + STEPS_BOUND(STEPS_WALKED_UP) + 2 * steps->depth_doubt;
}

/* A pixel of a row: D and G.v, and the upper word of L.v. */
struct step_point {
    uint64_t d;
    int64_t g;
    int32_t b;
};

/* Gives the row's pixel. */
void steps_point(const struct step_row *row, struct step_point *point);

/* Returns 1 if A is certainly at least W S at a pixel, -1 if it is less, 0 in doubt, by 64 bits. A and W S are off by
 * up to `doubt` in all; D's upper word is too large by up to `above`. */
int steps_decide(const struct colour_steps *steps, uint64_t d, int32_t a, int32_t w, int32_t doubt, int32_t above);

/* Returns 1 if u is at or above step k at a pixel, -1 if it is below, 0 in doubt. */
int steps_side(const struct colour_steps *steps, const struct step_point *point, int k);

/* Draws up to `count` pixels, 1..STEPS_BLOCK, where u changes in one direction, 1: it grows, -1: it falls, and is
 * on this side of the step behind it. Returns how many: the next one is in doubt if these are fewer. */
int steps_walk(struct step_row *row, int way, int count, tia_rgb565 *pixels);

#endif
