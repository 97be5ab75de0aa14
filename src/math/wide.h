/* wide.h - 128-bit sums of products of 64-bit integers, and their roots and quotients.
 *
 * Every curved mirror on a path multiplies the error of the ray. Therefore the ray renderer's coordinates have 64 bits,
 * and a sum of products is rounded once. If the compiler has no 128-bit integers, numbers are pairs of 64-bit halves,
 * with the same results to the bit.
 */
#ifndef TIA_MATH_WIDE_H
#define TIA_MATH_WIDE_H

#include "integer.h"

#if TIA_INT128
__extension__ typedef __int128 wide;

static inline wide wide_product(int64_t a, int64_t b)
{
    return (wide)a * b;
}

static inline wide wide_sum(wide a, wide b)
{
    return a + b;
}

static inline wide wide_difference(wide a, wide b)
{
    return a - b;
}

static inline bool wide_is_negative(wide a)
{
    return a < 0;
}

/* Returns the upper half of a. */
static inline int64_t wide_high(wide a)
{
    return (int64_t)(a >> 64);
}

static inline uint64_t wide_low(wide a)
{
    return (uint64_t)a;
}

/* Returns a 2^s, s in 0..127; no bit is lost. */
static inline wide wide_up(wide a, unsigned s)
{
    __extension__ typedef unsigned __int128 bits;
    return (wide)((bits)a << s);
}

/* Returns a / 2^s rounded down, s in 1..127, the result below 2^63. */
static inline int64_t wide_down(wide a, unsigned s)
{
    return (int64_t)(a >> s);
}

/* Returns high 2^64 + low. */
static inline wide wide_of_halves(int64_t high, uint64_t low)
{
    __extension__ typedef unsigned __int128 bits;
    return (wide)((bits)(uint64_t)high << 64 | low);
}

/* Returns a b, below 2^127 in size. */
static inline wide wide_times(wide a, int64_t b)
{
    return a * b;
}
#else
typedef struct {
    int64_t high;
    uint64_t low;
} wide;

/* Returns a b, |a| <= 2^31, b < 2^32. */
static inline int64_t wide_mixed(int32_t a, uint32_t b)
{
    return (int64_t)(tia_mul_u32((uint32_t)a, b) - (a < 0 ? (uint64_t)b << 32 : 0));
}

/* Returns a b. The upper 32-bit words are signed, the lower ones unsigned; all sums of their products fit 64 bits. */
static inline wide wide_product(int64_t a, int64_t b)
{
    uint32_t a0 = (uint32_t)a, b0 = (uint32_t)b;
    int32_t a1 = (int32_t)(a >> 32), b1 = (int32_t)(b >> 32);
    uint64_t low = tia_mul_u32(a0, b0);
    int64_t middle = wide_mixed(a1, b0) + (int64_t)(low >> 32);
    int64_t cross = wide_mixed(b1, a0) + (int64_t)(uint32_t)middle;

    return (wide){tia_mul_s32(a1, b1) + (middle >> 32) + (cross >> 32), (uint64_t)cross << 32 | (uint32_t)low};
}

static inline wide wide_sum(wide a, wide b)
{
    uint64_t low = a.low + b.low;

    return (wide){(int64_t)((uint64_t)a.high + (uint64_t)b.high + (low < a.low)), low};
}

static inline wide wide_difference(wide a, wide b)
{
    return (wide){(int64_t)((uint64_t)a.high - (uint64_t)b.high - (a.low < b.low)), a.low - b.low};
}

static inline bool wide_is_negative(wide a)
{
    return a.high < 0;
}

static inline int64_t wide_high(wide a)
{
    return a.high;
}

static inline uint64_t wide_low(wide a)
{
    return a.low;
}

static inline wide wide_up(wide a, unsigned s)
{
    if (s == 0)
        return a;
    if (s >= 64)
        return (wide){(int64_t)(a.low << (s - 64)), 0};
    return (wide){(int64_t)((uint64_t)a.high << s | a.low >> (64 - s)), a.low << s};
}

static inline int64_t wide_down(wide a, unsigned s)
{
    if (s >= 64)
        return a.high >> (s - 64);
    return (int64_t)((uint64_t)a.high << (64 - s) | a.low >> s);
}

static inline wide wide_of_halves(int64_t high, uint64_t low)
{
    return (wide){high, low};
}

/* Returns a b modulo 2^128. Halves are multiplied as unsigned numbers, which makes a negative b 2^64 too large; 2^64
 * a.low is subtracted for that. */
