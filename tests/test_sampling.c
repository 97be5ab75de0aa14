/* Sobol points against the definition of their uniformity; directions and powers against long double. */
#include "math/power.h"
#include "samples/direction.h"
#include "samples/sobol.h"

#include <math.h>
#include <tia/material.h>

#include "check.h"
#include "random.h"

#define ONE 4611686018427387904.0L /* 2^62 */

static const long double pi = 3.14159265358979323846264338327950288L;

/* Returns 2^-bits as an error bound; 2^-48 at least where long double has no more bits than double. */
static long double bound(int bits)
{
    return ldexpl(1, sizeof(long double) > 8 ? -bits : bits < 48 ? -bits : -48);
}

static long double unit(uint32_t u)
{
    return ((long double)u + 0.5L) / 4294967296.0L;
}

/* ---- points ---- */

enum { M = 8, POINTS = 1 << M, T = 3 };

static void draw(uint32_t seed, uint32_t quad, uint32_t u[POINTS][4])
{
    for (uint32_t i = 0; i < POINTS; i++) {
        struct sampler sampler = sampler_of(seed, 3, 5, i);
        sampler_pair(&sampler, quad, 0, u[i]);
        sampler_pair(&sampler, quad, 2, u[i] + 2);
    }
}

/* Returns the largest number of points in a box whose side in dimension k is 2^-bits[k]. */
static uint32_t most_in_a_box(uint32_t u[POINTS][4], const unsigned bits[4])
{
    uint32_t counts[POINTS] = {0}, most = 0;

    for (unsigned i = 0; i < POINTS; i++) {
        uint32_t box = 0;
        for (unsigned k = 0; k < 4; k++)
            box = (uint32_t)((uint64_t)box << bits[k]) | (uint32_t)((uint64_t)u[i][k] >> (32 - bits[k]));
        most = ++counts[box] > most ? counts[box] : most;
    }
    return most;
}

/* Quads are (t, m, s)-nets: every elementary box of volume 2^(t - m) has 2^t points. */
TEST(quads_are_nets)
{
    static uint32_t u[POINTS][4];

    for (uint32_t seed = 0; seed < 20; seed++) {
        draw(seed, seed, u);
        for (unsigned n = 0; n < 1u << (3 * 3); n++) {
            unsigned bits[4] = {n & 7, n >> 3 & 7, n >> 6 & 7, 0};
            if (bits[0] + bits[1] + bits[2] > M - T)
                continue;
            bits[3] = M - T - bits[0] - bits[1] - bits[2];
            CHECK_EQ(most_in_a_box(u, bits), 1 << T);
        }
    }
}

/* The first two dimensions together are a net with t = 0, and so is each dimension alone. */
TEST(pairs_are_nets)
{
    static uint32_t u[POINTS][4];

    for (uint32_t seed = 0; seed < 20; seed++) {
        draw(seed, 7, u);
        for (unsigned n = 0; n <= M; n++)
            CHECK_EQ(most_in_a_box(u, (unsigned[4]){n, M - n, 0, 0}), 1);
        CHECK_EQ(most_in_a_box(u, (unsigned[4]){0, 0, M, 0}), 1);
        CHECK_EQ(most_in_a_box(u, (unsigned[4]){0, 0, 0, M}), 1);
    }
}

/* Returns the correlation coefficient of n uniform numbers; for different quads, pixels or seeds it must be about
 * 1/sqrt(n), as for independent numbers. */
static double correlation(const uint32_t *a, const uint32_t *b, unsigned n)
{
    double sum = 0;

    for (unsigned i = 0; i < n; i++)
        sum += (double)(unit(a[i]) - 0.5L) * (double)(unit(b[i]) - 0.5L);
    return 12 * sum / n;
}

TEST(quads_and_pixels_are_independent)
{
    enum { N = 1 << 16 };
    static uint32_t u[6][N];

    for (uint32_t i = 0; i < N; i++) {
        struct sampler here = sampler_of(1, 10, 20, i & 15), right = sampler_of(1, 11 + (int)(i >> 4), 20, i & 15);
        struct sampler below = sampler_of(1, 10, 21 + (int)(i >> 4), i & 15),
                       other = sampler_of(2 + (i >> 4), 10, 20, i & 15);
        uint32_t pair[2];
        sampler_pair(&here, 1 + (i >> 4), 0, pair), u[0][i] = pair[0];
        sampler_pair(&here, 1 + (i >> 4), 2, pair), u[1][i] = pair[0];
        sampler_pair(&here, 100000 + (i >> 4), 0, pair), u[2][i] = pair[0];
        sampler_pair(&right, 1, 0, pair), u[3][i] = pair[0];
        sampler_pair(&below, 1, 0, pair), u[4][i] = pair[0];
        sampler_pair(&other, 1, 0, pair), u[5][i] = pair[0];
    }
    for (int a = 0; a < 6; a++)
        for (int b = 0; b < a; b++)
            CHECK_MSG(fabs(correlation(u[a], u[b], N)) < 5 / sqrt(N), "%d and %d", a, b);
}

/* ---- powers ---- */

TEST(logarithms)
{
    for (int i = 0; i < 200000; i++) {
        int64_t x = (int64_t)random_short(62) + 1;
        long double want = -log2l((long double)x / ONE);
        CHECK_MSG(fabsl((long double)tia_log2(x) / ldexpl(1, 56) - want) <= bound(56) + want * bound(60), "%" PRId64,
                  x);
    }
    CHECK_EQ(tia_log2(INT64_C(1) << 62), 0);
    CHECK_EQ(tia_log2((INT64_C(1) << 62) - 1), 0);
}

