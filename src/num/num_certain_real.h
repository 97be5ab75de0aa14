/* num_certain_real.h - num_certain_q16.h's operations in floating point, where nothing is certified: a bound is 0, and
 * each comparison is decided. */
#ifndef TIA_NUM_NUM_CERTAIN_REAL_H
#define TIA_NUM_NUM_CERTAIN_REAL_H

static inline int num_cover_order(num_wide a, num_u near, int half, num_wide k, num_u swell, int e, int margin)
{
    (void)margin;
    (void)half;
    (void)e;
    return a * a >= near * k * swell ? 1 : -1;
}

#define NUM_CLEAR 0

#define NUM_CERTIFIED 0

static inline int num_cone(num_wide b, num_wide c, num_wide q, num_wide doubt)
{
    (void)doubt;
    return c < 0 || (b >= 0 && b * b >= c * q) ? 1 : -1;
}

static inline num_wide num_least_normal(int half)
{
    (void)half;
    return 0;
}

static inline num_wide num_bound_of_log(int log)
{
    (void)log;
    return 0;
}

static inline int num_log(num_wide x)
{
    (void)x;
    return 0;
}

static inline num_wide num_high(num_wide a, num_wide b)
{
    (void)a;
    (void)b;
    return 0;
}

static inline int num_order(num_u t, int e, num_u t_doubt, num_u u, int f, num_u u_doubt)
{
    (void)t_doubt;
    (void)u_doubt;
    return num_nearer(t, e, u, f) ? -1 : 1;
}

static inline num_u num_distance_doubt(num_u t, int shift, num_u more)
{
    (void)t;
    (void)shift;
    return more;
}

typedef unsigned num_level_word;

static inline num_u num_level_threshold(num_u threshold, num_u doubt)
{
    (void)doubt;
    return threshold;
}

static inline num_u num_level(num_u c, unsigned levels, num_u threshold)
{
    return c * (num_real)levels + threshold;
}

static inline num_u num_further_level(num_u level, num_u c, unsigned more, num_u threshold)
{
    (void)level;
    return num_level(c, 31 + more, threshold);
}

static inline num_u num_level_doubt(num_u doubt, unsigned levels)
{
    (void)levels;
    return doubt;
}

static inline unsigned num_floor_level(num_u level)
{
    return (unsigned)level;
}

static inline bool num_is_near_level(num_u level, num_u doubt)
{
    (void)level;
    (void)doubt;
    return false;
}

#define NUM_CHANNEL_DOUBT 0
#define NUM_DOUBT_MOST 0

static inline num_u num_light_doubt(num_u product, int lambert, uint32_t tints)
{
    (void)product;
    (void)lambert;
    (void)tints;
    return 0;
}

#endif