static inline wide wide_times(wide a, int64_t b)
{
    struct tia_wide p = tia_wide_product(a.low, (uint64_t)b);
    uint64_t high = p.high + (uint64_t)a.high * (uint64_t)b - (b < 0 ? a.low : 0);

    return (wide){(int64_t)high, p.low};
}
#endif

/* Returns a / 2^s rounded to nearest, ties up, by adding the highest bit that is shifted out; s in 1..126, the result
 * below 2^63. */
static inline int64_t wide_round(wide a, unsigned s)
{
    uint64_t half = s > 64 ? (uint64_t)wide_high(a) >> (s - 65) : wide_low(a) >> (s - 1);

    return wide_down(a, s) + (int64_t)(half & 1);
}

/* Returns |a|. */
static inline wide wide_size(wide a)
{
    return wide_is_negative(a) ? wide_difference(wide_product(0, 0), a) : a;
}

/* Returns the sign of a: -1, 0 or 1. */
static inline int wide_sign(wide a)
{
    return wide_is_negative(a) ? -1 : (wide_high(a) | (int64_t)wide_low(a)) != 0;
}

static inline wide wide_negative(wide a)
{
    return wide_difference(wide_product(0, 0), a);
}

/* Gives a b in 256 bits, the lowest word first. a, b >= 0. */
static inline void wide_long_product(wide a, wide b, uint64_t p[4])
{
    uint64_t x[2] = {wide_low(a), (uint64_t)wide_high(a)}, y[2] = {wide_low(b), (uint64_t)wide_high(b)};

    p[0] = p[1] = p[2] = p[3] = 0;
    for (int i = 0; i < 2; i++) {
        uint64_t carry = 0;
        for (int k = 0; k < 2; k++) {
            struct tia_wide part = tia_wide_product(x[i], y[k]);
            uint64_t low = part.low + carry;
            part.high += low < carry;
            p[i + k] += low;
            carry = part.high + (p[i + k] < low);
        }
        p[i + 2] = carry;
    }
}

/* Returns the sign of a b - c d, exact. */
static inline int wide_order_of_products(wide a, wide b, wide c, wide d)
{
    int s = wide_sign(a) * wide_sign(b), t = wide_sign(c) * wide_sign(d);
    uint64_t p[4], q[4];

    if (s != t)
        return s > t ? 1 : -1;
    if (s == 0)
        return 0;
    wide_long_product(wide_size(a), wide_size(b), p);
    wide_long_product(wide_size(c), wide_size(d), q);
    for (int i = 3; i >= 0; i--)
        if (p[i] != q[i])
            return p[i] > q[i] ? s : -s;
    return 0;
}

/* Returns the dot product; components are below 2^62 in size. */
static inline wide wide_dot(const int64_t a[3], const int64_t b[3])
{
    return wide_sum(wide_sum(wide_product(a[0], b[0]), wide_product(a[1], b[1])), wide_product(a[2], b[2]));
}

/* Returns the number of bits of a >= 0. */
static inline int wide_bits(wide a)
{
    uint64_t high = (uint64_t)wide_high(a), low = wide_low(a);

    return high ? 128 - (int)tia_clz64(high) : low ? 64 - (int)tia_clz64(low) : 0;
}

/* Returns the even shift that brings 0 < a < 2^126 to 125 or 126 bits; the square root is shifted by half as much. */
static inline unsigned wide_zeros(wide a)
{
    return (unsigned)(126 - wide_bits(a)) & ~1u;
}

/* Returns r after a Newton step for the square root of n: r + (n - r^2)/(2r), where y is 2^31/sqrt(n / 2^126). */
static inline int64_t wide_sqrt_step(wide n, int64_t r, uint32_t y)
{
    return r + wide_down(wide_product(wide_down(wide_difference(n, wide_product(r, r)), 35), y), 60);
}

/* Returns the square root of 0 <= a < 2^126, rounded down, exact. Two Newton steps raise the number of correct bits
 * from 29 to 57 and to 63; then the remainder corrects the last unit. */
