/* num_real.h - num.h's operations in the floating-point type `num_real`, for num_f64.h, num_f32.h and num_f128.h. A
 * mantissa is the value itself here; exponents are ignored, and shifts do nothing. `num_double` is num_real, or double
 * where that is finer. */
#ifndef TIA_NUM_NUM_REAL_H
#define TIA_NUM_NUM_REAL_H

#include "names.h"
#include <tia/render.h>

typedef num_real num, num_u, num_wide, num_uwide;

#define NUM_HALF ((num_real)0)
#define NUM_ONE ((num_real)1)
#define NUM_ROUND ((num_real)0.5)
#define NUM_LEAST ((num_real)1e-30)
#define NUM_BIAS ((num_real)(1.0 / 8192))

static inline num_wide num_coordinate(tia_q16 q)
{
    return (num_real)q / 65536;
}

static inline num_wide num_pixel_coordinate(int32_t n, int exponent)
{
    (void)exponent;
    return (num_real)n;
}

static inline num_wide num_depth(uint32_t height, uint64_t cotangent, int exponent)
{
    (void)exponent;
    return (num_real)height * ((num_real)cotangent / 72057594037927936.0f); /* times cotangent/2^56 */
}

static inline num_u num_colour(tia_q30 c)
{
    return (num_real)c / 1073741824;
}

static inline num_u num_colour_product(num_u a, num_u b)
{
    return a * b;
}

static inline num num_signed(num_u t)
{
    return t;
}

static inline num_wide num_mul(num a, num b)
{
    return a * b;
}

static inline num_wide num_square(num_wide x)
{
    return x * x;
}

static inline num_uwide num_mul_u(num_u a, num_u b)
{
    return a * b;
}

static inline int num_bits(num_wide x)
{
    (void)x;
    return 0;
}

static inline num_wide num_shift(num_wide x, int s)
{
    (void)s;
    return x;
}

static inline num_wide num_up(num_wide x, int s)
{
    (void)s;
    return x;
}

static inline num_wide num_down(num_wide x, int s)
{
    (void)s;
    return x;
}

static inline num num_top(num_wide x)
{
    return x;
}

static inline num_u num_top_u(num_wide x)
{
    return x;
}

static inline num_uwide num_excess(num_uwide a, num_uwide b)
{
    return a > b ? a - b : 0;
}

static inline num_u num_sqrt(num_uwide x)
{
    return num_root(x);
}

static inline num_u num_quotient(num_u a, num_u b, int s)
{
    (void)s;
    return a / b;
}

struct num_normal {
    num_uwide mantissa;
    num_u inverse;
    int half;
};

static inline struct num_normal num_normal(num_wide x)
{
    struct num_normal n = {x, 1 / num_root(x), 0};
    return n;
}

static inline num_u num_normal_top(struct num_normal n)
{
    return n.mantissa;
}

static inline num_u num_inverse(num_wide r)
{
    return 1 / r;
}

static inline num_wide num_bound(int bits)
{
    (void)bits;
    return 0;
}

static inline bool num_product_above(num_wide a, num_wide b, num_wide c, num_wide d)
{
    return a * b > c * d;
}

static inline num_wide num_sum_of_squares30(num_wide a, num_wide b, num_wide c)
{
    return a * a + b * b + c * c;
}

static inline num_u num_scale(num_wide x, int s)
{
    (void)s;
    return x;
}

static inline num_u num_scale_within(num_wide x, int s)
{
    (void)s;
    return x;
}

static inline num_u num_mul_top(num_u a, num_u b)
{
    return a * b;
}

static inline num_u num_lambert(num_u scaled, num_u inverse)
{
    return scaled * inverse;
}

static inline num_u num_swell(num_u inverse, int bits, bool inside)
{
    (void)bits;
    return inside ? 1 - inverse * NUM_BIAS : 1 + inverse * NUM_BIAS;
}

static inline num_wide num_bias_product(num_u facing, num_u inverse, int s)
{
    (void)s;
    return facing * inverse * NUM_BIAS;
}

static inline num_wide num_bias_of(num_wide x, num_u inverse, int bits, int e)
{
    (void)bits;
    (void)e;
    return x * inverse * NUM_BIAS;
}

static inline unsigned num_quantise(num_u c, unsigned levels, num_u threshold)
{
    return (unsigned)(c * (num_real)levels + threshold);
}

static inline num_u num_threshold(unsigned n)
{
    return ((num_real)n + (num_real)0.5) / 64;
}

static inline bool num_nearer(num_u t, int e, num_u u, int f)
{
    (void)e;
    (void)f;
    return t < u;
}

static inline bool num_is_within(num_wide x, num_wide y, num_wide z, num_wide r)
{
    return x * x + y * y + z * z <= r * r;
}

#include "num_certain_real.h"

#endif
