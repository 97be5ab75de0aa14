/* The numbers of general rays in fixed point, each operation against its statement in num_ray.h. */
#include "check.h"
#include "num/num_ray.h"
#include "random.h"

#include <math.h>

#define ROUNDS 100000

#if defined(__SIZEOF_INT128__) && defined(__SIZEOF_FLOAT128__)

__extension__ typedef __int128 exact;
__extension__ typedef __float128 real; /* 113 bits */

/* Returns a number below 2^bits of any length and sign. */
static int64_t any(unsigned bits)
{
    int64_t n = (int64_t)random_short(bits);

    return random_bits() & 1 ? -n : n;
}

static exact square(struct num_point p)
{
    return (exact)p.x * p.x + (exact)p.y * p.y + (exact)p.z * p.z;
}

static struct num_point any_point(unsigned bits)
{
    return (struct num_point){any(bits), any(bits), any(bits)};
}

/* True if the result is within 2^-59 of `want` and half a unit, at most `limit` in size. */
static bool is_quotient(int64_t got, real want, int64_t limit)
{
    real error = (real)got - want, own = want < 0 ? -want : want;

    if (own > (real)limit)
        return own < (real)limit * (1 + (real)0x1p-58) || got == (want < 0 ? -limit : limit);
    return (error < 0 ? -error : error) <= (real)0.5 + own * (real)0x1p-59;
}

TEST(products_are_rounded_to_nearest)
{
    for (int i = 0; i < ROUNDS; i++) {
        struct num_point a = any_point(61);
        struct num_dir d = {any(62), any(62), any(62)};
        exact sum = (exact)a.x * d.x + (exact)a.y * d.y + (exact)a.z * d.z, half = (exact)1 << 61;
        CHECK_EQ(num_times(a.x, d.x), (int64_t)(((exact)a.x * d.x + half) >> 62));
        CHECK_EQ(num_point_dot(a, d), (int64_t)((sum + half) >> 62));
        exact product = (exact)a.x * a.y;
        if (product >> 106 == 0 || product >> 106 == -1)
            CHECK_EQ(num_product(a.x, a.y), (int64_t)((product + ((exact)1 << 44)) >> 45));
    }
}

TEST(roots_are_rounded_down)
{
    for (int i = 0; i < ROUNDS; i++) {
        struct num_point p = any_point(61);
        num_length r = any(62), leg, length = num_norm(p);
        r = r < 0 ? -r : r;
        exact rest = (exact)r * r - square(p);
        leg = num_half_chord(r, p);
        CHECK_EQ(leg < 0, rest < 0);
        CHECK(leg < 0 || ((exact)leg * leg <= rest && rest < (exact)(leg + 1) * (leg + 1)));
        CHECK((exact)length * length <= square(p) && square(p) < (exact)(length + 1) * (length + 1));
    }
}

TEST(coarse_roots_are_not_below)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_unit d = (num_unit)(random_bits() >> 2 >> random_bits() % 62), root = num_root_up(d);
        exact below = (exact)root - ((exact)1 << 34); /* 2^-28 */
        CHECK((exact)root * root >= (exact)d << 62);
        CHECK(below < 0 || below * below <= (exact)d << 62);
    }
}

/* A plane's distance is too small in size, by less than 2^-21 of itself and a unit. */
TEST(slopes_reach_planes_early)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_unit d = any(62) | 1;
        num_length origin = any(61);
        tia_q16 plane = (tia_q16)any(31);
        struct num_slope slope = num_slope(origin, d);
        real want = ((real)num_length_of(plane) - (real)origin) / (real)d * (real)0x1p55; /* 2^38 2^62/2^45 */
        real got = (real)num_walk_to(&slope, plane), size = want < 0 ? -want : want, got_size = got < 0 ? -got : got;
        CHECK(size < 1 || got_size < 1 || (got < 0) == (want < 0));
        CHECK(got_size <= size + 1);
        CHECK(slope.parallel || got_size >= size * (1 - (real)0x1p-21) - 1);
        CHECK_EQ(slope.parallel, (d < 0 ? -d : d) < (num_unit)1 << 54);
    }
    CHECK(num_slope(NUM_LENGTH_FAR, NUM_UNIT_ONE).parallel && num_slope(-NUM_LENGTH_FAR, -1).parallel);
}

