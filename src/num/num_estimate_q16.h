/* num_estimate_q16.h - num_estimate.h's operations in integers. */
#ifndef TIA_NUM_NUM_ESTIMATE_Q16_H
#define TIA_NUM_NUM_ESTIMATE_Q16_H

static inline num_length num_ray_bias(num_length bias)
{
    (void)bias;
    return NUM_LENGTH_ONE >> 26;
}

static inline int64_t num_q24(num_length x)
{
    return tia_round_shift(x, 21);
}

static inline uint32_t num_chance(num_unit p)
{
    return p >= NUM_UNIT_ONE ? UINT32_MAX : p <= 0 ? 0 : (uint32_t)(p >> 30);
}

static inline num_unit num_of_chance(uint32_t chance)
{
    return chance == UINT32_MAX ? NUM_UNIT_ONE : (num_unit)chance << 30;
}

/* A density: mantissa 2^exponent, the mantissa in 2^61..2^62 or 0. */
struct num_density {
    int64_t mantissa;
    int exponent;
};

static inline struct num_density num_density_made(int64_t value, int exponent)
{
    if (value <= 0)
        return (struct num_density){0, -4000};
    int zeros = (int)tia_clz64((uint64_t)value) - 2;
    return zeros >= 0 ? (struct num_density){(int64_t)((uint64_t)value << zeros), exponent - zeros}
                      : (struct num_density){value >> 1, exponent + 1};
}

static inline struct num_density num_density_of(num_length x)
{
    return num_density_made(x, -45);
}

static inline struct num_density num_density_of_unit(num_unit d)
{
    return num_density_made(d, -62);
}

static inline struct num_density num_density_product(struct num_density a, struct num_density b)
{
    return num_density_made(wide_round(wide_product(a.mantissa, b.mantissa), 61), a.exponent + b.exponent + 61);
}

/* Returns a/b; if b is 0, a density above all others. */
static inline struct num_density num_density_quotient(struct num_density a, struct num_density b)
{
    if (!b.mantissa)
        return (struct num_density){INT64_C(1) << 61, 4000};
    return num_density_made(wide_quotient(a.mantissa, b.mantissa, 61), a.exponent - b.exponent - 61);
}

static inline struct num_density num_density_sum(struct num_density a, struct num_density b)
{
    struct num_density large = a.exponent < b.exponent ? b : a, small = a.exponent < b.exponent ? a : b;
    int down = large.exponent - small.exponent;

    return num_density_made(large.mantissa + (down > 62 ? 0 : small.mantissa >> down), large.exponent);
}

static inline num_length num_density_over(num_length x, struct num_density p)
{
    if (!p.mantissa || p.exponent > 0)
        return 0;
    return wide_quotient(x, p.mantissa, p.exponent < -126 ? 126 : -p.exponent);
}

static inline num_unit num_density_share(struct num_density p, struct num_density q)
{
    struct num_density sum = num_density_sum(p, q);
    int exponent = 62 + p.exponent - sum.exponent;

    return !p.mantissa || exponent < 0 ? 0 : wide_quotient(p.mantissa, sum.mantissa, exponent);
}

#endif
