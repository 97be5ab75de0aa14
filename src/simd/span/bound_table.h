/* bound_table.h - every error bound of the spans by name, with its derivation; the tables are in bounds/, one a
 * subject, and simd/bound.h explains their rows.
 *
 * In the tables "there" is the integer code: see render/span/kernels.h for its forms, and run.h for those of the
 * kernels. u is the unit of an arithmetic, its largest relative rounding: 2^-24 for the kernels' floats, 2^-48 for
 * exact.c. e_s and e_t are the relative bounds of 1/t, by the kernels and there; e_w and e_c those of |w|^2, relative,
 * and of the cosine r N.w/(r |w|), absolute. T is the mantissa of t, below 2^31.
 *
 * There an accumulator's upper half is rounded to nearest, apart from the halves of 2^-32 that 64 steps and the way
 * from the picture's middle add: 2^-18 of its last bit. Shifts are rounded to nearest, products of mantissas are exact,
 * roots are rounded down; a reciprocal is within 1.02 2^-31 of itself, an inverse root within 2^-30. */
#ifndef TIA_SIMD_SPAN_BOUND_TABLE_H
#define TIA_SIMD_SPAN_BOUND_TABLE_H

#include "proved.h"
#include "simd/bound.h"

#include "bounds/cells.h"
#include "bounds/depths.h"
#include "bounds/levels.h"
#include "bounds/shadows.h"

#endif
