/* normalise.c - scales vectors to length 1. */
#include "integer.h"

struct tia_dir3 tia_normalise(int32_t x, int32_t y, int32_t z)
{
    uint64_t n = (uint64_t)((int64_t)x * x) + (uint64_t)((int64_t)y * y) + (uint64_t)((int64_t)z * z);

    if (!n)
        return (struct tia_dir3){0, 0, 0};
    unsigned s = tia_clz64(n) & ~1u;
    int64_t scale = tia_rsqrt(n << s);
    /* 1/sqrt(n) = scale 2^(s/2 - 63); the result has 30 fractional bits */
    unsigned shift = 33 - (s >> 1);
    int32_t v[3] = {x, y, z};

    for (int i = 0; i < 3; i++)
        v[i] = (tia_q30)tia_round_shift(v[i] * scale, shift);
    return (struct tia_dir3){v[0], v[1], v[2]};
}
