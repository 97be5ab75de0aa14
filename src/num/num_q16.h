/* num_q16.h - integers: Q16.16 coordinates, 31-bit mantissas, 64-bit products. */
#ifndef TIA_NUM_NUM_Q16_H
#define TIA_NUM_NUM_Q16_H

#ifndef NUM_NAME
#define NUM_NAME "q16"
#define NUM_PREFIX tia_
#define NUM_CORE tia_core_q16
#define NUM_ESTIMATOR tia_estimator_q16
#define NUM_CHECK(condition) ((void)0) /* num_chk.h defines it otherwise */
#endif

#include "names.h"
#include <tia/render.h>

#include "math/integer.h"

typedef int32_t num;
typedef uint32_t num_u;
typedef int64_t num_wide;
typedef uint64_t num_uwide;

#define NUM_HALF ((num_wide)1 << 31)
#define NUM_ONE ((num_u)1 << 30)   /* 1.0 as a colour, Q2.30 */
#define NUM_ROUND ((num_u)1 << 29) /* with this threshold num_quantise rounds to nearest */

static inline num_wide num_coordinate(tia_q16 q)
{
    return q;
}

/* Returns n 2^exponent, which is below 2^31. */
static inline num_wide num_pixel_coordinate(int32_t n, int exponent)
{
    NUM_CHECK(exponent >= 0 && exponent <= 30 && (n < 0 ? -(num_wide)n : n) >> (31 - exponent) == 0);
    return (int32_t)((uint32_t)n << exponent);
}

/* Returns height * cotangent with the given exponent, 0..43; cotangent is Q8.56 and below 2^7. */
static inline num_wide num_depth(uint32_t height, uint64_t cotangent, int exponent)
{
    NUM_CHECK(exponent >= 0 && exponent <= 43);
    return tia_round_shift((num_wide)(height * (cotangent >> 13)), (unsigned)(43 - exponent));
}

static inline num_u num_colour(tia_q30 c)
{
    return (num_u)c;
}

/* Returns the product of two colours, each at most 2, Q2.30, rounded to nearest. */
static inline num_u num_colour_product(num_u a, num_u b)
{
    NUM_CHECK(a <= (num_u)1 << 31 && b <= (num_u)1 << 31);
    return (num_u)((tia_mul_u32(a, b) + ((uint64_t)1 << 29)) >> 30);
}

/* Returns a mantissa below 2^31 as a signed one. */
static inline num num_signed(num_u t)
{
    NUM_CHECK(t >> 31 == 0);
    return (num)t;
}

static inline num_wide num_mul(num a, num b)
{
    return tia_mul_s32(a, b);
}

static inline num_uwide num_mul_u(num_u a, num_u b)
{
    return tia_mul_u32(a, b);
}

static inline int num_bits(num_wide x)
{
    uint64_t magnitude = x < 0 ? 0 - (uint64_t)x : (uint64_t)x;
    return magnitude ? 64 - (int)tia_clz64(magnitude) : 0;
}

static inline num_wide num_square(num_wide x)
{
    NUM_CHECK(num_bits(x) <= 31);
    return num_mul((num)x, (num)x);
}

static inline num_wide num_shift(num_wide x, int s)
{
    NUM_CHECK(s <= -63 || (s < 0 ? num_bits(x) <= 63 : num_bits(x) + s <= 63));
    if (s >= 0 && TIA_SHIFTS_WORDS)
        return (num_wide)(s < 32 ? tia_shift_up((uint64_t)x, (unsigned)s) : (uint64_t)x << s);
    if (s >= 0)
        return s == 0 ? x : (num_wide)((uint64_t)x << s); /* s = 0, between equal exponents, is common */
    if (s < -63)
        return 0;
    return TIA_SHIFTS_WORDS ? tia_round_shift_words(x, (unsigned)-s) : tia_round_shift(x, (unsigned)-s);
}

/* Returns x * 2^s; s in 0..31. */
static inline num_wide num_up(num_wide x, int s)
{
    NUM_CHECK(s >= 0 && s <= 31 && num_bits(x) + s <= 63);
    return (num_wide)tia_shift_up((uint64_t)x, (unsigned)s);
}

/* Returns x * 2^-s, rounded to nearest, ties up; s in 0..63. */
static inline num_wide num_down(num_wide x, int s)
{
    NUM_CHECK(s >= 0 && s <= 63);
    if (!TIA_SHIFTS_WORDS)
        return tia_round_shift(x, (unsigned)s);
    return s > 0 ? tia_round_shift_words(x, (unsigned)s) : x;
}

