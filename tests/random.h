/* random.h - random numbers for tests, the same in every run: SplitMix64, as in the corpus. A case gets the same
 * numbers whether it runs alone or after others. */
#ifndef TESTS_RANDOM_H
#define TESTS_RANDOM_H

#include "check.h"
#include "common/corpus/dice.h"

static bool check_ordered = true;
static uint64_t random_state = 1;

static inline uint64_t random_bits(void)
{
    return dice_next(&random_state);
}

static inline uint32_t random_u32(void)
{
    return (uint32_t)(random_bits() >> 32);
}

/* Returns a random number below 2^bits, whose length is random as well. */
static inline uint64_t random_short(unsigned bits)
{
    return random_bits() >> (64 - bits) >> random_bits() % bits;
}

/* Returns a random number in -1..1. */
static inline long double random_real(void)
{
    return (long double)(int64_t)random_bits() / 9223372036854775808.0L;
}

static inline double random_double(void)
{
    return (double)random_real();
}

#endif
