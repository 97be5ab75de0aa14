/* steps_walk.c - the innermost loop of steps.h. */
#include "math/fast.h"

#include "math/noinline.h"
#include "steps_row.h"

#define FRACTION 8 /* bits of D's step below those of D's upper word */

/* Returns x/2^(32 - FRACTION) to nearest: the upper word with a fraction. */
static int32_t with_fraction(uint64_t x)
{
    return (int32_t)((int64_t)(x + (UINT64_C(1) << (31 - FRACTION))) >> (32 - FRACTION));
}

/* True if D's upper word changes by less than 2^22 a pixel: its step by less than 2^21, as steps with a fraction have
 * it. */
static bool is_smooth(const struct step_row *row, uint64_t d_step)
{
    int32_t step = steps_top((int64_t)d_step), twice = steps_top((int64_t)row->d_twice);

    return step / (1 << 14) < 128 && step / (1 << 14) > -128 && twice / (1 << 14) == 0;
}

/* Returns the bound of the error of A^2 - W^2 D, upper words, for one A and W^2. Where A and W S are off by up to e in
 * all and in the wrong order, A is at most W S + e, and A |A| - W S |W S| at most 2 |A| e + 2 e^2. */
static int32_t margin_at(const struct colour_steps *steps, int32_t a, int32_t square)
{
    uint32_t size = (uint32_t)(a < 0 ? -a : a), weight = (uint32_t)(square < 0 ? -square : square) >> 16;
    uint32_t doubt = (uint32_t)steps->walk_doubt;
    uint64_t of_a = tia_mul_u32(size + doubt, doubt) >> 31;
    uint64_t of_d = tia_mul_u32(weight + 1, (uint32_t)(STEPS_BOUND(STEPS_WALKED) + 2 * steps->depth_doubt)) >> 16;

    return (int32_t)of_a + (int32_t)of_d + 2 + STEPS_BOUND(STEPS_MARGIN);
}

/* Returns 1 if u at pixel `at` has passed step k, whose A^2 - W^2 D is about `more`, -1 if not, 0 in doubt. */
static NOINLINE int settle(struct step_row *row, int at, int k, int way, int32_t more, int32_t a, int32_t square)
{
    int32_t margin = margin_at(row->steps, a, square);
    struct step_point point;

    if (more > margin || more < -margin)
        return more > margin ? 1 : -1;
    row->at = at;
    steps_point(row, &point);
    return way * steps_side(row->steps, &point, k);
}

int steps_walk(struct step_row *row, int way, int count, tia_rgb565 *pixels)
{
    const int first = row->at;
    uint64_t step = row->d_step + steps_times(row->d_twice, first);
    struct step_point point;
    int i = 0;

    if (!is_smooth(row, step))
        return 0;
    steps_point(row, &point);
    int32_t d = steps_top((int64_t)point.d) + STEPS_BOUND(STEPS_WALKED);
    int32_t d_step = with_fraction(step), d_twice = with_fraction(row->d_twice);
    int32_t b = point.b, b_step = steps_top(row->b_step + STEPS_HALF);
    int32_t g = way * steps_top(point.g), g_step = way * steps_top(row->g_step + STEPS_HALF);
    int32_t margin = row->steps->walk_margin;
    while (i < count) {
        int k = way > 0 ? row->index : row->index - 1;
        tia_rgb565 pixel = steps_shown(row);
        if (k < 0 || k >= row->steps->count) {
            span_fill(pixels + i, count - i, pixel);
            i = count;
            break;
        }
        int32_t w = row->steps->at[k], a_step = way * steps_top(row->g_step - tia_mul_s32(w, b_step) + STEPS_HALF);
        int32_t a = g + i * g_step - way * steps_high(w, b + i * b_step), square = way * steps_square(w);
        bool passed = false;
        while (i < count) {
            int32_t more = steps_square(a) - steps_high(square, d);
            if (more >= -margin) {
                int side = more > margin ? 1 : settle(row, first + i, k, way, more, a, square);
                if (!side)
                    return i;
                passed = side > 0;
                if (passed)
                    break;
            }
            pixels[i++] = pixel;
            d += d_step >> FRACTION;
            d_step += d_twice;
            a += a_step;
        }
        row->index += passed ? way : 0;
    }
    row->at = first + i;
    return i;
}
