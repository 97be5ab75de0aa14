/* num_ray_q16.h - num_ray.h's operations in 64-bit integers: Q18.45 and Q1.62. */
#ifndef TIA_NUM_NUM_RAY_Q16_H
#define TIA_NUM_NUM_RAY_Q16_H

#include "math/atan2.h"
#include "math/wide.h"

typedef int64_t num_length;
typedef int64_t num_unit;

#define NUM_LENGTH_ONE ((num_length)1 << 45)
#define NUM_LENGTH_BIAS ((num_length)1 << 32) /* 2^-13 */
#define NUM_LENGTH_FAR ((num_length)1 << 61)  /* 2^16: hits with larger coordinates do not count */
#define NUM_LENGTH_MAX ((num_length)1 << 62)  /* 2^17, for infinity */
#define NUM_LENGTH_LEAST ((num_length)1)      /* the smallest positive length */
#define NUM_UNIT_ONE ((num_unit)1 << 62)
#define NUM_UNIT_LEAST ((num_unit)1 << 20) /* 2^-42: a ray with a smaller slope counts as parallel */

static inline num_length num_length_of(tia_q16 q)
{
    return (num_length)q * ((num_length)1 << 29);
}

static inline num_length num_length_of_q45(int64_t n)
{
    return n;
}

static inline num_length num_fine(int16_t digits)
{
    return (num_length)digits * ((num_length)1 << 13);
}

static inline num_length num_scene_bias(bool fine, int scale_bits)
{
    int down = fine || scale_bits < -13 ? 13 : scale_bits < 0 ? -scale_bits : 0;

    return NUM_LENGTH_BIAS >> down;
}

static inline num_unit num_unit_of(tia_q30 q)
{
    return (num_unit)q * ((num_unit)1 << 32);
}

static inline num_unit num_unit_of_q62(int64_t n)
{
    return n;
}

static inline num_length num_length_of_unit(num_unit d)
{
    return tia_round_shift(d >> 1, 16);
}

static inline num_length num_integer(int32_t n)
{
    NUM_CHECK(n < INT32_C(1) << 18 && n > -(INT32_C(1) << 18));
    return (num_length)n * NUM_LENGTH_ONE;
}

static inline int32_t num_floor(num_length x)
{
    return (int32_t)(x >> 45);
}

static inline num_length num_times(num_length a, num_unit d)
{
    return wide_round(wide_product(a, d), 62);
}

static inline num_length num_product(num_length a, num_length b)
{
    NUM_CHECK(wide_bits(wide_product(a < 0 ? -a : a, b < 0 ? -b : b)) <= 62 + 45);
    return wide_round(wide_product(a, b), 45);
}

static inline num_length num_product_within(num_length a, num_length b)
{
    wide product = wide_product(a, b);

    NUM_CHECK(a >= 0 && b >= 0);
    return wide_bits(product) > 62 + 45 ? NUM_LENGTH_MAX : wide_round(product, 45);
}

/* Returns the fractional part of y = n x - n o, and gives its integer part in *cell. Both products are in units of
 * 2^-(45 + down), where down is -8 or more. n x is below 2^94; n o is below 2^62, and is then shifted up by at most 53
 * bits. */
static inline num_length num_repeat(num_length x, int bits, const struct num_pattern *p, int32_t *cell)
{
    int down = 16 + p->repeat_bits - bits;
    wide offset = wide_up(wide_product(p->offset, p->repeat), (unsigned)(29 - bits - p->offset_bits));
    wide y = wide_difference(wide_product(x, p->repeat), offset);

    y = wide_up(y, down < 0 ? (unsigned)-down : 0);
    down = down < 0 ? 0 : down;
    *cell = (int32_t)(wide_down(y, (unsigned)down + 45) & INT32_MAX);
    uint64_t part = down ? (uint64_t)wide_down(y, (unsigned)down) : wide_low(y);
    return (num_length)(part & ((UINT64_C(1) << 45) - 1));
}

