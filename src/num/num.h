/* num.h - the only file that knows one arithmetic from another.
 *
 * The core is compiled once for each arithmetic: q16 (integers, the product), f64 (double, the
 * reference), f32 (float, for comparison) and chk (q16 that reports what leaves its range).
 *
 * Block floating point. A quantity of a frame - a product with the pixel's direction, a distance
 * along the ray - keeps one scale for the frame, chosen when its constants are prepared so that
 * its largest value just fits: value = mantissa * 2^-exponent, the exponent an int kept beside
 * the constants. In the floating builds a mantissa is the value itself and shifts do nothing,
 * so the same source says both.
 *
 *   num       signed mantissa, below 2^31             num_wide   exact product of two, or a
 *   num_u     unsigned mantissa, below 2^32                      coordinate or dot product
 *
 * Sums, differences and comparisons are the language's own. What is a call:
 *
 *   num_coordinate(q)      a Q16.16 coordinate as num_wide, exponent 16
 *   num_pixel_coordinate(n, f)      the integer n as num_wide, exponent f
 *   num_signed(t)          an unsigned mantissa as a signed one
 *   num_mul, num_mul_u     the exact product of two mantissas
 *   num_bits(x)            the length of |x| in bits: |x| < 2^num_bits(x)
 *   num_shift(x, s)        x * 2^s, rounded to nearest, ties up, when s < 0
 *   num_down(x, s)         the same with -s, s in 0..63, for the kernels
 *   num_top, num_top_u     the upper half of an accumulator, that is x * 2^-32, rounded down;
 *                          accumulators start with NUM_HALF so that this rounds to nearest
 *   num_sqrt(x)            the square root, rounded down
 *   num_quotient(a, b, s)  a/b * 2^(63 - s), see there
 *   num_normal(x)          1/sqrt(x) with what normalises x
 */
#ifndef TIA_NUM_H
#define TIA_NUM_H

#if defined TIA_NUM_F64
#include "num_f64.h"
#elif defined TIA_NUM_F32
#include "num_f32.h"
#elif defined TIA_NUM_CHK
#include "num_chk.h"
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

/* Exact as long as |a| |b| < 2^63: two products that add up to more never meet, by Cauchy. */
static inline num_wide num_dot(struct num_vec a, struct num_vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* |v|^2 with exponent 30, but for the last two bits; |v| < 65536. */
static inline num_wide num_square30(struct num_vec v)
{
    return num_sum_of_squares30(v.x, v.y, v.z);
}

/* A shift count as num_down takes it: what is shifted farther is 0 all the same. */
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

static inline num_wide num_max(num_wide a, num_wide b)
{
    return a < b ? b : a;
}

#endif
