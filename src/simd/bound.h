/* bound.h - rows of the tables of error bounds, and the macros by which code takes a bound by its name.
 *
 * A row is either a constant, `#define BOUND_NAME value`, which code takes as BOUND(NAME), or `FORMULA(NAME);`. The
 * expression of a formula is in the code: BOUND_OF(NAME, expression) or, for floats of isa/isa.h, BOUND_OF_FLOATS().
 * The comment above a row is the derivation: it counts the roundings, or names the file of tests/proofs by which Gappa
 * proves the value. "3 of 8" means that the derivation needs 3 of the value's 8 units. tests/quick/bounds checks this
 * form.
 *
 * "Unseen" marks a bound that can be left out without any test noticing it (make check-bounds), and gives the reason.
 * Small: the other terms of the sum are far larger in all tests. Hidden: the quantity becomes part of a value, a
 * sample's radiance or a pixel's level, whose bound is far above its largest error. Choice: another value leaves more
 * or less to the fixed-point path, and is correct as well.
 *
 * A new bound needs a row with its derivation, BOUND() or BOUND_OF() in the code, and a test that notices when it is
 * left out.
 *
 * A test's build defines BOUND_SCALES as the name of a header that declares bound_scale_of(). Each bound is then
 * multiplied by the factor that this function returns for the bound's name. In any other build BOUND(NAME) is the
 * value. */
#ifndef TIA_SIMD_BOUND_H
#define TIA_SIMD_BOUND_H

#define FORMULA(name) enum { FORMULA_##name }

#ifdef BOUND_SCALES
#include BOUND_SCALES
/* Looks up the address of the factor once for each use in the code. */
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