/* Returns n 2^bits x, clamped to +-2^12. The product n x is in units of 2^-(45 + down), where down is -24 or more. A
 * product of at most 57 + down bits fits after the shift; a larger one is clamped. */
static inline num_length num_repeats(num_length x, int bits, const struct num_pattern *p)
{
    const num_length most = NUM_LENGTH_ONE * 4096;
    int down = 16 + p->repeat_bits - bits;
    wide y = wide_product(x, p->repeat), least = wide_size(y);

    if (wide_bits(least) > 57 + down)
        return wide_sign(y) < 0 ? -most : wide_sign(y) * most;
    return down < 0 ? (num_length)wide_low(wide_up(y, (unsigned)-down)) : wide_down(y, (unsigned)down);
}

static inline int64_t num_dot3(int64_t ax, int64_t ay, int64_t az, num_unit bx, num_unit by, num_unit bz)
{
    wide sum = wide_sum(wide_sum(wide_product(ax, bx), wide_product(ay, by)), wide_product(az, bz));

    NUM_CHECK((wide_high(sum) < 0 ? ~wide_high(sum) : wide_high(sum)) >> 61 == 0);
    return wide_round(sum, 62);
}

static inline bool num_normalise3(num_length x, num_length y, num_length z, num_unit *dx, num_unit *dy, num_unit *dz)
{
    const int64_t v[3] = {x, y, z};
    int64_t d[3];
    bool some = wide_normalise(v, d);

    NUM_CHECK((x < 0 ? -x : x) <= NUM_LENGTH_MAX && (y < 0 ? -y : y) <= NUM_LENGTH_MAX &&
              (z < 0 ? -z : z) <= NUM_LENGTH_MAX);
    *dx = d[0];
    *dy = d[1];
    *dz = d[2];
    return some;
}

static inline num_length num_half_chord4(num_length r, num_length x, num_length y, num_length z)
{
    const int64_t p[3] = {x, y, z};

    if (x > r || -x > r || y > r || -y > r || z > r || -z > r)
        return -1;
    wide rest = wide_difference(wide_product(r, r), wide_dot(p, p));
    return wide_is_negative(rest) ? -1 : wide_sqrt(rest);
}

static inline bool num_within4(num_length r, num_length x, num_length y, num_length z)
{
    const int64_t p[3] = {x, y, z};

    if (x > r || -x > r || y > r || -y > r || z > r || -z > r)
        return false;
    return !wide_is_negative(wide_difference(wide_product(r, r), wide_dot(p, p)));
}

/* Returns num_point_power's result; the numerator is computed exactly, then cut to its upper 63 bits. */
static inline num_length num_point_power5(num_length x, num_length y, num_length z, num_length r, num_length k)
{
    const int64_t p[3] = {x, y, z};
    wide square = wide_dot(p, p), other = wide_product(r, r), n = wide_difference(square, other);
    bool negative = wide_is_negative(n);

    if (negative)
        n = wide_difference(other, square);
    int s = wide_bits(n) - 63;
    num_length quotient =
        s > 0 ? wide_quotient(wide_down(n, (unsigned)s), k, s) : wide_quotient((int64_t)wide_low(n), k, 0);
    return negative ? -quotient : quotient;
}

static inline num_length num_norm3(num_length x, num_length y, num_length z)
{
    const int64_t p[3] = {x, y, z};

    return wide_sqrt(wide_dot(p, p));
}

static inline num_unit num_unit_sqrt(num_unit d)
{
    NUM_CHECK(d >= 0);
    return wide_sqrt(wide_product(d, NUM_UNIT_ONE));
}

/* Returns a root in sqrt(d)..sqrt(d) + 2^-28; d >= 0. */
static inline num_unit num_root_up(num_unit d)
{
    NUM_CHECK(d >= 0);
    return ((num_unit)tia_sqrt64((uint64_t)d) + 4) * ((num_unit)1 << 31);
}

static inline num_length num_div(num_length x, num_unit d)
{
    return wide_quotient(x, d, 62);
}

static inline num_length num_ratio(num_length x, num_length y)
{
    return wide_quotient(x, y, 45);
}

