/* bounds.h - the error bounds of the rays, each with a name and a derivation. Each table in bounds/ has one subject;
 * simd/bound.h explains the rows.
 *
 * u is 2^-53, the largest relative rounding error of a double; U is 2^-45, the unit of fixed-point lengths; fixed-point
 * cosines have the unit 2^-62. |x| is the length of a vector; |x|1 is the sum of the absolute values of its
 * components, which is at least |x|. Fixed-point sums are exact. Products are rounded by at most half a unit, quotients
 * by half a unit and 2^-59 of their value; square roots are truncated to a unit. Normalised vectors are within 2^-58
 * (math/wide.h). In the tables, "in fixed point" means the fixed-point code, and "in doubles" the code of these
 * templates. A prime marks a fixed-point value. */
#ifndef TIA_SIMD_RAYS_BOUNDS_H
#define TIA_SIMD_RAYS_BOUNDS_H

#include "proved.h"
#include "simd/bound.h"
#include "sure.h"

#include "bounds/lights.h"
#include "bounds/meshes.h"
#include "bounds/paths.h"
#include "bounds/pictures.h"
#include "bounds/rounds.h"
#include "bounds/scatter.h"
#include "bounds/shapes.h"
#include "bounds/sights.h"
#include "bounds/surfaces.h"
#include "bounds/vectors.h"

#endif