TEST(within_has_its_edge)
{
    static const struct num_point whole[] = {{1, 2, 2}, {2, 3, 6}, {-1, 4, 8}, {4, -4, 7}, {6, 6, -7}, {0, 0, -5}};
    static const num_length lengths[] = {3, 7, 9, 9, 11, 5};

    for (int i = 0; i < ROUNDS; i++) {
        int k = i % 6;
        int64_t n = any(58);
        struct num_point p = {whole[k].x * n, whole[k].y * n, whole[k].z * n}, beyond = p;
        num_length r = lengths[k] * (n < 0 ? -n : n);
        beyond.z += beyond.z < 0 ? -1 : 1;
        CHECK(num_within(r, p) && num_within(r + 1, p));
        CHECK(!num_within(r, beyond) && !num_within(r - 1, p));
        CHECK(!num_within(-1, p) && !num_within(-r - 1, p));
    }
}

/* Numbers of 62 bits have squares that nearly cancel: the numerator is exact. */
TEST(what_is_beyond)
{
    for (int i = 0; i < ROUNDS; i++) {
        struct num_point p = any_point(61);
        num_length k = any(62), r = i & 1 ? any(62) : num_norm(p) + any(20);
        real want = (real)(square(p) - (exact)r * r) / (real)k;
        if (k != 0)
            CHECK(is_quotient(num_point_power(p, r, k), want, NUM_LENGTH_MAX));
    }
    CHECK_EQ(num_point_power((struct num_point){3, 0, 4}, 5, 7), 0);
    CHECK_EQ(num_point_power((struct num_point){3, 0, 4}, 4, 0), NUM_LENGTH_MAX);
    CHECK_EQ(num_point_power((struct num_point){3, 0, 4}, 6, 0), -NUM_LENGTH_MAX);
}

TEST(quotients)
{
    for (int i = 0; i < ROUNDS; i++) {
        int64_t x = any(62), y = any(62);
        if (y == 0)
            continue;
        real q = (real)x / (real)y;
        CHECK(is_quotient(num_div(x, y), q * (real)0x1p62, NUM_LENGTH_MAX));
        CHECK(is_quotient(num_ratio(x, y), q * (real)0x1p45, NUM_LENGTH_MAX));
        CHECK(is_quotient(num_fraction(x, y), q * (real)0x1p62, NUM_UNIT_ONE));
    }
    CHECK_EQ(num_div(1, 0), NUM_LENGTH_MAX);
    CHECK_EQ(num_div(-1, 0), -NUM_LENGTH_MAX);
    CHECK_EQ(num_div(0, 0), 0);
}

/* Gives a base, above 1/2 in every fourth round, and an exponent of any length. */
static void any_power(int i, num_unit *d, tia_q16 *e)
{
    *d = (num_unit)random_short(62) | 1;
    *e = (tia_q16)(random_bits() >> 33 >> random_bits() % 31);
    *d = i % 4 ? *d : NUM_UNIT_ONE - *d / 2;
}

/* A power near another is within the bound that it gives, which is used to a fourth and more. */
TEST(powers_near)
{
    real most = 0;

    for (int i = 0; i < ROUNDS / 2; i++) {
        num_unit d, off = -1;
        tia_q16 e;
        any_power(i, &d, &e);
        num_unit error = num_power_near(d, e, &off) - num_power(d, e);
        error = error < 0 ? -error : error;
        CHECK_MSG(off >= 0 && error <= off, "%jd^%jd is off by %jd", (intmax_t)d, (intmax_t)e, (intmax_t)error);
        most = off > 0 && (real)error / (real)off > most ? (real)error / (real)off : most;
    }
    CHECK_MSG(most > (real)0.25, "only %g of the bound is used", (double)most);
}

