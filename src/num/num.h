/* num.h - the numbers of the span renderer, in the arithmetic that this build is compiled for.
 *
 * README.md explains how one source serves several arithmetics.
 *
 * Block floating point: value = mantissa * 2^-exponent. Mantissas are stored per pixel. Their common exponent is an int
 * among the frame's constants, chosen so that the largest value in the frame just fits. This uses nearly all bits of a
 * 32-bit word without the cost of floating point per pixel. In the floating builds the mantissa is the value itself and
 * shifts do nothing.
 *
 *   num       signed mantissa, below 2^31             num_wide   exact product of two mantissas, a
 *   num_u     unsigned mantissa, below 2^32                      coordinate or a dot product
 *
 * Add, subtract and compare with the operators of C. For all else, call:
 *
 *   num_coordinate(q)      a Q16.16 coordinate as num_wide, exponent 16
 *   num_pixel_coordinate(n, f)      the integer n as num_wide, exponent f
 *   num_signed(t)          an unsigned mantissa as a signed one
 *   num_mul, num_mul_u     the exact product of two mantissas
 *   num_square(x)          x^2 of a pixel coordinate or of a radius, |x| < 2^31
 *   num_bits(x)            the length of |x| in bits: |x| < 2^num_bits(x)
 *   num_shift(x, s)        x * 2^s; for s < 0 rounded to nearest, ties up
 *   num_up(x, s)           x * 2^s for s in 0..31, faster
 *   num_down(x, s)         x * 2^-s for s in 0..63, rounded like num_shift, but faster: for kernels
 *   num_top, num_top_u     the upper half of an accumulator, x * 2^-32 rounded down; initialise the
 *                          accumulator with NUM_HALF to round to nearest
 *   num_sqrt(x)            the square root, rounded down
 *   num_quotient(a, b, s)  a/b * 2^(63 - s), rounded to nearest
 *   num_normal(x)          x normalised, and 1/sqrt(x)
 *   num_bound(b)           2^b rounded up, at most 2^62: an error bound of the integer build; 0 in the floating builds
 */
#ifndef TIA_NUM_NUM_H
#define TIA_NUM_NUM_H

#if defined TIA_NUM_F64
#include "num_f64.h"
#elif defined TIA_NUM_F32
#include "num_f32.h"
#elif defined TIA_NUM_F128
#include "num_f128.h"
#elif defined TIA_NUM_CHK
#include "num_chk.h"
#elif defined TIA_WATCHED
#include "num_watched.h"
#else
#include "num_q16.h"
#endif

/* A vector of coordinates relative to the eye (exponent 16) or of pixel coordinates. */
struct num_vec {
    num_wide x, y, z;
};

static inline struct num_vec num_vec_between(struct tia_vec3 from, struct tia_vec3 to)
{
    struct num_vec v = {num_coordinate(to.x) - num_coordinate(from.x), num_coordinate(to.y) - num_coordinate(from.y),
                        num_coordinate(to.z) - num_coordinate(from.z)};
    return v;
}

static inline struct num_vec num_vec_add(struct num_vec a, struct num_vec b)
{
    struct num_vec v = {a.x + b.x, a.y + b.y, a.z + b.z};
    return v;
}

static inline struct num_vec num_vec_sub(struct num_vec a, struct num_vec b)
{
    struct num_vec v = {a.x - b.x, a.y - b.y, a.z - b.z};
    return v;
}

/* Returns the dot product, exact as long as |a| |b| < 2^63: by the Cauchy-Schwarz inequality no partial sum is larger.
 */
static inline num_wide num_dot(struct num_vec a, struct num_vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* Returns |v|^2 with exponent 30, rounded down from the exact exponent 32; |v| < 65536. */
static inline num_wide num_square30(struct num_vec v)
{
    return num_sum_of_squares30(v.x, v.y, v.z);
}

/* Returns a shift count clamped to num_down's range. A larger count would give 0 as well. */
static inline int num_count(int s)
{
    return s < 63 ? s : 63;
}

static inline num_wide num_abs(num_wide x)
{
    return x < 0 ? -x : x;
}

static inline num_u num_clamp(num_u colour)
{
    return colour < NUM_ONE ? colour : NUM_ONE;
}

static inline int num_larger(int a, int b)
{
    return a < b ? b : a;
}

static inline int num_limited(int a, int least, int most)
{
    return a < least ? least : a < most ? a : most;
}

static inline num_wide num_max(num_wide a, num_wide b)
{
    return a < b ? b : a;
}

#endif
