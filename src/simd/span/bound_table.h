/* bound_table.h - every error bound of the spans by name, with its derivation; the tables are in bounds/, one for each
 * subject, and simd/bound.h explains their rows.
 *
 * render/span/kernels.h has the integer code's forms, run.h those of the kernels. u is the rounding unit of an
 * arithmetic, its largest relative rounding: 2^-24 for the kernels' floats, 2^-48 for the doubles of exact.c. X is the
 * largest |x| of a run. e_s and e_t bound the relative errors of 1/t in the kernels and of t in the integer code. e_w
 * bounds the relative error of |w|^2, e_c the absolute error of the cosine r N.w/(r |w|). T is the mantissa of t in the
 * integer code, below 2^31.
 *
 * The integer code rounds the upper half of an accumulator to nearest. Each step of the accumulator adds a rounding of
 * 2^-33 of the upper half's last bit; over 64 steps, and from the picture's middle, these add up to at most 2^-18 of
 * that bit. Shifts are rounded to nearest, products of mantissas are exact, roots are rounded down. A reciprocal has a
 * relative error of at most 1.02 2^-31, an inverse root of 2^-30. */
#ifndef TIA_SIMD_SPAN_BOUND_TABLE_H
#define TIA_SIMD_SPAN_BOUND_TABLE_H

#include "proved.h"
#include "simd/bound.h"

#include "bounds/cells.h"
#include "bounds/depths.h"
#include "bounds/levels.h"
#include "bounds/shadows.h"

#endif