/* Powers as lengths have the bits of the version with roots, though mostly no root is computed. */
TEST(powers_as_lengths)
{
    for (int i = 0; i < ROUNDS / 2; i++) {
        num_unit d;
        tia_q16 e;
        any_power(i, &d, &e);
        CHECK_MSG(num_power_length(d, e) == num_length_of_unit(num_power(d, e)), "%jd^%jd", (intmax_t)d, (intmax_t)e);
        num_unit whole = num_whole_power(d, e >> 16);
        if (e >> 16 && d < NUM_UNIT_ONE) {
            long double want = (long double)whole * powl((long double)d / 0x1p62L, (long double)(e & 0xffff) / 65536);
            long double off = fabsl((long double)tia_power_near(whole, d, e & 0xffff) - want);
            CHECK_MSG(off < 0x1p7L, "%jd^%jd is off by %Lg", (intmax_t)d, (intmax_t)e, off);
        }
    }
    CHECK_EQ(num_power_length(0, TIA_Q16(3.5)), 0);
    CHECK_EQ(num_power_length(NUM_UNIT_ONE, TIA_Q16(3.5)), NUM_LENGTH_ONE);
}

TEST(exponential_functions)
{
    for (int i = 0; i < ROUNDS / 10; i++) {
        num_length x = (num_length)(random_short(51) * (i % 2 ? 1 : 22));
        long double off = fabsl((long double)num_fade(x) / 0x1p62L - expl(-(long double)x / 0x1p45L));
        CHECK_MSG(off < 0x1p-55L, "exp(-%Lg) is off by %Lg", (long double)x / 0x1p45L, off);
    }
    CHECK_EQ(num_fade(0), NUM_UNIT_ONE);
    CHECK_EQ(num_fade(NUM_LENGTH_MAX), 0);
}

TEST(powers_and_turns)
{
    for (int i = 0; i < ROUNDS / 10; i++) {
        num_unit d = (num_unit)(random_bits() >> 2);
        tia_q16 e = (tia_q16)(random_bits() >> 33 >> random_bits() % 16);
        long double want = powl((long double)d / 0x1p62L, (long double)e / 65536);
        long double off = fabsl((long double)num_power(d, e) / 0x1p62L - want);
        CHECK_MSG(off < 0x1p-44L, "%jd^%jd is off by %Lg", (intmax_t)d, (intmax_t)e, off);
        num_unit y = any(62), x = any(62);
        y = y / 2 +
            (y < 0 ? -NUM_UNIT_ONE / 2 : NUM_UNIT_ONE / 2); /* large enough: the error is relative to the length */
        want = atan2l((long double)y, (long double)x) / (2 * acosl(-1));
        off = fabsl((long double)num_atan2(y, x) / 0x1p62L - want);
        CHECK_MSG(off < 0x1p-54L || off > 1 - 0x1p-54L, "the angle of %jd, %jd is off by %Lg", (intmax_t)x, (intmax_t)y,
                  off);
    }
    CHECK_EQ(num_atan2(0, 0), 0);
}

int main(void)
{
    RUN(products_are_rounded_to_nearest);
    RUN(roots_are_rounded_down);
    RUN(coarse_roots_are_not_below);
    RUN(slopes_reach_planes_early);
    RUN(within_has_its_edge);
    RUN(what_is_beyond);
    RUN(quotients);
    RUN(powers_near);
    RUN(powers_as_lengths);
    RUN(exponential_functions);
    RUN(powers_and_turns);
    return check_status();
}

#else

int main(void)
{
    printf("skip num_ray: no 128-bit numbers on this machine\n");
    return 0;
}

#endif
