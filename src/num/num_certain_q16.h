/* num_certain_q16.h - error bounds of the integers, and comparisons that are 0 where an error could decide them. The
 * derivations are in render/span/span_proved.h. A `log` is the binary logarithm of a bound in 256ths; a `doubt` is a
 * bound in units of the number that it belongs to. */
#ifndef TIA_NUM_NUM_CERTAIN_Q16_H
#define TIA_NUM_NUM_CERTAIN_Q16_H

/* Returns the least x whose num_normal has this half or less. */
static inline num_wide num_least_normal(int half)
{
    NUM_CHECK(half >= 0 && half <= 31);
    return (num_wide)1 << (62 - 2 * half);
}

/* 1: pixels are those of docs/definition.md. */
#define NUM_CERTIFIED 1

/* Returns 1 if c < 0, or b >= 0 and b^2 >= c q, otherwise -1; but 0 if b^2 - c q is within about doubt 2^64 of 0, where
 * a doubt of -1 stands for none. q > 0. */
static inline int num_cone(num_wide b, num_wide c, num_wide q, num_wide doubt)
{
    NUM_CHECK(q > 0 && doubt >= -1 && num_bits(doubt) < 62);
    if (c < 0)
        return 1;
    struct tia_wide p = tia_wide_product((uint64_t)(b < 0 ? -b : b), (uint64_t)(b < 0 ? -b : b));
    struct tia_wide r = tia_wide_product((uint64_t)c, (uint64_t)q);
    num_wide above = (num_wide)(p.high - r.high - (p.low < r.low));

    if (above >= -doubt - 1 && above <= doubt)
        return 0;
    return b >= 0 && above >= 0 ? 1 : -1;
}

/* Returns 2^(log/256) rounded up, at most 2^62: 2^f is at most 1 + f for f in 0..1. */
static inline num_wide num_bound_of_log(int log)
{
    int bits = log >> 8;
    num_u mantissa = 256 + ((num_u)log & 255);

    if (bits < 8)
        return bits < 0 ? 1 : (num_wide)(mantissa >> (8 - bits)) + 1;
    return bits > 61 ? (num_wide)1 << 62 : ((num_wide)mantissa << (bits - 8)) + 1;
}

/* Returns the binary logarithm of x > 0 in 256ths, rounded down by up to .0861 and 1/256; very little for 0. */
static inline int num_log(num_wide x)
{
    NUM_CHECK(x >= 0);
    if (x <= 0)
        return -64 * 256;
    num_u high = (num_u)((num_uwide)x >> 32), low = (num_u)x, top = high ? high : low;
    int zeros = (int)tia_clz32(top);
    top = top << zeros | (high ? low : 0) >> 1 >> (31 - zeros);
    return ((high ? 63 : 31) - zeros) * 256 + (int)(tia_top_bits(top, 23) & 255);
}

/* Returns the upper half of a b rounded down; a, b >= 0. */
static inline num_wide num_high(num_wide a, num_wide b)
{
    NUM_CHECK(a >= 0 && b >= 0);
    return (num_wide)tia_wide_product((uint64_t)a, (uint64_t)b).high;
}

/* Returns 1 if a^2 > d k swell for positive a, d and k, -1 if it is less, and 0 if they differ by less than 2^-margin
 * of themselves, with d = near 2^(32 - 2 half) from a num_normal; swell is from num_swell, and `e` is twice a's
 * exponent minus those of d and k. Factors are cut to 31 or 32 bits, so that each side is off by less than 2^-28 of
 * itself. The margin is at most 26. */
static inline int num_cover_order(num_wide a, num_u near, int half, num_wide k, num_u swell, int e, int margin)
{
    NUM_CHECK(a > 0 && k > 0 && half >= 0 && half <= 31);
    int a_zeros = (int)tia_clz64((uint64_t)a), k_zeros = (int)tia_clz64((uint64_t)k);
    int shift = 1 - 2 * half - k_zeros + 2 * a_zeros + e;

    if (shift > 4 || shift < -4) /* left and right are in 2^60..2^64 */
        return shift > 0 ? -1 : 1;
    num_u top = (num_u)((uint64_t)a << a_zeros >> 32), power = (num_u)((uint64_t)k << k_zeros >> 33);
    num_uwide left = num_mul_u(top, top), right = num_mul_u(near, (num_u)(num_mul_u(power, swell) >> 31));

    left >>= shift > 0 ? shift : 0;
    right >>= shift < 0 ? -shift : 0;
    num_uwide apart = left > right ? left - right : right - left;
    if (apart <= ((left >> margin) + (right >> margin)) / 2)
        return 0;
    return left > right ? 1 : -1;
}

