/* sweeps.h - sweeps over the integer kernels, for test_math.c (thinned) and exhaustive.c (all).
 *
 * Each sweeps over one kernel's arguments, from `first` on in steps of `step`. It returns the number of results that
 * are wrong or outside the stated bound; sweep_bad is the first wrong argument. Results are checked by exact integer
 * inequalities; or in double, whose error of 2^-53 is far below the 2^-32 in question.
 */
#ifndef TESTS_SWEEPS_H
#define TESTS_SWEEPS_H

#include <math.h>

#include "common/corpus/dice.h"
#include "math/integer.h"

#define TWO_TO_32 (UINT64_C(1) << 32)

struct sweep_range {
    double low, high; /* range of the errors found, in ulp or relative */
};

static uint64_t sweep_bad;

static inline uint64_t sweep_count(int wrong, uint64_t argument, uint64_t total)
{
    if (wrong && !total)
        sweep_bad = argument;
    return total + (wrong != 0);
}

static inline void sweep_widen(struct sweep_range *range, double error)
{
    range->low = error < range->low ? error : range->low;
    range->high = error > range->high ? error : range->high;
}

/* True if r is the root of x, rounded down. x - r^2 <= 2r is x < (r+1)^2 without its overflow. */
static inline int sweep_is_root(uint64_t x, uint64_t r)
{
    return r * r <= x && x - r * r <= 2 * r && r < TWO_TO_32;
}

/* Sweeps over every 32-bit r: r^2 - 1, r^2 and r^2 + 2r, where the root changes. */
static inline uint64_t sweep_sqrt64_squares(uint64_t first, uint64_t step)
{
    uint64_t bad = 0;
    for (uint64_t r = first ? first : 1; r < TWO_TO_32; r += step) {
        uint64_t x = r * r;
        int wrong = tia_sqrt64(x - 1) != r - 1 || tia_sqrt64(x) != r || tia_sqrt64(x + 2 * r) != r;
        bad = sweep_count(wrong, r, bad);
    }
    return bad;
}

static inline uint64_t sweep_sqrt64_random(uint64_t seed, uint64_t count)
{
    uint64_t bad = 0, state = seed;
    for (uint64_t i = 0; i < count; i++) {
        uint64_t x = dice_next(&state);
        x >>= x & 63;
        bad = sweep_count(!sweep_is_root(x, tia_sqrt64(x)), x, bad);
    }
    return bad;
}

static inline uint64_t sweep_sqrt64_small(uint64_t first, uint64_t step)
{
    uint64_t bad = 0;
    for (uint64_t x = first; x < TWO_TO_32; x += step)
        bad = sweep_count(!sweep_is_root(x, tia_sqrt64(x)), x, bad);
    return bad;
}

static inline uint64_t sweep_sqrt32(uint64_t first, uint64_t step)
{
    uint64_t bad = 0;
    for (uint64_t x = first; x < TWO_TO_32; x += step)
        bad = sweep_count(!sweep_is_root(x, tia_sqrt32((uint32_t)x)), x, bad);
    return bad;
}

/* Sweeps over the upper words. Their result does not depend on the lower word, so the lower word's two ends bound the
 * error. */
static inline uint64_t sweep_rsqrt(uint64_t first, uint64_t step, struct sweep_range *ulp)
{
    uint64_t bad = 0;
    for (uint64_t a = (UINT64_C(1) << 30) + first; a < TWO_TO_32; a += step) {
        uint64_t n = a << 32;
        double y = (double)tia_rsqrt(n);
        double below = y - 0x1p63 / sqrt((double)n), above = y - 0x1p63 / sqrt((double)(n + (TWO_TO_32 - 1)));
        bad = sweep_count(below < -2 || above > 2 || tia_rsqrt(n) != tia_rsqrt(n | 0xffffffff), a, bad);
        sweep_widen(ulp, below);
        sweep_widen(ulp, above);
    }
    return bad;
}

/* Sweeps over the table's straight lines for 1/sqrt(a). The proofs of the Newton steps (tests/proofs) use their
 * error. */
static inline uint64_t sweep_rsqrt_seed(uint64_t first, uint64_t step, struct sweep_range *relative)
{
    uint64_t bad = 0;
    for (uint64_t a = (UINT64_C(1) << 30) + first; a < TWO_TO_32; a += step) {
        double error = (double)tia_rsqrt_seed((uint32_t)a) * sqrt((double)a * 0x1p-32) * 0x1p-31 - 1;
        bad = sweep_count(fabs(error) > 3.2e-6, a, bad);
        sweep_widen(relative, error);
    }
    return bad;
}

/* Sweeps over the table's straight lines for 1/d, see sweep_rsqrt_seed(). */
static inline uint64_t sweep_reciprocal_seed(uint64_t first, uint64_t step, struct sweep_range *relative)
{
    uint64_t bad = 0;
    for (uint64_t d = (UINT64_C(1) << 31) + first; d < TWO_TO_32; d += step) {
        double error = (double)tia_reciprocal_seed((uint32_t)d) * (double)d * 0x1p-63 - 1;
        bad = sweep_count(fabs(error) > 7.9e-6, d, bad);
        sweep_widen(relative, error);
    }
    return bad;
}

static inline uint64_t sweep_reciprocal(uint64_t first, uint64_t step, struct sweep_range *ulp)
{
    uint64_t bad = 0;
    for (uint64_t d = (UINT64_C(1) << 31) + first; d < TWO_TO_32; d += step) {
        double error = (double)tia_reciprocal((uint32_t)d) - 0x1p63 / (double)d;
        bad = sweep_count(error < -1.02 || error > 0.25, d, bad);
        sweep_widen(ulp, error);
    }
    return bad;
}

static inline uint64_t sweep_clz32(uint64_t first, uint64_t step)
{
    uint64_t bad = 0;
    for (uint64_t x = first ? first : 1; x < TWO_TO_32; x += step) {
        unsigned z = tia_clz32((uint32_t)x);
        int wrong = z > 31 || (x << z & UINT64_C(0xffffffff80000000)) != UINT64_C(0x80000000);
        wrong |= tia_clz64(x) != z + 32 || tia_clz64(x << 32 | 1) != z;
        bad = sweep_count(wrong, x, bad);
    }
    return bad;
}

/* Sweeps over random vectors, with components of random magnitude: the results are within 1.5 ulp of Q2.30. */
static inline uint64_t sweep_normalise(uint64_t seed, uint64_t count, struct sweep_range *ulp)
{
    uint64_t bad = 0, state = seed;
    for (uint64_t i = 0; i < count; i++) {
        uint64_t xy = dice_next(&state), zs = dice_next(&state);
        int32_t x = (int32_t)xy >> (zs & 31), y = (int32_t)(xy >> 32) >> (zs >> 5 & 31);
        int32_t z = (int32_t)(zs >> 32) >> (zs >> 10 & 31);
        if (!(x | y | z))
            continue;
        struct tia_dir3 n = tia_normalise(x, y, z);
        double scale = 0x1p30 / sqrt((double)x * x + (double)y * y + (double)z * z);
        double errors[3] = {n.x - x * scale, n.y - y * scale, n.z - z * scale};
        for (int k = 0; k < 3; k++) {
            bad = sweep_count(fabs(errors[k]) > 1.5, xy, bad);
            sweep_widen(ulp, errors[k]);
        }
    }
    return bad;
}

#endif
