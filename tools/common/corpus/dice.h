/* dice.h - random numbers for scenes that are the same on every machine. */
#ifndef TOOLS_COMMON_CORPUS_DICE_H
#define TOOLS_COMMON_CORPUS_DICE_H

#include <tia/vec.h>

/* Returns a random number by SplitMix64 (Steele, Lea and Flood 2014), with integers only. */
static inline uint64_t dice_next(uint64_t *state)
{
    uint64_t z = *state += UINT64_C(0x9E3779B97F4A7C15);

    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

/* Returns a number in low..high, both included. */
static inline int32_t dice_between(uint64_t *state, int32_t low, int32_t high)
{
    uint64_t count = (uint64_t)((int64_t)high - low + 1);

    return (int32_t)(low + (int64_t)(dice_next(state) % count));
}

static inline bool dice_one_in(uint64_t *state, unsigned n)
{
    return dice_next(state) % n == 0;
}

/* Returns a colour with each channel between low and high percent. */
static inline struct tia_rgb dice_rgb(uint64_t *state, int32_t low, int32_t high)
{
    struct tia_rgb c;

    c.r = dice_between(state, TIA_Q30_ONE / 100 * low, TIA_Q30_ONE / 100 * high);
    c.g = dice_between(state, TIA_Q30_ONE / 100 * low, TIA_Q30_ONE / 100 * high);
    c.b = dice_between(state, TIA_Q30_ONE / 100 * low, TIA_Q30_ONE / 100 * high);
    return c;
}

/* Returns a vector with each coordinate between those of low and high. */
static inline struct tia_vec3 dice_vec3(uint64_t *state, struct tia_vec3 low, struct tia_vec3 high)
{
    struct tia_vec3 v;

    v.x = dice_between(state, low.x, high.x);
    v.y = dice_between(state, low.y, high.y);
    v.z = dice_between(state, low.z, high.z);
    return v;
}

#endif