static inline num_unit num_fraction(num_length x, num_length y)
{
    return wide_quotient(x, y, 62);
}

/* A divisor precomputed for many quotients. */
typedef struct wide_divisor num_divisor;

static inline num_divisor num_divisor_of(int64_t d)
{
    return wide_divisor(d);
}

static inline num_length num_div_by(num_length x, num_divisor d)
{
    return wide_quotient_by(x, d, 62);
}

static inline num_unit num_fraction_by(num_length x, num_divisor y)
{
    return wide_quotient_by(x, y, 62);
}

/* Twice the area of a triangle with a corner at 0; exact for coordinates below 2^17.6. */
typedef wide num_area;

static inline num_area num_cross2(num_length ax, num_length ay, num_length bx, num_length by)
{
    return wide_difference(wide_product(ax, by), wide_product(ay, bx));
}

static inline int num_area_sign(num_area a)
{
    return wide_sign(a);
}

/* Returns a 2^zeros, rounded down; the result must be below 2^62. */
static inline int64_t num_area_top(num_area a, int zeros)
{
    return zeros < 0 ? wide_down(a, (unsigned)-zeros) : (int64_t)wide_low(wide_up(a, (unsigned)zeros));
}

/* Divides each of three areas by their sum, which must not be 0. An area whose sign differs from that of the sum counts
 * as 0, since the point is then on an edge, to within rounding. */
static inline void num_barycentric(const num_area areas[3], num_unit parts[3])
{
    wide sum = wide_sum(wide_sum(areas[0], areas[1]), areas[2]), none = wide_product(0, 0), a[3];
    bool negative = wide_is_negative(sum);

    for (int i = 0; i < 3; i++)
        a[i] = wide_is_negative(areas[i]) == negative ? wide_size(areas[i]) : none;
    sum = wide_sum(wide_sum(a[0], a[1]), a[2]);
    int zeros = 62 - wide_bits(sum);
    NUM_CHECK(zeros < 62);
    struct wide_divisor whole = wide_divisor(num_area_top(sum, zeros));
    parts[1] = wide_quotient_by(num_area_top(a[1], zeros), whole, 62);
    parts[2] = wide_quotient_by(num_area_top(a[2], zeros), whole, 62);
    parts[0] = NUM_UNIT_ONE - parts[1] - parts[2];
}

#include "num_power_q16.h"

#define NUM_UNIT_PARALLEL ((num_unit)1 << 42) /* 2^-20 */

/* Returns 1/d with 42 fractional bits, below 2^62, rounded towards 0; |d| is raised to NUM_UNIT_PARALLEL.
 *
 * wide_reciprocal gives 2^126/(|d| 2^z), and z is at most 21. */
static inline num_length num_reciprocal(num_unit d)
{
    num_unit size = d < 0 ? -d : d;
    uint64_t divisor = (uint64_t)(size < NUM_UNIT_PARALLEL ? NUM_UNIT_PARALLEL : size);
    unsigned z = tia_clz64(divisor);
    num_length reciprocal = wide_reciprocal(divisor << z) >> (22 - z);

    return d < 0 ? -reciprocal : reciprocal;
}

/* Returns x/d with 23 fraction bits, rounded down, by multiplication with num_reciprocal(d). */
static inline num_length num_slab(num_length x, num_length reciprocal)
{
    return wide_high(wide_product(x, reciprocal));
}

#define NUM_SLAB_ERROR ((num_length)2) /* largest error of the difference of two such distances */

/* Converts a length to num_slab's format. */
static inline num_length num_slab_of(num_length t)
{
    return t >> 22;
}

/* Converts a distance from num_slab's format to a num_length, reduced by its error: at least 0, and never beyond the
 * true distance. */
static inline num_length num_slab_start(num_length slab)
{
    return slab <= NUM_SLAB_ERROR ? 0 : (slab - NUM_SLAB_ERROR) * ((num_length)1 << 22);
}

