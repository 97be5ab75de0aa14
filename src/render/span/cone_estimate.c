/* cone_estimate.c - a first guess of the pixels inside a cone: apart from the search, which is compiled for speed. */
#include "cone_row.h"
#include "span_shift.h"

/* Returns the upper 31 of the bits of x. */
static num_u top_of(num_wide x, int bits)
{
    return (num_u)span_shift(x, 31 - bits);
}

/* Returns the first pixel at X or behind it, within the line. */
static int pixel_at(const struct cone_row *s, num_wide x)
{
    num_wide count = (num_wide)s->count;

    return x <= -count ? 0 : x >= count ? s->count : (int)(x + count) / 2;
}

struct span cone_row_estimate(const struct cone_row *s)
{
    struct span none = {0, 0};
    num_wide a = s->c - s->slope * s->slope;

    if (a <= 0 || s->base <= 0)
        return none;
    int a_bits = span_bits(a), base_bits = span_bits(s->base), square_bits = span_bits(s->square);
    int c_bits = span_bits(s->c) | 1, shift = a_bits + square_bits - 2 * base_bits;
    int down = base_bits - a_bits - 28 - s->exponent;
    num_u a_top = top_of(a, a_bits), base_top = top_of(s->base, base_bits);
    num_wide rest = span_shift((num_wide)num_mul_u(base_top, base_top), -2);
    if (shift > 2 || down > 0)
        return none;
    rest -= span_shift((num_wide)num_mul_u(a_top, top_of(s->square, square_bits)), shift - 2);
    if (rest <= 0)
        return none;
    num_wide root = num_sqrt(num_mul_u(top_of(s->c, c_bits), num_top_u(rest)));
    num_wide middle = s->slope * base_top, half = span_shift(root, (c_bits + 3) / 2);
    num times = num_signed(num_quotient(NUM_ONE, a_top, 33));
    return (struct span){pixel_at(s, span_shift(num_mul(num_top(middle - half), times), down)),
                         pixel_at(s, span_shift(num_mul(num_top(middle + half), times), down) + 1)};
}
