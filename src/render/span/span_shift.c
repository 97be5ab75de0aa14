#include "span_shift.h"

num_wide span_shift(num_wide x, int s)
{
    return num_shift(x, s);
}

num_wide span_dot(const struct num_vec *a, const struct num_vec *b)
{
    return num_dot(*a, *b);
}

num_wide span_square30(const struct num_vec *a)
{
    return num_square30(*a);
}

int span_bits(num_wide x)
{
    return num_bits(x);
}

num_wide span_power(int bits)
{
    return num_bound(bits);
}
