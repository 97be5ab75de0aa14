/* steps_side.c - on which side of a step a pixel is. */
#include "math/fast.h"

#include "math/noinline.h"
#include "steps_row.h"

int64_t steps_upper(int64_t a, int64_t b)
{
    uint32_t a_low = (uint32_t)a, b_low = (uint32_t)b;
    int64_t left = tia_mul_s32(steps_top(a), (int32_t)(b_low >> 1)) >> 31;
    int64_t right = tia_mul_s32(steps_top(b), (int32_t)(a_low >> 1)) >> 31;

    return tia_mul_s32(steps_top(a), steps_top(b)) + left + right;
}

/* Returns x n (n - 1)/2 modulo 2^64; n is in 0..2^16 - 1. */
static inline uint64_t times_pairs(uint64_t x, int n)
{
    int odd = n & 1;

    if (STEPS_HALVES)
        return steps_times(steps_times(x, (n - odd) / 2), n > 0 ? n - 1 + odd : 0);
    return steps_times(x, (int)((uint32_t)n * (uint32_t)(n - 1) / 2));
}

void steps_point(const struct step_row *row, struct step_point *point)
{
    int at = row->at;

    point->d = row->d + steps_times(row->d_step, at) + times_pairs(row->d_twice, at);
    point->g = row->g + (int64_t)steps_times((uint64_t)row->g_step, at);
    point->b = steps_top(row->b + (int64_t)steps_times((uint64_t)row->b_step, at));
}

/* Returns A at a pixel, with a lower word. */
static int64_t form_at(const struct step_point *point, int32_t w)
{
    return point->g - tia_mul_s32(w, point->b);
}

NOINLINE int steps_decide(const struct colour_steps *steps, uint64_t d, int32_t a, int32_t w, int32_t doubt,
                          int32_t above)
{
    int64_t square = tia_mul_s32(w, w), root = (tia_mul_s32(w < 0 ? -w : w, steps->root_most) >> 32) + 1;
    int64_t left = tia_mul_s32(a, a < 0 ? -a : a), right = steps_upper(square, (int64_t)d);
    uint64_t of_a = tia_mul_u32((uint32_t)(2 * root + doubt), (uint32_t)doubt);
    int64_t margin = (int64_t)(of_a + tia_mul_u32((uint32_t)(square >> 32) + 1, (uint32_t)above) + 4);
    int64_t more = left - (w < 0 ? -right : right);

    return more > margin ? 1 : more < -margin ? -1 : 0;
}

int steps_side(const struct colour_steps *steps, const struct step_point *point, int k)
{
    if (k < 0 || k >= steps->count)
        return k < 0 ? 1 : -1;
    int32_t w = steps->at[k], a = steps_top(form_at(point, w)), margin = steps->margin;
    int32_t more = steps_square(a) - steps_high(steps_square(w), steps_top((int64_t)point->d));
    if (more > margin || more < -margin)
        return more > margin ? 1 : -1;
    return steps_decide(steps, point->d, a, w, steps->fine_doubt, 2 * steps->depth_doubt);
}
