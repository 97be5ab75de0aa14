/* num_power_q16.h - num_ray.h's powers in integers; for num_ray_q16.h, which includes it. */
#ifndef TIA_NUM_NUM_POWER_Q16_H
#define TIA_NUM_NUM_POWER_Q16_H

#include "math/power.h"

/* Returns d^n by squaring; n >= 0 is an integer. */
static inline num_unit num_whole_power(num_unit d, tia_q16 n)
{
    num_unit power = NUM_UNIT_ONE, base = d;

    for (; n; n >>= 1) {
        if (n & 1)
            power = num_times(power, base);
        base = num_times(base, base);
    }
    return power;
}

/* Returns d^e: the integer part of e by squaring, its fraction by square roots. */
static inline num_unit num_power(num_unit d, tia_q16 e)
{
    num_unit power = num_whole_power(d, e >> 16), base = d;

    NUM_CHECK(d >= 0 && d <= NUM_UNIT_ONE && e >= 0);
    for (tia_q16 n = e & 0xffff; n; n = (n << 1) & 0xffff) {
        base = num_unit_sqrt(base);
        if (n & 0x8000)
            power = num_times(power, base);
    }
    return power;
}

/* Returns a number within *off of num_power, computed without roots where e >= 1. There the error of num_power is below
 * 2^-56: each root is rounded by 2^-62, a relative error of 2^-62/sqrt(d), and the product of the roots is multiplied
 * by at most d. The error of tia_power_near is below 2^-55. *off is 0 where the result is that of num_power. */
static inline num_unit num_power_near(num_unit d, tia_q16 e, num_unit *off)
{
    const num_unit most = (num_unit)1 << 8;

    *off = 0;
    if (e < TIA_Q16_ONE)
        return num_power(d, e);
    num_unit whole = num_whole_power(d, e >> 16);
    if (!(e & 0xffff) || d == NUM_UNIT_ONE || d == 0)
        return whole;
    *off = most;
    return whole <= most ? whole : tia_power_near(whole, d, e & 0xffff);
}

/* Returns num_power as a length, to the bit: if both ends of num_power_near round to the same length, num_power rounds
 * to this length as well. */
static inline num_length num_power_length(num_unit d, tia_q16 e)
{
    num_unit off, near = num_power_near(d, e, &off);
    num_length least = num_length_of_unit(near > off ? near - off : 0);

    return least == num_length_of_unit(near + off) ? least : num_length_of_unit(num_power(d, e));
}

/* Returns exp(-x), 0 <= x: 2^-v with v = x log2 e, which is rounded to 2^-56; then see tia_exp2(). The error is below
 * 2^-55. */
static inline num_unit num_fade(num_length x)
{
    const int64_t log2_e = INT64_C(0x5c551d94ae0bf85e); /* Q1.62 */

    NUM_CHECK(x >= 0);
    if (x >= 44 * NUM_LENGTH_ONE)
        return 0;
    return tia_exp2(NUM_UNIT_ONE, wide_round(wide_product(x, log2_e), 45 + 62 - 56));
}

#endif