static inline num num_top(num_wide x)
{
    return (num)(x >> 32);
}

static inline num_u num_top_u(num_wide x)
{
    NUM_CHECK(x >= 0);
    return (num_u)((num_uwide)x >> 32);
}

/* Returns max(0, a - b). */
static inline num_uwide num_excess(num_uwide a, num_uwide b)
{
    return a > b ? a - b : 0;
}

static inline num_u num_sqrt(num_uwide x)
{
    return tia_sqrt64(x);
}

/* Returns a/b * 2^(63 - s), rounded to nearest; b > 0, and the result must be below 2^32. The reciprocal of b has a
 * relative error of 2^-31. */
static inline num_u num_quotient(num_u a, num_u b, int s)
{
    NUM_CHECK(b > 0);
    unsigned z = tia_clz32(b);
    int shift = s - (int)z;
    num_uwide product = num_mul_u(a, tia_reciprocal(b << z));
    NUM_CHECK(a == 0 || (shift >= 1 && (shift > 63 || product >> shift <= INT32_MAX)));
    if (TIA_SHIFTS_WORDS && shift > 32) /* almost always, as the result is below 2^32 */
        return (((num_u)(product >> 32) >> (shift < 63 ? shift - 33 : 30)) + 1) >> 1;
    shift = shift < 1 ? 1 : shift > 63 ? 63 : shift;
    return (num_u)(((product >> (shift - 1)) + 1) >> 1);
}

/* A normalised number x > 0: mantissa = x * 4^half in [2^62, 2^64), inverse = 2^63 / sqrt(mantissa). */
struct num_normal {
    num_uwide mantissa;
    num_u inverse;
    int half;
};

static inline struct num_normal num_normal(num_wide x)
{
    NUM_CHECK(x > 0);
    unsigned z = tia_clz64((uint64_t)x) & ~1u;
    struct num_normal n = {tia_shift_to_top((uint64_t)x, z), 0, (int)(z / 2)};
    n.inverse = tia_rsqrt(n.mantissa);
    return n;
}

/* Returns the reciprocal of a radius with the exponent 16, as 2^63 / (r normalised to 32 bits). */
static inline num_u num_inverse(num_wide r)
{
    NUM_CHECK(r > 0 && r <= UINT32_MAX);
    return tia_reciprocal((uint32_t)r << tia_clz32((uint32_t)r));
}

static inline num_wide num_bound(int bits)
{
    return (num_wide)1 << (bits < 0 ? 0 : bits < 62 ? bits : 62);
}

/* True if a b > c d, exactly; b >= 0 and c > 0. */
static inline bool num_product_above(num_wide a, num_wide b, num_wide c, num_wide d)
{
    NUM_CHECK(b >= 0 && c > 0);
    if (a > 0 ? d < 0 : d >= 0)
        return a > 0;
    int order = tia_cmp_products((uint64_t)(a > 0 ? a : -a), (uint64_t)b, (uint64_t)c, (uint64_t)(d < 0 ? -d : d));
    return a > 0 ? order > 0 : order < 0;
}

/* Returns x * 2^s, x >= 0, as a mantissa; the result must fit. */
static inline num_u num_scale(num_wide x, int s)
{
    NUM_CHECK(x >= 0 && num_bits(num_shift(x, s)) <= 32);
    return TIA_SHIFTS_WORDS && s < 0 && s >= -63 ? tia_round_shift_low((num_uwide)x, (unsigned)-s)
                                                 : (num_u)num_shift(x, s);
}

/* Returns x * 2^s, x >= 0, as a mantissa; UINT32_MAX from 2^32 on. It must not be rounded up to 2^32. */
static inline num_u num_scale_within(num_wide x, int s)
{
    NUM_CHECK(x >= 0);
    if (!TIA_SHIFTS_WORDS || s >= 0 || s < -63)
        return num_bits(x) + s > 32 ? UINT32_MAX : (num_u)num_shift(x, s);
    return s > -32 && (num_u)(x >> 32) >> -s ? UINT32_MAX : tia_round_shift_low((num_uwide)x, (unsigned)-s);
}

/* Returns the upper half of the product a b, rounded to nearest. */
static inline num_u num_mul_top(num_u a, num_u b)
{
    return (num_u)((num_mul_u(a, b) + (num_uwide)NUM_HALF) >> 32);
}

/* Returns the upper 32 bits of the normalised number's mantissa. */
static inline num_u num_normal_top(struct num_normal n)
{
    return (num_u)(n.mantissa >> 32);
}

