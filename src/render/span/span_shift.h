/* span_shift.h - functions of num.h that are called in many places: one copy of each, as flash is scarce. */
#ifndef TIA_RENDER_SPAN_SHIFT_H
#define TIA_RENDER_SPAN_SHIFT_H

#include "num/num.h"

/* num_shift, num_vec_add, num_vec_sub, num_dot, num_square30, num_bits and num_bound. */
num_wide span_shift(num_wide x, int s);
struct num_vec span_sum(const struct num_vec *a, const struct num_vec *b);
struct num_vec span_difference(const struct num_vec *a, const struct num_vec *b);
num_wide span_dot(const struct num_vec *a, const struct num_vec *b);
num_wide span_square30(const struct num_vec *a);
bool span_product_above(num_wide a, num_wide b, num_wide c, num_wide d);
bool span_is_within(const struct num_vec *a, num_wide r);
num_wide span_bias_of(num_wide x, num_u inverse, int bits, int e);
num_u span_swell(num_u inverse, int bits, bool inside);
int span_bits(num_wide x);
num_wide span_power(int bits);

#endif
