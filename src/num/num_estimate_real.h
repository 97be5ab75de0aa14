/* num_estimate_real.h - num_estimate.h's operations in floating point. */
#ifndef TIA_NUM_NUM_ESTIMATE_REAL_H
#define TIA_NUM_NUM_ESTIMATE_REAL_H

/* Returns the rays' offset from a surface: 2^-26, or `bias` in float, which is too coarse for 2^-26. */
static inline num_length num_ray_bias(num_length bias)
{
    return sizeof(num_real) == sizeof(float) ? bias : NUM_LENGTH_ONE / 67108864;
}

static inline int64_t num_q24(num_length x)
{
    num_double scaled = (num_double)x * 16777216 + 0.5;

    return (int64_t)scaled;
}

static inline uint32_t num_chance(num_unit p)
{
    num_double scaled = (num_double)p * 4294967296.0;

    return scaled >= 4294967295.0 ? UINT32_MAX : scaled <= 0 ? 0 : (uint32_t)scaled;
}

static inline num_unit num_of_chance(uint32_t chance)
{
    return chance == UINT32_MAX ? 1 : (num_unit)(chance / 4294967296.0);
}

struct num_density {
    num_double value;
};

static inline struct num_density num_density_of(num_length x)
{
    return (struct num_density){(num_double)x};
}

static inline struct num_density num_density_of_unit(num_unit d)
{
    return (struct num_density){(num_double)d};
}

static inline struct num_density num_density_product(struct num_density a, struct num_density b)
{
    return (struct num_density){a.value * b.value};
}

static inline struct num_density num_density_quotient(struct num_density a, struct num_density b)
{
    return (struct num_density){b.value > 0 ? a.value / b.value : 1e300};
}

static inline struct num_density num_density_sum(struct num_density a, struct num_density b)
{
    return (struct num_density){a.value + b.value};
}

static inline num_length num_density_over(num_length x, struct num_density p)
{
    return p.value > 0 ? num_bounded((num_length)((num_double)x / p.value), NUM_LENGTH_MAX) : 0;
}

static inline num_unit num_density_share(struct num_density p, struct num_density q)
{
    num_double sum = p.value + q.value;

    return sum > 0 ? (num_unit)(p.value / sum) : 0;
}

#endif
