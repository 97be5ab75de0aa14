/* span_shift.h - functions of num.h that are called in many places: one copy of each, as flash is scarce. */
#ifndef TIA_RENDER_SPAN_SHIFT_H
#define TIA_RENDER_SPAN_SHIFT_H

#include "num/num.h"

/* num_shift, num_dot, num_square30, num_bits and num_bound. */
num_wide span_shift(num_wide x, int s);
num_wide span_dot(const struct num_vec *a, const struct num_vec *b);
num_wide span_square30(const struct num_vec *a);
int span_bits(num_wide x);
num_wide span_power(int bits);

#endif
