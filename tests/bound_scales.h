/* bound_scales.h - the bounds of src/simd and src/render/span by name, each with a factor. src/simd/bound.h,
 * span_proved.h, steps_proved.h and words_proved.h include this file if BOUND_SCALES is defined. tests/bounds scales
 * one bound of a whole program by TIA_BOUND=NAME and TIA_BOUND_SCALE=x in the environment; test_ray_bounds --uses does
 * so within the program. */
#ifndef TIA_TESTS_BOUND_SCALES_H
#define TIA_TESTS_BOUND_SCALES_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BOUNDS_MAX 512

struct scaled_bound {
    const char *name;
    double scale;
};

/* The bounds of this translation unit that were reached so far. */
static struct scaled_bound scaled_bounds[BOUNDS_MAX];
static int scaled_bound_count;

static double first_scale(const char *name)
{
    const char *scaled = getenv("TIA_BOUND"), *scale = getenv("TIA_BOUND_SCALE");

    return scaled && scale && strcmp(scaled, name) == 0 ? strtod(scale, NULL) : 1;
}

/* Returns the address of a bound's factor, which is 1 until a test changes it. */
static inline double *bound_scale_of(const char *name)
{
    for (int i = 0; i < scaled_bound_count; i++)
        if (strcmp(scaled_bounds[i].name, name) == 0)
            return &scaled_bounds[i].scale;
    if (scaled_bound_count == BOUNDS_MAX) {
        (void)fputs("bound_scales.h: more than BOUNDS_MAX bounds\n", stderr);
        abort();
    }
    scaled_bounds[scaled_bound_count] = (struct scaled_bound){name, first_scale(name)};
    return &scaled_bounds[scaled_bound_count++].scale;
}

/* Returns the whole number to add to a bound that is the logarithm of a power of two: log2 of its factor, rounded up;
 * -64 for the factor 0. */
static inline int bound_bits_of(const char *name)
{
    double scale = *bound_scale_of(name);

    return scale > 0 ? (int)ceil(log2(scale)) : -64;
}

/* Returns what to add to a bound that is a binary logarithm in 256ths: the logarithm of its factor, rounded up; -64
 * bits for the factor 0. */
static inline int bound_log_of(const char *name)
{
    double scale = *bound_scale_of(name);

    return scale > 0 ? (int)ceil(256 * log2(scale)) : -64 * 256;
}

/* Scales a bound that is an integer or, in the floating-point builds, a real number. */
#define BOUND_SCALED(name, x) ((__typeof__(x))((long double)(x) * (long double)*bound_scale_of(name)))

#endif