static inline int64_t wide_sqrt(wide a)
{
    if (wide_bits(a) == 0)
        return 0;
    unsigned s = wide_zeros(a);
    wide n = wide_up(a, s);
    uint64_t top = (uint64_t)wide_high(n) << 2 | wide_low(n) >> 62;
    uint32_t y = tia_rsqrt(top);
    int64_t r = wide_down(wide_product((int64_t)(top >> 2), y), 30);

    r = wide_sqrt_step(n, wide_sqrt_step(n, r, y), y);
    wide rest = wide_difference(n, wide_product(r, r)), next = wide_sum(wide_product(2, r), wide_product(1, 1));
    if (wide_is_negative(rest))
        r--;
    else if (!wide_is_negative(wide_difference(rest, next)))
        r++;
    return r >> (s / 2);
}

/* Returns 2^62/sqrt(top / 2^64), at most 2^63 - 1, with a relative error below 2^-59. top >= 2^62.
 *
 * The result is y (1 + e/2 + 3/8 e^2), where e = 1 - n y^2 is below 2^-28 and n is top / 2^64. The next term, 5/16 e^3,
 * is small enough to omit. */
static inline int64_t wide_rsqrt(uint64_t top)
{
    uint32_t y = tia_rsqrt(top);
    int64_t e = (int64_t)((UINT64_C(1) << 62) - tia_wide_product(top, tia_mul_u32(y, y)).high);
    int64_t square = (e >> 6) * (e >> 6); /* below 2^56, exponent 112 */
    int64_t step = wide_down(wide_product(y, e + (square >> 51) + (square >> 52)), 32);
    uint64_t r = ((uint64_t)y << 31) + (uint64_t)step;

    return r >> 63 ? INT64_MAX : (int64_t)r;
}

/* Returns 2^62/(b / 2^64), at most 2^63 - 1, with a relative error below 2^-60. b >= 2^63. */
static inline int64_t wide_reciprocal(uint64_t b)
{
    uint32_t y = tia_reciprocal((uint32_t)(b >> 32));
    int64_t e = (int64_t)((UINT64_C(1) << 62) - tia_wide_product(b, (uint64_t)y << 31).high);
    int64_t square = (e >> 6) * (e >> 6);
    int64_t step = wide_down(wide_product(y, e + (square >> 50)), 31);
    uint64_t r = ((uint64_t)y << 31) + (uint64_t)step;

    return r >> 63 ? INT64_MAX : (int64_t)r;
}

/* A divisor b prepared for many quotients; |b| < 2^63. */
struct wide_divisor {
    int64_t reciprocal; /* wide_reciprocal of |b| 2^zeros; 0 when b is 0 */
    int zeros;
    bool negative;
};

static inline struct wide_divisor wide_divisor(int64_t b)
{
    uint64_t divisor = b < 0 ? 0 - (uint64_t)b : (uint64_t)b;
    unsigned z = divisor ? tia_clz64(divisor) : 0;

    return (struct wide_divisor){divisor ? wide_reciprocal(divisor << z) : 0, (int)z, b < 0};
}

/* Returns a/b 2^e, with a relative error below 2^-59 plus half a unit, clamped to +-2^62, also for b = 0. |a| < 2^63, e
 * in 0..126. */
static inline int64_t wide_quotient_by(int64_t a, struct wide_divisor b, int e)
{
    bool negative = (a < 0) != b.negative;
    int64_t most = a == 0 ? 0 : negative ? -(INT64_C(1) << 62) : INT64_C(1) << 62;
    wide product = wide_product(a < 0 ? -a : a, b.reciprocal);
    int shift = 126 - b.zeros - e;

    if (!b.reciprocal || shift < 1 || wide_bits(product) - shift > 62)
        return most;
    int64_t quotient = shift > 126 ? 0 : wide_round(product, (unsigned)shift);
    return negative ? -quotient : quotient;
}

static inline int64_t wide_quotient(int64_t a, int64_t b, int e)
{
    return wide_quotient_by(a, wide_divisor(b), e);
}

/* Sets d to v, in any unit, divided by its length: Q1.62, within 2^-58. False, and d = 0, if v is 0. |v| < 2^62. */
static inline bool wide_normalise(const int64_t v[3], int64_t d[3])
{
    wide n = wide_dot(v, v);

    d[0] = d[1] = d[2] = 0;
    if (wide_bits(n) == 0)
        return false;
    unsigned s = wide_zeros(n);
    n = wide_up(n, s);
    int64_t scale = wide_rsqrt((uint64_t)wide_high(n) << 2 | wide_low(n) >> 62);
    for (int i = 0; i < 3; i++)
        d[i] = wide_round(wide_product(v[i], scale), 63 - s / 2);
    return true;
}

#endif
