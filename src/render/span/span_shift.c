#include "math/fast.h"

#include "span_shift.h"

num_wide span_shift_apart(num_wide x, int s)
{
    return num_shift(x, s);
}

struct num_vec span_sum(const struct num_vec *a, const struct num_vec *b)
{
    return num_vec_add(*a, *b);
}

struct num_vec span_difference_apart(const struct num_vec *a, const struct num_vec *b)
{
    return num_vec_sub(*a, *b);
}

num_wide span_dot(const struct num_vec *a, const struct num_vec *b)
{
    return num_dot(*a, *b);
}

num_wide span_square30_apart(const struct num_vec *a)
{
    return num_square30(*a);
}

bool span_product_above(num_wide a, num_wide b, num_wide c, num_wide d)
{
    return num_product_above(a, b, c, d);
}

bool span_is_within(const struct num_vec *a, num_wide r)
{
    return num_is_within(a->x, a->y, a->z, r);
}

num_wide span_bias_of(num_wide x, num_u inverse, int bits, int e)
{
    return num_bias_of(x, inverse, bits, e);
}

num_u span_swell(num_u inverse, int bits, bool inside)
{
    return num_swell(inverse, bits, inside);
}

int span_bits_apart(num_wide x)
{
    return num_bits(x);
}

num_wide span_power_apart(int bits)
{
    return num_bound(bits);
}
