/* bound.h - rows of the tables of error bounds, and the macros that give code a bound by its name.
 *
 * A row is `#define BOUND_NAME value`, a constant that code takes as BOUND(NAME), or `FORMULA(NAME);`, whose expression
 * stands in the code as BOUND_OF(NAME, expression) and whose derivation stands in the row; BOUND_OF_FLOATS() is the
 * same for floats of isa/isa.h. The comment above a row counts the roundings, or names the file of tests/proofs by
 * which Gappa proves the value. "3 of 8" is the part of the value that the derivation needs. tests/quick/bounds checks
 * this form.
 *
 * "Unseen" says that no test notices when the bound is left out (make check-bounds), and the reason. Small: the
 * other terms of the sum are far larger in all tests. Hidden: the quantity ends in a value, a sample's radiance or a
 * pixel's level, whose bound is far above its largest error. Choice: with another value more is left to the fixed-point
 * path, or less, and neither is wrong.
 *
 * A new bound needs a row with its derivation, BOUND() or BOUND_OF() in the code, and a test that notices when it is
 * left out.
 *
 * A build that defines BOUND_SCALES, the header of the tests that has bound_scale_of(), multiplies each bound by the
 * factor that this returns for its name; in any other build BOUND(NAME) is the value. */
#ifndef TIA_SIMD_BOUND_H
#define TIA_SIMD_BOUND_H

#define FORMULA(name) enum { FORMULA_##name }

#ifdef BOUND_SCALES
#include BOUND_SCALES
/* Looks the factor's address up once for each use in the code. */
#define BOUND_SCALE(name)                                                                                              \
    (*__extension__({                                                                                                  \
        static const double *scale_of_##name;                                                                          \
        if (!scale_of_##name)                                                                                          \
            scale_of_##name = bound_scale_of(#name);                                                                   \
        scale_of_##name;                                                                                               \
    }))
#define BOUND(name) (BOUND_SCALE(name) * BOUND_##name)
#define BOUND_OF(name, ...) (BOUND_SCALE(name) * ((void)FORMULA_##name, (__VA_ARGS__)))
#define BOUND_OF_FLOATS(name, ...) f_mul(f_set((float)BOUND_SCALE(name)), ((void)FORMULA_##name, (__VA_ARGS__)))
#else
#define BOUND(name) BOUND_##name
#define BOUND_OF(name, ...) ((void)FORMULA_##name, (__VA_ARGS__))
#define BOUND_OF_FLOATS(name, ...) ((void)FORMULA_##name, (__VA_ARGS__))
#endif

#endif
