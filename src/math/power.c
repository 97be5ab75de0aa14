/* power.c - d^f = 2^(-f y) with y = -log2 d.
 *
 * With d = m 2^-n, m in [1/2, 1), and r near 1/m from a table, m r = 1 + x with |x| < 1/113, and
 *
 *     y = n + log2 r - log2(1 + x).
 *
 * The series has eight terms; the omitted ones are below 2^-63. y has 56 fraction bits. With the table's rounding, the
 * error of y is below 2^-56, and so is that of f y for f < 1. The relative error of d^f is 0.7 times as large. 2^-v is
 * computed by a shift, by 2^(-i/64) from a table, and by six terms of the series for the rest of v, which is below
 * 1/64; the omitted terms are below 2^-57. A dozen roundings of 2^-62 are negligible beside this. */
#include "power.h"

#include "wide.h"

#define ONE (INT64_C(1) << 62)

static int64_t times(int64_t a, int64_t b)
{
    return wide_round(wide_product(a, b), 62);
}

/* Returns x (c[0] + x (c[1] + ...)), Q1.62. */
static int64_t series(const int64_t *c, int count, int64_t x)
{
    int64_t sum = c[count - 1];

    for (int i = count - 2; i >= 0; i--)
        sum = c[i] + times(sum, x);
    return times(sum, x);
}

int64_t tia_log2(int64_t d)
{
    if (d >= ONE)
        return 0;
    unsigned n = tia_clz64((uint64_t)d) - 2;
    int64_t m = d << n;
    unsigned i = (unsigned)(m >> 55) & 63;
    int64_t x = wide_round(wide_product(m, tia_log_inverses[i]), 9) - ONE;
    int64_t y = ((int64_t)n << 56) + tia_logs[i] - tia_round_shift(series(tia_log_series, 8, x), 6);

    return y < 0 ? 0 : y; /* rounding may make y negative for d near 1 */
}

int64_t tia_exp2(int64_t whole, int64_t v)
{
    int64_t rest = (v & ((INT64_C(1) << 50) - 1)) << 6, k = v >> 56;
    int64_t part = tia_exps[v >> 50 & 63];

    return k > 62 ? 0 : times(whole, (part + times(part, series(tia_exp_series, 6, rest))) >> k);
}

int64_t tia_power_near(int64_t whole, int64_t d, uint32_t fraction)
{
    return tia_exp2(whole, wide_round(wide_product(tia_log2(d), (int64_t)fraction), 16));
}
