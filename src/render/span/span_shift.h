/* span_shift.h - functions of num.h that are called in many places: one copy of each, as flash is scarce. Processors of
 * 64 bits inline some that are called often. */
#ifndef TIA_RENDER_SPAN_SHIFT_H
#define TIA_RENDER_SPAN_SHIFT_H

#include "math/noinline.h"
#include "num/num.h"

/* num_vec_add, num_dot, num_product_above, num_is_within, num_bias_of and num_swell. */
struct num_vec span_sum(const struct num_vec *a, const struct num_vec *b);
num_wide span_dot(const struct num_vec *a, const struct num_vec *b);
bool span_product_above(num_wide a, num_wide b, num_wide c, num_wide d);
bool span_is_within(const struct num_vec *a, num_wide r);
num_wide span_bias_of(num_wide x, num_u inverse, int bits, int e);
num_u span_swell(num_u inverse, int bits, bool inside);

/* num_shift, num_vec_sub, num_square30, num_bits and num_bound: the copies, and what is called. */
num_wide span_shift_apart(num_wide x, int s);
struct num_vec span_difference_apart(const struct num_vec *a, const struct num_vec *b);
num_wide span_square30_apart(const struct num_vec *a);
int span_bits_apart(num_wide x);
num_wide span_power_apart(int bits);

static inline num_wide span_shift(num_wide x, int s)
{
    return FLASH_IS_SCARCE ? span_shift_apart(x, s) : num_shift(x, s);
}

static inline struct num_vec span_difference(const struct num_vec *a, const struct num_vec *b)
{
    return FLASH_IS_SCARCE ? span_difference_apart(a, b) : num_vec_sub(*a, *b);
}

static inline num_wide span_square30(const struct num_vec *a)
{
    return FLASH_IS_SCARCE ? span_square30_apart(a) : num_square30(*a);
}

static inline int span_bits(num_wide x)
{
    return FLASH_IS_SCARCE ? span_bits_apart(x) : num_bits(x);
}

static inline num_wide span_power(int bits)
{
    return FLASH_IS_SCARCE ? span_power_apart(bits) : num_bound(bits);
}

#endif
