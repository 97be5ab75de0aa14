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

/* A run being walked. */
struct walk {
    struct step_row *row;
    const tia_rgb565 *pixels; /* the run's first pixel */
    int first, way;           /* that pixel's number, and the direction in which u changes */
};

/* Returns 1 if u at a pixel has passed step k, -1 if not, 0 in doubt: first by the run's A, which is `way` times a, and
 * D, then by the pixel's. */
static NOINLINE int settle(const struct walk *walk, const tia_rgb565 *pixel, int k, int32_t a, int32_t d)
{
    struct step_row *row = walk->row;
    int side = steps_decide(row->steps, (uint64_t)(uint32_t)d << 32, walk->way * a, row->steps->at[k],
                            row->steps->walk_doubt, steps_above(row->steps));
    struct step_point point;

    if (side)
        return walk->way * side;
    row->at = walk->first + (int)(pixel - walk->pixels);
    steps_point(row, &point);
    return walk->way * steps_side(row->steps, &point, k);
}

int steps_walk(struct step_row *row, int way, int count, tia_rgb565 *pixels)
{
    const struct colour_steps *steps = row->steps;
    const struct walk walk = {row, pixels, row->at, way};
    const int64_t g_step = way * row->g_step + STEPS_HALF;
    const int32_t b_back = -way * steps_top(row->b_step + STEPS_HALF), margin = steps->walk_margin;
    tia_rgb565 *next = pixels, *const end = pixels + count;
    uint64_t step = row->d_step + steps_times(row->d_twice, row->at);
    struct step_point point;

    if (!is_smooth(row, step))
        return 0;
    steps_point(row, &point);
    int32_t d = steps_top((int64_t)point.d) + STEPS_BOUND(STEPS_WALKED);
    int32_t d_step = with_fraction(step), d_twice = with_fraction(row->d_twice);
    const int32_t g = way * steps_top(point.g), b = way * point.b;
    const tia_rgb565 *const shown = steps->pixel + (way < 0);
    const int last = way > 0 ? steps->count : -1;
    int k = row->index - (way < 0), side = 1;
    while (side > 0) {
        const tia_rgb565 pixel = pixel_order(shown[k], TIA_SWAP && row->swap);
        if (k == last) {
            span_fill(next, (int)(end - next), pixel);
            next = end;
            break;
        }
        const int32_t w = steps->at[k], square = -way * steps_square(w);
        const int32_t a_step = steps_top(g_step + tia_mul_s32(w, b_back)), i = (int32_t)(next - pixels);
        int32_t a = g + i * steps_top(g_step) - steps_high(w, b - i * b_back);
        side = 0;
        do {
            int32_t more = steps_high_sum(a, a < 0 ? -a : a, square, d);
            if (UNLIKELY(more >= -margin)) {
                int passed = LIKELY(more > margin) ? 1 : settle(&walk, next, k, a, d);
                if (passed >= 0) {
                    side = passed;
                    break;
                }
            }
            *next++ = pixel;
            d += d_step >> FRACTION;
            d_step += d_twice;
            a += a_step;
        } while (next < end);
        k += side > 0 ? way : 0;
    }
    row->index = k + (way < 0);
    row->at = walk.first + (int)(next - pixels);
    return (int)(next - pixels);
}
