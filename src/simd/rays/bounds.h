/* bounds.h - every error bound of the rays by name, with its derivation; the tables are in bounds/, one a subject, and
 * simd/bound.h explains their rows.
 *
 * u is 2^-53, the largest relative rounding of a double, and U is 2^-45, a unit of the fixed-point lengths; v is 2^-62,
 * a unit of the fixed-point cosines. |x| is a length, |x|1 the sum of a vector's components' sizes, which is larger.
 * Fixed-point sums are exact, products rounded by half a unit, quotients by half a unit and 2^-59 of themselves, square
 * roots cut to a unit; a vector is normalised within 2^-58 (math/wide.h). In the tables "there" is the fixed-point code
 * and "by doubles" the code of these templates. */
#ifndef TIA_SIMD_RAYS_BOUNDS_H
#define TIA_SIMD_RAYS_BOUNDS_H

#include "proved.h"
#include "simd/bound.h"
#include "sure.h"

#include "bounds/lights.h"
#include "bounds/paths.h"
#include "bounds/pictures.h"
#include "bounds/rounds.h"
#include "bounds/shapes.h"
#include "bounds/surfaces.h"
#include "bounds/vectors.h"

#endif