/* Returns a cosine, at most 1, from r N.w/|w| in the scale of span/span_light.c and the inverse of the radius r. */
static inline num_u num_lambert(num_u scaled, num_u inverse)
{
    num_uwide cosine = num_mul_u(scaled, inverse) + ((num_uwide)1 << 30); /* with the exponent 61 */
    return cosine >> 61 ? NUM_ONE : (num_u)(cosine >> 31);
}

/* Biases: shadow rays start at a distance bias = 2^-13 from the surface, and the sphere kernels need bias/r. With R =
 * 2^16 r and inverse = num_inverse(R) = 2^(31 + num_bits(R)) / R, bias/r is 2^(-28 - num_bits(R)) inverse. */

/* Returns 1 + bias/r, or 1 - bias/r from inside, with the exponent 31, from num_inverse of a radius of `bits` bits. */
static inline num_u num_swell(num_u inverse, int bits, bool inside)
{
    NUM_CHECK(num_bits(num_shift(inverse, 3 - bits)) <= 29);
    num_u bias = (num_u)num_shift(inverse, 3 - bits), one = (num_u)1 << 31;

    return inside ? one - bias : one + bias;
}

/* Returns facing * inverse * 2^-s, rounded to nearest: bias N.w, where facing is r N.w and inverse is num_inverse of
 * the radius. */
static inline num_wide num_bias_product(num_u facing, num_u inverse, int s)
{
    NUM_CHECK(s >= 1);
    s = s < 1 ? 1 : s > 63 ? 63 : s;
    return (num_wide)(((num_mul_u(facing, inverse) >> (s - 1)) + 1) >> 1);
}

/* Returns x bias/r with the exponent e; x has the exponent 30, and the radius has `bits` bits. */
static inline num_wide num_bias_of(num_wide x, num_u inverse, int bits, int e)
{
    int x_bits = num_bits(x), s = 88 + bits - x_bits - e;

    NUM_CHECK(x == 0 || s >= 0);
    if (s > 63)
        return 0;
    return tia_round_shift(num_shift(x, 30 - x_bits) * (num_wide)inverse, s < 0 ? 0 : (unsigned)s);
}

#define NUM_LEAST 1            /* the smallest positive mantissa */
#define NUM_BIAS ((num_wide)8) /* bias of shadow rays: 2^-13, exponent 16 */

/* Returns floor(levels c + threshold), c and threshold in Q2.30; the threshold NUM_ROUND, 1/2, rounds to nearest. */
static inline unsigned num_quantise(num_u c, unsigned levels, num_u threshold)
{
    NUM_CHECK(c <= NUM_ONE && threshold < NUM_ONE);
    return (unsigned)(((num_uwide)c * levels + threshold) >> 30);
}

/* Returns (n + 1/2) / 64 as a threshold for num_quantise. */
static inline num_u num_threshold(unsigned n)
{
    return (num_u)(2 * n + 1) << 23;
}

/* True if t < u, where t has the exponent e and u the exponent f. */
static inline bool num_nearer(num_u t, int e, num_u u, int f)
{
    int d = f - e;
    if (d >= 0)
        return (num_uwide)t << (d < 32 ? d : 32) < u;
    return t < (num_uwide)u << (d > -32 ? -d : 32);
}

static inline num_wide num_sum_of_squares30(num_wide a, num_wide b, num_wide c)
{
    uint64_t x = (uint64_t)(a < 0 ? -a : a), y = (uint64_t)(b < 0 ? -b : b), z = (uint64_t)(c < 0 ? -c : c);
    NUM_CHECK(x >> 32 == 0 && y >> 32 == 0 && z >> 32 == 0);
    return (num_wide)((x * x + y * y + z * z) >> 2);
}

/* True if (x, y, z) is at most r long, exactly. Sizes are below 2^32. */
static inline bool num_is_within(num_wide x, num_wide y, num_wide z, num_wide r)
{
    const num_wide sides[3] = {x, y, z};
    num_uwide left = num_mul_u((num_u)r, (num_u)r);

    for (int i = 0; i < 3; i++) {
        num_u size = (num_u)(sides[i] < 0 ? -sides[i] : sides[i]);
        num_uwide square = num_mul_u(size, size);
        NUM_CHECK((sides[i] < 0 ? -sides[i] : sides[i]) >> 32 == 0);
        if (square > left)
            return false;
        left -= square;
    }
    return true;
}

#include "num_certain_q16.h"

#endif
