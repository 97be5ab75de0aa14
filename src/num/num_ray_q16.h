/* num_ray_q16.h - general rays in 64-bit integers: Q18.45 and Q1.62. */
#ifndef TIA_NUM_RAY_Q16_H
#define TIA_NUM_RAY_Q16_H

#include "math/wide.h"

typedef int64_t num_x;
typedef int64_t num_d;

#define NUM_X_ONE ((num_x)1 << 45)
#define NUM_X_BIAS ((num_x)1 << 32) /* of secondary rays: 2^-13 */
#define NUM_X_FAR ((num_x)1 << 61)  /* 2^16: what is farther away from the origin of the world is not seen */
#define NUM_X_MOST ((num_x)1 << 62) /* 2^17, infinitely far */
#define NUM_X_LEAST ((num_x)1)      /* the smallest there is */
#define NUM_D_ONE ((num_d)1 << 62)
#define NUM_D_LEAST ((num_d)1 << 20) /* a slope under which a ray counts as parallel: 2^-42 */

static inline num_x num_x_of(tia_q16 q)
{
    return (num_x)q * ((num_x)1 << 29);
}

static inline num_d num_d_of(tia_q30 q)
{
    return (num_d)q * ((num_d)1 << 32);
}

static inline num_d num_d_of62(int64_t n)
{
    return n;
}

static inline num_x num_x_of_d(num_d d)
{
    return tia_round_shift(d >> 1, 16);
}

static inline num_x num_int(int32_t n)
{
    NUM_CHECK(n < 1 << 18 && n > -(1 << 18));
    return (num_x)n * NUM_X_ONE;
}

static inline int32_t num_floor(num_x x)
{
    return (int32_t)(x >> 45);
}

static inline num_x num_times(num_x a, num_d d)
{
    return wide_round(wide_product(a, d), 62);
}

static inline num_x num_product(num_x a, num_x b)
{
    NUM_CHECK(wide_bits(wide_product(a < 0 ? -a : a, b < 0 ? -b : b)) <= 62 + 45);
    return wide_round(wide_product(a, b), 45);
}

static inline num_x num_product_within(num_x a, num_x b)
{
    wide product = wide_product(a, b);

    NUM_CHECK(a >= 0 && b >= 0);
    return wide_bits(product) > 62 + 45 ? NUM_X_MOST : wide_round(product, 45);
}

static inline num_x num_tile(num_x x, tia_q16 n, int32_t *cell)
{
    wide product = wide_product(x, n);
    int64_t floor = wide_down(product, 61);

    NUM_CHECK(floor < INT32_MAX && floor > -INT32_MAX);
    *cell = (int32_t)floor;
    return (num_x)(wide_low(product) & ((UINT64_C(1) << 61) - 1)) >> 16;
}

static inline int64_t num_dot3(int64_t ax, int64_t ay, int64_t az, num_d bx, num_d by, num_d bz)
{
    wide sum = wide_sum(wide_sum(wide_product(ax, bx), wide_product(ay, by)), wide_product(az, bz));

    NUM_CHECK((wide_high(sum) < 0 ? ~wide_high(sum) : wide_high(sum)) >> 61 == 0);
    return wide_round(sum, 62);
}

static inline bool num_normalise3(num_x x, num_x y, num_x z, num_d *dx, num_d *dy, num_d *dz)
{
    const int64_t v[3] = {x, y, z};
    int64_t d[3];
    bool some = wide_normalise(v, d);

    NUM_CHECK((x < 0 ? -x : x) <= NUM_X_MOST && (y < 0 ? -y : y) <= NUM_X_MOST && (z < 0 ? -z : z) <= NUM_X_MOST);
    *dx = d[0];
    *dy = d[1];
    *dz = d[2];
    return some;
}