TEST(powers)
{
    for (int i = 0; i < 200000; i++) {
        int64_t y = (int64_t)(random_bits() >> 2);
        long double want = exp2l(-(long double)y / ldexpl(1, 56)),
                    got = (long double)tia_exp2(INT64_C(1) << 62, y) / ONE;
        CHECK_MSG(fabsl(got - want) <= want * bound(56) + bound(61), "%" PRId64, y);
    }
    CHECK_EQ(tia_exp2(INT64_C(1) << 62, 0), INT64_C(1) << 62);
    CHECK_EQ(tia_exp2(INT64_C(1) << 62, INT64_C(3) << 56), INT64_C(1) << 59);
    CHECK_EQ(tia_exp2(INT64_C(1) << 62, INT64_MAX), 0);
}

/* ---- directions ---- */

static void any_pair(uint32_t u[2], int i)
{
    static const uint32_t edges[] = {0, 1, UINT32_MAX / 2, UINT32_MAX / 2 + 1, UINT32_MAX - 1, UINT32_MAX};

    u[0] = i < 36 ? edges[i / 6] : random_u32();
    u[1] = i < 36 ? edges[i % 6] : random_u32();
}

static void check_direction(const int64_t got[], const long double want[], int count, int bits)
{
    for (int k = 0; k < count; k++)
        CHECK_MSG(fabsl((long double)got[k] / ONE - want[k]) <= bound(bits), "component %d is off by %Lg", k,
                  (long double)got[k] / ONE - want[k]);
}

static void check_length(const int64_t d[3])
{
    long double x = (long double)d[0] / ONE, y = (long double)d[1] / ONE, z = (long double)d[2] / ONE;

    CHECK_MSG(fabsl(sqrtl(x * x + y * y + z * z) - 1) <= bound(58), "length");
}

TEST(turns)
{
    for (int i = 0; i < 200000; i++) {
        uint32_t u[2];
        int64_t got[2];
        any_pair(u, i);
        tia_sample_turn(u[0], &got[0], &got[1]);
        check_direction(got, (long double[]){sinl(2 * pi * unit(u[0])), cosl(2 * pi * unit(u[0]))}, 2, 60);
    }
}

/* Gives the point of the unit disc by Shirley and Chiu's concentric map. */
static void disc(const uint32_t u[2], long double place[2])
{
    long double a = 2 * unit(u[0]) - 1, b = 2 * unit(u[1]) - 1;
    bool wide = fabsl(a) > fabsl(b);
    long double r = wide ? a : b, angle = wide ? pi / 4 * (b / a) : pi / 2 - pi / 4 * (a / b);

    place[0] = r * cosl(angle);
    place[1] = r * sinl(angle);
}

TEST(cosines)
{
    for (int i = 0; i < 200000; i++) {
        uint32_t u[2];
        int64_t got[3], flat[2];
        long double want[3];
        any_pair(u, i);
        tia_sample_cosine(u, got);
        tia_sample_disc(u, flat);
        disc(u, want);
        long double a = fabsl(2 * unit(u[0]) - 1), b = fabsl(2 * unit(u[1]) - 1), r = a > b ? a : b;
        want[2] = sqrtl((1 - r) * (1 + r));
        check_direction(got, want, 3, 59);
        check_direction(flat, want, 2, 60);
        check_length(got);
    }
}

/* 64 rings of equal area and 64 equal sectors contain about equally many points. */
TEST(discs_are_even)
{
    enum { N = 1 << 20 };
    unsigned rings[64] = {0}, sectors[64] = {0};

    for (uint32_t i = 0; i < N; i++) {
        struct sampler sampler = sampler_of(1, 0, 0, i);
        uint32_t u[2];
        int64_t p[2];
        sampler_pair(&sampler, 0, 0, u);
        tia_sample_disc(u, p);
        long double x = (long double)p[0] / ONE, y = (long double)p[1] / ONE;
        rings[(unsigned)(64 * (x * x + y * y))]++;
        sectors[(unsigned)(64 * (atan2l(y, x) / (2 * pi) + 1)) % 64]++;
    }
    for (int i = 0; i < 64; i++) {
        CHECK_MSG(fabs(rings[i] / (N / 64.0) - 1) < 0.005, "ring %d has %u", i, rings[i]);
        CHECK_MSG(fabs(sectors[i] / (N / 64.0) - 1) < 0.005, "sector %d has %u", i, sectors[i]);
    }
}

TEST(lobes)
{
    static const tia_q16 exponents[] = {TIA_Q16(1), TIA_Q16(1.5), TIA_Q16(50), TIA_Q16(999.25), TIA_EXPONENT_MAX};

    for (int i = 0; i < 200000; i++) {
        uint32_t u[2];
        int64_t got[3];
        tia_q16 n = exponents[i % 5];
        any_pair(u, i / 5);
        tia_sample_phong(u, n, got);
        long double y = -logl(unit(u[0])) / ((long double)n / 65536 + 1), z = expl(-y),
                    r = sqrtl(-expm1l(-y) * (1 + z));
        check_direction(got, (long double[]){r * cosl(2 * pi * unit(u[1])), r * sinl(2 * pi * unit(u[1])), z}, 3, 36);
        check_length(got);
    }
}

int main(void)
{
    RUN(quads_are_nets);
    RUN(pairs_are_nets);
    RUN(quads_and_pixels_are_independent);
    RUN(logarithms);
    RUN(powers);
    RUN(turns);
    RUN(cosines);
    RUN(discs_are_even);
    RUN(lobes);
    return check_status();
}
