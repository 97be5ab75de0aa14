/* power.c - a table of 64 values and the series of what is left. */
#include "power.h"

#include "math/wide.h"
#include "tables.h"

#define ONE (INT64_C(1) << 62)
#define LOG2_E INT64_C(0x5c551d94ae0bf85e) /* 1/ln 2, Q1.62 */
#define LN_2 INT64_C(0x2c5c85fdf473de6b)   /* Q1.62 */

static int64_t product(int64_t a, int64_t b)
{
    return wide_round(wide_product(a, b), 62);
}

/* x = m 2^(1-z) with m in 1..2, and m = (1 + r)/tia_inverses[i] with |r| below 2^-7: ln(1 + r) by nine terms. */
int64_t tia_log2(int64_t x)
{
    unsigned z = tia_clz64((uint64_t)x);
    uint64_t m = (uint64_t)x << z;
    unsigned i = (unsigned)(m >> 57) & 63;
    int64_t r = wide_down(wide_product((int64_t)(m >> 1), tia_inverses[i]), 31) - ONE, sum = ONE / 9;

    for (int n = 8; n >= 1; n--)
        sum = ONE / n - product(r, sum);
    int64_t log = product(product(r, sum), LOG2_E);
    int64_t y = ((int64_t)z - 1) * (INT64_C(1) << 56) - ((tia_logarithms[i] + (log >> 2) + 8) >> 4);
    return y < 0 ? 0 : y;
}

/* 2^-y = 2^-k 2^(-i/64) e^-g with g below ln 2/64: nine terms. */
int64_t tia_exp2(int64_t y)
{
    int64_t k = y >> 56, sum = ONE;
    unsigned i = (unsigned)(y >> 50) & 63;

    if (k > 61)
        return 0;
    int64_t g = product((y & ((INT64_C(1) << 50) - 1)) << 6, LN_2);
    for (int n = 8; n >= 1; n--)
        sum = ONE - product(g, sum) / n;
    return product(tia_powers[i], sum) >> k;
}
