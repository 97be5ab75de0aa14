/* bounds.h - every error bound of the rays by name, with its derivation; the tables are in bounds/, one a subject.
 *
 * A row is `#define BOUND_NAME value`, a constant that code takes as BOUND(NAME), or `FORMULA(NAME);`, whose expression
 * stands in the code as BOUND_OF(NAME, expression) and whose derivation stands here. The comment above a row counts the
 * roundings, or names the file of tests/proofs by which Gappa proves the value. "3 of 8" is the part of the value that
 * the derivation needs. tests/quick/bounds checks this form.
 *
 * u is 2^-53, the largest relative rounding of a double, and U is 2^-45, a unit of the fixed-point lengths; v is 2^-62,
 * a unit of the fixed-point cosines. |x| is a length, |x|1 the sum of a vector's components' sizes, which is larger.
 * Fixed-point sums are exact, products rounded by half a unit, quotients by half a unit and 2^-59 of themselves, square
 * roots cut to a unit; a vector is normalised within 2^-58 (math/wide.h). In the tables "there" is the fixed-point code
 * and "by doubles" the code of these templates.
 *
 * "Unseen" says that no test notices when the bound is left out (make check-bounds), and the reason. Small: what else
 * is in the sum is far larger in all that tests draw. Hidden: it ends in a sample's radiance, whose bound is far above
 * what that is ever off by. Choice: with another value more rays are left to the fixed-point path, or fewer, and
 * neither is wrong.
 *
 * A new bound needs a row with its derivation, BOUND() or BOUND_OF() in the code, and a test that notices when it is
 * left out.
 *
 * A build that defines BOUND_SCALES, the header of the tests that has bound_scale_of(), multiplies each bound by the
 * factor that this returns for its name; in any other build BOUND(NAME) is the value. */
#ifndef TIA_SIMD_RAYS_BOUNDS_H
#define TIA_SIMD_RAYS_BOUNDS_H

#include "proved.h"
#include "sure.h"

#define FORMULA(name) enum { FORMULA_##name }

#include "bounds/lights.h"
#include "bounds/paths.h"
#include "bounds/pictures.h"
#include "bounds/rounds.h"
#include "bounds/shapes.h"
#include "bounds/surfaces.h"
#include "bounds/vectors.h"

#ifdef BOUND_SCALES
#include BOUND_SCALES
/* The factor's place is looked up once for each place in the code. */
#define BOUND_SCALE(name)                                                                                              \
    (*__extension__({                                                                                                  \
        static const double *scale_of_##name;                                                                          \
        if (!scale_of_##name)                                                                                          \
            scale_of_##name = bound_scale_of(#name);                                                                   \
        scale_of_##name;                                                                                               \
    }))
#define BOUND(name) (BOUND_SCALE(name) * BOUND_##name)
#define BOUND_OF(name, ...) (BOUND_SCALE(name) * ((void)FORMULA_##name, (__VA_ARGS__)))
#else
#define BOUND(name) BOUND_##name
#define BOUND_OF(name, ...) ((void)FORMULA_##name, (__VA_ARGS__))
#endif

#endif
