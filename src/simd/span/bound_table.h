/* bound_table.h - every error bound of the spans by name, with its derivation; the tables are in bounds/, one for each
 * subject, and simd/bound.h explains their rows.
 *
 * An error is the difference of a computed value from the exact value of docs/definition.md. run.h has the kernels'
 * forms. u is the rounding unit of an arithmetic, its largest relative rounding: 2^-24 for the kernels' floats, 2^-53
 * for doubles. X is the largest |x| of a run. e_s bounds the relative error of 1/t in the kernels, and e_t the error of
 * P that the error of K causes, as a share of |P|. e_w bounds the relative error of |w|^2, e_c the absolute error of
 * the cosine r N.w/(r |w|).
 *
 * Directions are (v_x, v_y, -K), where v_x and v_y are integers in units of pixel coordinates and K = height
 * cot(fov/2); in K s of run.h K is c - L.Q. K0 is K rounded to an integer. With K0 in the place of K, sums of products
 * are computed in integers, so that their terms cancel without loss. What K - K0 contributes is added in doubles
 * (sums.h, row.c). So the error of K is that of 64 bits. */
#ifndef TIA_SIMD_SPAN_BOUND_TABLE_H
#define TIA_SIMD_SPAN_BOUND_TABLE_H

#include "proved.h"
#include "simd/bound.h"

#include "bounds/cells.h"
#include "bounds/depths.h"
#include "bounds/levels.h"
#include "bounds/pixels.h"
#include "bounds/shadows.h"

#endif
