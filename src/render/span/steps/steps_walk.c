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

/* A run being walked. */
struct walk {
    struct step_row *row;
    const tia_rgb565 *pixels; /* the run's first pixel */
    int first, way;           /* that pixel's number, and the direction in which u changes */
};

/* Returns 1 if u at a pixel has passed step k, whose A^2 - W^2 D is about `more`, -1 if not, 0 in doubt: first by the
 * run's A, which is `way` times a, and D, then by the pixel's. */
static NOINLINE int settle(const struct walk *walk, const tia_rgb565 *pixel, int k, int32_t more, int32_t a, int32_t d)
{
    struct step_row *row = walk->row;
    const int32_t w = row->steps->at[k], margin = margin_at(row->steps, a, steps_square(w));
    struct step_point point;

    if (more > margin || more < -margin)
        return more > margin ? 1 : -1;
    int side = steps_decide(row->steps, (uint64_t)(uint32_t)d << 32, walk->way * a, w, row->steps->walk_doubt,
                            STEPS_BOUND(STEPS_WALKED) + 2 * row->steps->depth_doubt);
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
    const int32_t b_step = way * steps_top(row->b_step + STEPS_HALF), margin = steps->walk_margin;
    tia_rgb565 *next = pixels, *const end = pixels + count;
    uint64_t step = row->d_step + steps_times(row->d_twice, row->at);
    struct step_point point;

    if (!is_smooth(row, step))
        return 0;
    steps_point(row, &point);
    int32_t d = steps_top((int64_t)point.d) + STEPS_BOUND(STEPS_WALKED);
    int32_t d_step = with_fraction(step), d_twice = with_fraction(row->d_twice);
    const int32_t g = way * steps_top(point.g), b = way * point.b;
    int k = way > 0 ? row->index : row->index - 1, left = way > 0 ? steps->count - k : k + 1, side = 1;
    while (next < end && side > 0) {
        const tia_rgb565 pixel = pixel_order(steps->pixel[k + (way < 0)], TIA_SWAP && row->swap);
        if (left-- <= 0) {
            span_fill(next, (int)(end - next), pixel);
            next = end;
            break;
        }
        const int32_t w = steps->at[k], square = way * steps_square(w), i = (int32_t)(next - pixels);
        const int32_t a_step = steps_top(g_step - tia_mul_s32(w, b_step));
        int32_t a = g + i * steps_top(g_step) - steps_high(w, b + i * b_step);
        for (side = -1; next < end; a += a_step) {
            int32_t more = steps_square(a) - steps_high(square, d);
            if (UNLIKELY(more >= -margin)) {
                side = LIKELY(more > margin) ? 1 : settle(&walk, next, k, more, a, d);
                if (side >= 0)
                    break;
            }
            *next++ = pixel;
            d += d_step >> FRACTION;
            d_step += d_twice;
        }
        k += side > 0 ? way : 0;
    }
    row->index = k + (way < 0);
    row->at = walk.first + (int)(next - pixels);
    return (int)(next - pixels);
}