/* Coarse distances along a ray to planes perpendicular to an axis, for the traversal of a hierarchy: t = (plane -
 * origin)/d with 38 fraction bits. 1/|d| is at most 2^8 and rounded towards 0, with a relative error below 2^-22. |t|
 * has the same relative error, plus an error of up to one unit. plane/d is a product of 32 x 32 bits, of the plane and
 * the inverse. Origins beyond 2^16 would need more bits: for them the planes clip nothing. */
typedef int64_t num_walk;

struct num_slope {
    int64_t start;   /* origin/d */
    int32_t inverse; /* 1/d, 22 fraction bits */
    bool backward;   /* d < 0 */
    bool parallel;   /* 1/|d| was clamped: the ray is almost parallel to the planes */
};

static inline struct num_slope num_slope(num_length origin, num_unit d)
{
    const uint64_t least = UINT64_C(1) << 54;
    uint64_t size = d < 0 ? 0 - (uint64_t)d : (uint64_t)d;
    bool parallel = size < least;

    if (origin >= NUM_LENGTH_FAR || origin <= -NUM_LENGTH_FAR)
        return (struct num_slope){0, 0, false, true};
    size = parallel ? least : size;
    unsigned z = tia_clz64(size);
    int32_t inverse = (int32_t)((tia_reciprocal((uint32_t)(size << z >> 32)) - 3) >> (11 - z));
    inverse = d < 0 ? -inverse : inverse;
    return (struct num_slope){wide_round(wide_product(origin, inverse), 29), inverse, d < 0, parallel};
}

static inline num_walk num_walk_to(const struct num_slope *s, tia_q16 plane)
{
    return tia_mul_s32(plane, s->inverse) - s->start;
}

/* Returns a length as an upper limit in the format of num_walk. */
static inline num_walk num_walk_limit(num_length t)
{
    return (t >> 7) + 2;
}

/* Returns the largest computed `near` with which near <= far may still be true of the exact distances. */
static inline num_walk num_walk_slack(num_walk far)
{
    return far + (far >> 21) + 4;
}

/* A factor: mantissa 2^exponent. */
struct num_scale {
    num_unit mantissa;
    int exponent;
};

/* Divides a vector: returns the length of (x/s[0], y/s[1], z/s[2]) and sets d to its direction, within 2^-57. |x|, |y|,
 * |z| <= 1, at least one of them 1/2 or more, s in 2^-10..2^10. A first pass with 51 fraction bits finds the size of
 * the quotients; a second pass computes as many bits as fit. */
static inline struct num_scale num_divide3(const num_unit v[3], const num_length s[3], num_unit d[3])
{
    int64_t q[3], most = 0;

    for (int i = 0; i < 3; i++) {
        q[i] = wide_quotient(v[i], s[i], 45 - 11);
        most |= q[i] < 0 ? -q[i] : q[i];
    }
    int more = 61 - wide_bits(wide_product(most, 1));
    for (int i = 0; i < 3; i++)
        q[i] = wide_quotient(v[i], s[i], 45 - 11 + more);
    (void)wide_normalise(q, d);
    return (struct num_scale){wide_sqrt(wide_dot(q, q)), 11 - more};
}

/* Returns t k, at most NUM_LENGTH_MAX; t >= 0. */
static inline num_length num_scaled(num_length t, struct num_scale k)
{
    wide p = wide_product(t, k.mantissa);
    int shift = 62 - k.exponent;

    return wide_bits(p) - shift > 62 ? NUM_LENGTH_MAX : wide_round(p, (unsigned)shift);
}

static inline num_length num_unscaled(num_length t, struct num_scale k)
{
    return wide_quotient(t, k.mantissa, 62 - k.exponent);
}

static inline num_unit num_atan2(num_unit y, num_unit x)
{
    return tia_atan2(y, x);
}

static inline unsigned num_levels(num_length c, unsigned levels, num_u threshold)
{
    NUM_CHECK(c >= 0 && c <= NUM_LENGTH_ONE && threshold < NUM_ONE);
    return (unsigned)((c * (num_length)levels + ((num_length)threshold << 15)) >> 45);
}

#endif