/* The logarithm of how many times a number exceeds its error's bound where num_cover_order's margin of 14 includes the
 * error: that of a, whose square counts, 2 2^-16, of k 2^-16, and of d up to 2^-17: together less than 2^-14. */
#define NUM_CLEAR (16 * 256)

/* The largest bound of a channel's error with which its level is decided. */
#define NUM_DOUBT_MOST ((num_u)1 << 22)

/* A bound of the roundings of a channel with one light: two halves of a unit. */
#define NUM_CHANNEL_DOUBT 2

/* Returns the bound of the error of a light's part in a channel: `product` times the cosine's error, whose binary
 * logarithm in 256ths is `lambert`, and roundings: half a unit of the product, times a cosine up to 1, half of its
 * product with that, and as much for each of `tints` transmissions. */
static inline num_u num_light_doubt(num_u product, int lambert, uint32_t tints)
{
    NUM_CHECK(lambert <= -9 * 256 && product <= (num_u)1 << 31);
    num_u cosine = (num_u)num_bound_of_log(lambert + 40 * 256); /* below 2^31 + 2 */

    return (num_u)(num_mul_u(product, cosine) >> 40) + 3 + tints / 2 + (tints > 0);
}

typedef unsigned num_level_word;

/* A level is levels c + threshold + doubt with 26 bits behind the point. Where that may be above another whole number
 * than levels c + threshold, its fraction is below twice the doubt, even if the sum overflows. */

/* Returns the bound of a level's error for a channel that is off by `doubt`, below 2^22: num_level() cuts c and the
 * threshold by less than 16 units. */
static inline num_u num_level_doubt(num_u doubt, unsigned levels)
{
    return (levels * (doubt + 16) + 31) / 16;
}

/* Returns the threshold and doubt of levels. */
static inline num_u num_level_threshold(num_u threshold, num_u doubt)
{
    return (threshold >> 4) + doubt;
}

static inline num_u num_level(num_u c, unsigned levels, num_u threshold)
{
    return (c >> 4) * levels + threshold;
}

/* Returns the level of a channel with `more` more levels than `level` has. */
static inline num_u num_further_level(num_u level, num_u c, unsigned more, num_u threshold)
{
    (void)threshold;
    return level + (c >> 4) * more;
}

static inline num_level_word num_floor_level(num_u level)
{
    return (num_level_word)tia_top_bits(level, 26);
}

/* True if a level, off by up to `doubt`, may be another one. */
static inline bool num_is_near_level(num_u level, num_u doubt)
{
    return TIA_SHIFTS_BITS ? (level & 0x3ffffff) < doubt << 1 : level << 6 < doubt << 7;
}

/* Returns -1 if t < u, 1 if not, and 0 if t and u, off by less than their doubts, leave it open; exponents as above. */
static inline int num_order(num_u t, int e, num_u t_doubt, num_u u, int f, num_u u_doubt)
{
    int d = f - e, up = d > 0 ? (d < 31 ? d : 31) : 0, down = d < 0 ? (d > -31 ? -d : 31) : 0;
    num_wide apart = (num_wide)((num_uwide)t << up) - (num_wide)((num_uwide)u << down);
    num_wide doubt = (num_wide)(((num_uwide)t_doubt << up) + ((num_uwide)u_doubt << down));

    return apart < -doubt ? -1 : apart > doubt ? 1 : 0;
}

/* Returns the doubt of a distance t: t^2 2^-(32 + shift), 2^-26 of t and `more`. */
static inline num_u num_distance_doubt(num_u t, int shift, num_u more)
{
    return ((num_u)(num_mul_u(t, t) >> 32) >> shift) + (t >> 26) + more;
}

#endif