static inline num_x num_leg4(num_x r, num_x x, num_x y, num_x z)
{
    const int64_t p[3] = {x, y, z};

    if (x > r || -x > r || y > r || -y > r || z > r || -z > r)
        return -1;
    wide rest = wide_difference(wide_product(r, r), wide_dot(p, p));
    return wide_is_negative(rest) ? -1 : wide_sqrt(rest);
}

static inline bool num_within4(num_x r, num_x x, num_x y, num_x z)
{
    const int64_t p[3] = {x, y, z};

    if (x > r || -x > r || y > r || -y > r || z > r || -z > r)
        return false;
    return !wide_is_negative(wide_difference(wide_product(r, r), wide_dot(p, p)));
}

/* The numerator exact, then its upper 63 bits. */
static inline num_x num_beyond5(num_x x, num_x y, num_x z, num_x r, num_x k)
{
    const int64_t p[3] = {x, y, z};
    wide square = wide_dot(p, p), other = wide_product(r, r), n = wide_difference(square, other);
    bool negative = wide_is_negative(n);

    if (negative)
        n = wide_difference(other, square);
    int s = wide_bits(n) - 63;
    num_x quotient = s > 0 ? wide_quotient(wide_down(n, (unsigned)s), k, s) : wide_quotient((int64_t)wide_low(n), k, 0);
    return negative ? -quotient : quotient;
}

static inline num_x num_length3(num_x x, num_x y, num_x z)
{
    const int64_t p[3] = {x, y, z};

    return wide_sqrt(wide_dot(p, p));
}

static inline num_d num_sqrt_d(num_d d)
{
    NUM_CHECK(d >= 0);
    return wide_sqrt(wide_product(d, NUM_D_ONE));
}

static inline num_x num_over(num_x x, num_d d)
{
    return wide_quotient(x, d, 62);
}

static inline num_x num_ratio(num_x x, num_x y)
{
    return wide_quotient(x, y, 45);
}

static inline num_d num_fraction(num_x x, num_x y)
{
    return wide_quotient(x, y, 62);
}

/* Twice the area of a triangle with a corner at 0, exact: of coordinates below 2^17.6. */
typedef wide num_area;

static inline num_area num_cross2(num_x ax, num_x ay, num_x bx, num_x by)
{
    return wide_difference(wide_product(ax, by), wide_product(ay, bx));
}

static inline int num_area_sign(num_area a)
{
    return wide_is_negative(a) ? -1 : wide_bits(a) != 0;
}

/* a 2^zeros, below 2^62, rounded down */
static inline int64_t num_area_top(num_area a, int zeros)
{
    return zeros < 0 ? wide_down(a, (unsigned)-zeros) : (int64_t)wide_low(wide_up(a, (unsigned)zeros));
}

/* Three areas over their sum, which is not 0. Those that have not its sign are taken as 0. */
static inline void num_parts(const num_area areas[3], num_d parts[3])
{
    wide sum = wide_sum(wide_sum(areas[0], areas[1]), areas[2]), none = wide_product(0, 0), a[3];
    bool negative = wide_is_negative(sum);

    for (int i = 0; i < 3; i++)
        a[i] = wide_is_negative(areas[i]) == negative ? wide_size(areas[i]) : none;
    sum = wide_sum(wide_sum(a[0], a[1]), a[2]);
    int zeros = 62 - wide_bits(sum);
    NUM_CHECK(zeros < 62);
    parts[1] = wide_quotient(num_area_top(a[1], zeros), num_area_top(sum, zeros), 62);
    parts[2] = wide_quotient(num_area_top(a[2], zeros), num_area_top(sum, zeros), 62);
    parts[0] = NUM_D_ONE - parts[1] - parts[2];
}

/* d^e: the integer part of e by squaring, its fraction by square roots. */
static inline num_d num_power(num_d d, tia_q16 e)
{
    num_d power = NUM_D_ONE, base = d;

    NUM_CHECK(d >= 0 && d <= NUM_D_ONE && e >= 0);
    for (tia_q16 n = e >> 16; n; n >>= 1) {
        if (n & 1)
            power = num_times(power, base);
        base = num_times(base, base);
    }
    base = d;
    for (tia_q16 n = e & 0xffff; n; n = (n << 1) & 0xffff) {
        base = num_sqrt_d(base);
        if (n & 0x8000)
            power = num_times(power, base);
    }
    return power;
}

#define NUM_D_LEVEL ((num_d)1 << 42) /* 2^-20 */

/* 1/d with 42 bits behind the point, below 2^62, rounded towards 0: d is taken as NUM_D_LEVEL at least. The
 * reciprocal of d 2^z is 2^64/d 2^-z with 62 bits, and z is at most 21. */
static inline num_x num_steep(num_d d)
{
    num_d size = d < 0 ? -d : d;
    uint64_t divisor = (uint64_t)(size < NUM_D_LEVEL ? NUM_D_LEVEL : size);
    unsigned z = tia_clz64(divisor);
    num_x steep = wide_reciprocal(divisor << z) >> (22 - z);

    return d < 0 ? -steep : steep;
}

/* x/d with 23 bits behind the point, rounded down. */
static inline num_x num_slab(num_x x, num_x steep)
{
    return wide_high(wide_product(x, steep));
}

#define NUM_SLAB_ERROR ((num_x)2) /* what two of them may be off by */

/* A distance as num_slab has it. */
static inline num_x num_slab_of(num_x t)
{
    return t >> 22;
}

/* What num_slab says as a distance, a little less than it is. */
static inline num_x num_slab_start(num_x slab)
{
    return slab <= NUM_SLAB_ERROR ? 0 : (slab - NUM_SLAB_ERROR) * ((num_x)1 << 22);
}

/* mantissa 2^exponent */
struct num_scale {
    num_d mantissa;
    int exponent;
};

/* The vector (x/s[0], y/s[1], z/s[2]): its length, and the direction, within 2^-57. |x|, |y|, |z| <= 1, one of
 * them not below 2^-1, s in 2^-10..2^10: quotients below 2^62 are found first with 51 bits behind the point, then
 * with as many as fit. */
static inline struct num_scale num_divide3(const num_d v[3], const num_x s[3], num_d d[3])
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

/* t times the scale and over it, at most NUM_X_MOST. t >= 0 */
static inline num_x num_scaled(num_x t, struct num_scale k)
{
    wide p = wide_product(t, k.mantissa);
    int shift = 62 - k.exponent;

    return wide_bits(p) - shift > 62 ? NUM_X_MOST : wide_round(p, (unsigned)shift);
}

static inline num_x num_unscaled(num_x t, struct num_scale k)
{
    return wide_quotient(t, k.mantissa, 62 - k.exponent);
}

/* CORDIC: the vector is turned to the x axis by angles with the tangents 1, 1/2, 1/4, ...; within 2^-55. */
static inline num_d num_turn(num_d y, num_d x)
{
    num_d turned = 0;

    if (x < 0) {
        turned = y < 0 ? -(NUM_D_ONE / 2) : NUM_D_ONE / 2;
        x = -x;
        y = -y;
    }
    x /= 2; /* CORDIC lengthens the vector by 1.65 */
    y /= 2;
    if (x == 0 && y == 0)
        return 0;
    for (int i = 0; i < 60; i++) {
        num_d dx = y >> i, dy = x >> i;
        turned += y < 0 ? -tia_turns[i] : tia_turns[i];
        x += y < 0 ? -dx : dx;
        y += y < 0 ? dy : -dy;
    }
    return turned;
}

static inline unsigned num_levels(num_x c, unsigned levels, num_u threshold)
{
    NUM_CHECK(c >= 0 && c <= NUM_X_ONE && threshold < NUM_ONE);
    return (unsigned)((c * (num_x)levels + ((num_x)threshold << 15)) >> 45);
}

#endif
