/* The operations of q16's number layer, each against its specification in the header: exact ones at their boundaries,
 * rounded ones by the size, the sign and the mean of their errors. */
#include "check.h"
#include "num/num.h"
#include "random.h"

#include <math.h>

#define ROUNDS 200000

#ifdef __SIZEOF_INT128__

__extension__ typedef __int128 wide128;

/* True if result 2^s is `exact` rounded to nearest, ties up. */
static bool nearest(wide128 result, wide128 exact, unsigned s)
{
    wide128 half = (wide128)1 << s >> 1, error = result * ((wide128)1 << s) - exact;

    return error <= half && error > (s > 0 ? -half : -1);
}

TEST(products_are_rounded_to_nearest)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_u a = (num_u)random_short(32), b = (num_u)random_short(32), c = (num_u)random_short(31),
              d = (num_u)random_short(31);
        num_u cosine = (num_u)(random_bits() % ((uint64_t)NUM_ONE + 1));
        CHECK(nearest(num_mul_top(a, b), (wide128)a * b, 32));
        CHECK(nearest(num_colour_product(c, d), (wide128)c * d, 30));
        CHECK(nearest(num_lambert(cosine, UINT32_C(1) << 31), (wide128)cosine << 31, 31));
        CHECK(nearest(num_lambert(c, d >> 1), (wide128)c * (d >> 1), 31));
        int s = 1 + (int)(random_bits() % 62);
        CHECK(nearest(num_bias_product(c, d, s), (wide128)c * d, (unsigned)s));
    }
    CHECK_EQ(num_colour_product(NUM_ONE, NUM_ONE), NUM_ONE);
    CHECK_EQ(num_colour_product(1 << 29, 1), 1); /* halves go up */
    CHECK_EQ(num_colour_product((1 << 29) - 1, 1), 0);
}

TEST(shifts_are_rounded_to_nearest)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_wide x = (num_wide)random_short(62);
        unsigned s = (unsigned)(random_bits() % 63);
        x = random_bits() & 1 ? -x : x;
        CHECK(nearest(num_shift(x, -(int)s), x, s));
    }
    CHECK_EQ(num_scale_within(NUM_HALF + 1, -1), (1 << 30) + 1);
    CHECK_EQ(num_scale_within((INT64_C(1) << 33) - 2, -1), UINT32_MAX);
    CHECK_EQ(num_scale_within(INT64_C(1) << 33, -1), UINT32_MAX);
    CHECK_EQ(num_scale_within(INT64_C(5) << 32, -2), UINT32_MAX);
    CHECK_EQ(num_scale_within(3, 31), UINT32_MAX);
    CHECK_EQ(num_scale_within(INT64_MAX, -64), 0);
    CHECK_EQ(num_shift(-3, 5), -96);
    CHECK_EQ(num_shift(3, -1), 2);
    CHECK_EQ(num_shift(-3, -1), -1);
    CHECK_EQ(num_shift(INT64_C(1) << 61, -64), 0);
    CHECK_EQ(num_top(-1), -1); /* rounded down */
    CHECK_EQ(num_top_u((INT64_C(5) << 32) + UINT32_MAX), 5);
    CHECK_EQ(num_top(NUM_HALF), 0);
    CHECK_EQ(num_top(2 * NUM_HALF), 1);
}

TEST(lengths_in_bits)
{
    CHECK_EQ(num_bits(0), 0);
    CHECK_EQ(num_bits(1), 1);
    CHECK_EQ(num_bits(-1), 1);
    CHECK_EQ(num_bits(255), 8);
    CHECK_EQ(num_bits(-256), 9);
    CHECK_EQ(num_bits(INT64_MAX), 63);
}

/* The least channel that gives level n is the smallest c with levels c + 1/2 >= n. */
TEST(levels_begin_where_they_should)
{
    static const unsigned most[] = {31, 63};

    for (size_t i = 0; i < 2; i++) {
        for (unsigned n = 1; n <= most[i]; n++) {
            uint64_t least = (((uint64_t)(2 * n - 1) << 29) + most[i] - 1) / most[i];
            CHECK_EQ(num_quantise((num_u)least, most[i], NUM_ROUND), n);
            CHECK_EQ(num_quantise((num_u)least - 1, most[i], NUM_ROUND), n - 1);
        }
        CHECK_EQ(num_quantise(0, most[i], NUM_ROUND), 0);
        CHECK_EQ(num_quantise(NUM_ONE, most[i], NUM_ROUND), most[i]);
        CHECK_EQ(num_quantise(NUM_ONE, most[i], num_threshold(63)), most[i]);
    }
    CHECK_EQ(num_threshold(0), (1 << 30) / 128);
    CHECK_EQ(num_threshold(63), 127 * ((1 << 30) / 128));
}

/* Results are a/b 2^(63 - s), below 2^31, with an error of at most half a unit from rounding and one from the
 * reciprocal. The mean error distinguishes rounding from truncation. */
TEST(quotients)
{
    double sum = 0;

    for (int i = 0; i < ROUNDS; i++) {
        num_u b = (num_u)random_short(31) + 1, a = (num_u)random_short(31);
        int bits = num_bits(a) - num_bits(b), s = 63 + bits - 30 + (int)(random_bits() % 10);
        long double exact = ldexpl((long double)a / b, 63 - s);
        long double error = num_quotient(a, b, s) - exact;
        CHECK_MSG(fabsl(error) <= 1.5L, "%u/%u, %d: off by %Lg", (unsigned)a, (unsigned)b, s, error);
        sum += (double)error;
    }
    CHECK_MSG(fabs(sum / ROUNDS) < 0.03, "the mean error is %g", sum / ROUNDS);
}

TEST(normals)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_wide x = (num_wide)random_short(63) | 1;
        struct num_normal n = num_normal(x);
        CHECK(n.mantissa == (num_uwide)x << 2 * n.half && n.mantissa >> 62 != 0);
        long double exact = ldexpl(1 / sqrtl((long double)n.mantissa), 63);
        CHECK_MSG(fabsl(n.inverse - exact) <= 2, "%jd: off by %Lg", (intmax_t)x, n.inverse - exact);
        CHECK_EQ(num_normal_top(n), n.mantissa >> 32);
        num_uwide root = num_sqrt(n.mantissa);
        CHECK(root * root <= n.mantissa && ((wide128)root + 1) * ((wide128)root + 1) > n.mantissa);
    }
}

TEST(a_cone_has_its_edge)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_wide m = (num_wide)random_short(30) + 2, n = (num_wide)random_short(30) + 2;
        CHECK_EQ(num_cone(m * n, m * m, n * n, -1), 1);
        CHECK_EQ(num_cone(m * n - 1, m * m, n * n, -1), -1);
        CHECK_EQ(num_cone(m * n, m * m + 1, n * n, -1), -1);
        CHECK_EQ(num_cone(-m * n, m * m, n * n, -1), -1);
        CHECK_EQ(num_cone(-m * n, -m, n, -1), 1); /* from inside */
        CHECK_EQ(num_cone(m * n, m * m, n * n, 0), 0);
    }
}

/* A verdict is right even if b^2 - c q is off by doubt 2^64, and there is one wherever |b^2 - c q| exceeds (doubt + 2)
 * 2^64. */
TEST(a_cone_in_doubt)
{
    int open = 0;

    for (int i = 0; i < ROUNDS; i++) {
        num_wide c = (num_wide)random_short(22) << 40, q = (num_wide)random_short(62) + 1,
                 doubt = (num_wide)random_short(40);
        c += (num_wide)(random_bits() >> 24);
        num_wide b = (num_wide)sqrtl((long double)c * (long double)q);
        b = (num_wide)((long double)b * (1 + ldexpl((long double)random_short(20) - (1 << 19), -40)));
        b = random_bits() & 7 ? b : -b;
        wide128 apart = (wide128)b * b - (wide128)c * q, most = (wide128)doubt << 64;
        int verdict = num_cone(b, c, q, doubt);
        open += !verdict;
        if (verdict)
            CHECK(verdict > 0 ? b >= 0 && apart > most : b < 0 || apart < -most);
        else
            CHECK(apart <= most + ((wide128)2 << 64) && apart >= -most - ((wide128)2 << 64));
    }
    CHECK_MSG(open > ROUNDS / 50 && open < ROUNDS - ROUNDS / 50, "%d are open", open);
}

/* Binary logarithms in 256ths and their powers of two. These may be too large by 2^.0861 and 2 units, logarithms too
 * small by 24. */
TEST(logarithms)
{
    CHECK_EQ(num_bound_of_log(0), 2);
    CHECK_EQ(num_bound_of_log(-1), 1);
    CHECK_EQ(num_bound_of_log(62 * 256), INT64_C(1) << 62);
    CHECK_EQ(num_bound_of_log(99 * 256), INT64_C(1) << 62);
    CHECK_EQ(num_log(1), 0);
    CHECK_EQ(num_log(INT64_C(1) << 62), 62 * 256);
    CHECK(num_log(0) < -40 * 256);
    for (int log = 0; log < 62 * 256; log++) {
        long double exact = exp2l(log / 256.0L), bound = (long double)num_bound_of_log(log);
        CHECK_MSG(bound >= exact && bound <= exact * 1.0615L + 2, "log %d: %Lg, not %Lg", log, bound, exact);
    }
    for (int i = 0; i < ROUNDS; i++) {
        num_wide x = (num_wide)random_short(63) | 1;
        long double exact = 256 * log2l((long double)x), log = num_log(x);
        CHECK_MSG(log <= exact && log + 24 >= exact, "%jd: %Lg, not %Lg", (intmax_t)x, log, exact);
        num_wide y = (num_wide)random_short(63);
        CHECK_EQ(num_high(x, y), (num_wide)((wide128)x * y >> 64));
    }
}

TEST(products_are_compared_exactly)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_wide a = (num_wide)random_short(62), b = (num_wide)random_short(62), c = (num_wide)random_short(62) + 1,
                 d = (num_wide)random_short(62);
        a = random_bits() & 1 ? -a : a;
        d = random_bits() & 1 ? -d : d;
        CHECK_EQ(num_product_above(a, b, c, d), (wide128)a * b > (wide128)c * d);
        CHECK(!num_product_above(a, c, c, a));
        CHECK(num_product_above(a + 1, c, c, a));
    }
}

TEST(the_nearer_of_two_scales)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_u t = (num_u)random_short(31), u = (num_u)random_short(31);
        int e = (int)(random_bits() % 60), f = e + (int)(random_bits() % 67) - 33;
        CHECK_EQ(num_nearer(t, e, u, f), ldexp(t, -e) < ldexp(u, -f));
        CHECK(!num_nearer(t, e, t, e));
    }
    CHECK(!num_nearer(2, 1, 1, 0) && !num_nearer(1, 0, 2, 1)); /* equal */
}

/* Distances with doubts are ordered only where all numbers within the doubts have that order. */
TEST(the_nearer_in_doubt)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_u t = (num_u)random_short(31), u = (num_u)random_short(31), d = (num_u)random_short(30);
        num_u c = (num_u)random_short(30);
        int e = (int)(random_bits() % 60), f = e + (int)(random_bits() % 61) - 30;
        long double apart = ldexpl(t, -e) - ldexpl(u, -f), doubt = ldexpl(d, -e) + ldexpl(c, -f);
        int order = num_order(t, e, d, u, f, c), wanted = apart < -doubt ? -1 : apart > doubt;
        CHECK_EQ(order, wanted);
        int shift = (int)(random_bits() % 32);
        long double least = floorl(ldexpl((long double)t * t, -32 - shift));
        CHECK(num_distance_doubt(t, shift, 7) >= least + 7 &&
              num_distance_doubt(t, shift, 7) <= least + 8 + t / 67108864.0);
    }
}

/* num_cover_order compares a^2 with d k swell. */
TEST(what_covers)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_wide d = (num_wide)random_short(60) + (1 << 20), k = (num_wide)random_short(60) + (1 << 20);
        num_u swell =
            (UINT32_C(1) << 31) + ((random_bits() & 1) ? (num_u)random_short(28) : 0 - (num_u)random_short(28));
        struct num_normal n = num_normal(d);
        long double root = sqrtl((long double)d * (long double)k * ldexpl(swell, -31));
        int e = 2 * (int)(random_bits() % 3), margin = 5 + (int)(random_bits() % 22);
        long double near = ldexpl(1, -margin), off = .51L * near + 0x1p-28L;
        root = ldexpl(root, e / 2);
        if (root < INT64_C(1) << 34 || root > 2e18L)
            continue;
        num_wide above = (num_wide)(root * (1 + off * (1 + near))), below = (num_wide)(root * (1 - off));
#define ORDER(a) num_cover_order(a, num_normal_top(n), n.half, k, swell, e, margin)
        CHECK_MSG(ORDER(above) == 1, "%jd above", (intmax_t)above);
        CHECK_MSG(ORDER(below) == -1, "%jd below", (intmax_t)below);
        CHECK_EQ(ORDER(above * 2), 1);
        CHECK_EQ(ORDER(below / 2), -1);
        if (margin <= 24) {
            CHECK_EQ(ORDER((num_wide)(root * (1 + .47L * near))), 0);
            CHECK_EQ(ORDER((num_wide)(root * (1 - .47L * near / (1 + near)))), 0);
        }
    }
}

/* The bias for a radius R = 2^16 r is bias/r = 2^-13 2^16 / R = 8/R. */
TEST(the_bias)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_wide r = (num_wide)random_short(31) + 64;
        num_u inverse = num_inverse(r);
        int bits = num_bits(r);
        CHECK(fabs(num_swell(inverse, bits, false) - ldexp(1 + 8.0 / (double)r, 31)) <= 1);
        CHECK(fabs(num_swell(inverse, bits, true) - ldexp(1 - 8.0 / (double)r, 31)) <= 1);
        num_wide x = (num_wide)random_short(50);
        x = random_bits() & 1 ? -x : x;
        double exact = (double)x * 8.0 / (double)r; /* exponent 30 */
        CHECK_MSG(fabs((double)num_bias_of(x, inverse, bits, 30) - exact) <= 0.51 + fabs(exact) * 0x1p-28,
                  "%jd over %jd", (intmax_t)x, (intmax_t)r);
    }
}

/* A channel is near a level, with any threshold, where its doubt reaches the boundary to another level. */
TEST(channels_near_levels)
{
    for (int i = 0; i < ROUNDS; i++) {
        unsigned most = random_bits() & 1 ? 31 : 63;
        num_u c = (num_u)(random_bits() % (NUM_ONE + 1)), threshold = num_threshold((unsigned)(random_bits() % 64));
        num_u doubt = random_bits() & 1 ? (num_u)random_short(20) + 1 : 0, margin = num_level_doubt(doubt, most);
        num_u from = num_level_threshold(threshold, margin), level = num_level(c, most, from);
        num_u low = c > doubt ? c - doubt : 0, high = c + doubt < NUM_ONE ? c + doubt : NUM_ONE;
        bool differ = num_quantise(low, most, threshold) != num_quantise(high, most, threshold);
        CHECK(!differ || num_is_near_level(level, margin));
        CHECK(num_is_near_level(level, margin) || num_floor_level(level) == num_quantise(c, most, threshold));
        CHECK_EQ(num_further_level(num_level(c, 31, from), c, 32, from), num_level(c, 63, from));
    }
}

/* The doubt of a light's contribution: `product` times the error of the cosine, and some units. */
TEST(doubts_of_lights)
{
    for (int i = 0; i < ROUNDS; i++) {
        num_u product = (num_u)(random_bits() % ((UINT64_C(1) << 31) + 1));
        int log = -9 * 256 - (int)(random_bits() % 5000);
        uint32_t tints = (uint32_t)(random_bits() % 9);
        long double exact = product * exp2l(log / 256.0L) + 1 + tints / 2.0L;
        CHECK((long double)num_light_doubt(product, log, tints) >= exact);
        CHECK((long double)num_light_doubt(product, log, tints) <= exact * 1.0615L + 4);
    }
}

TEST(what_is_within)
{
    CHECK(num_is_within(3, -4, 12, 13) && !num_is_within(3, -4, 12, 12) && num_is_within(0, 0, 0, 0));
    for (int i = 0; i < ROUNDS; i++) {
        num_wide x = (num_wide)random_short(31), y = -(num_wide)random_short(31), z = (num_wide)random_short(31);
        wide128 square = (wide128)x * x + (wide128)y * y + (wide128)z * z;
        num_wide r = (num_wide)sqrtl((long double)square) + (num_wide)(random_bits() % 3) - 1;
        r = r < 0 ? 0 : r > INT32_MAX ? INT32_MAX : r;
        CHECK_EQ(num_is_within(x, y, z, r), square <= (wide128)r * r);
    }
}

TEST(sums_of_squares)
{
    CHECK_EQ(num_sum_of_squares30(1, 1, 1), 0);
    CHECK_EQ(num_sum_of_squares30(-2, 0, 0), 1);
    CHECK_EQ(num_sum_of_squares30(3, -4, 12), 42); /* 169/4 */
    CHECK_EQ(num_sum_of_squares30(INT64_C(1) << 31, 0, 0), INT64_C(1) << 60);
}

int main(void)
{
    RUN(products_are_rounded_to_nearest);
    RUN(shifts_are_rounded_to_nearest);
    RUN(lengths_in_bits);
    RUN(levels_begin_where_they_should);
    RUN(quotients);
    RUN(normals);
    RUN(a_cone_has_its_edge);
    RUN(a_cone_in_doubt);
    RUN(logarithms);
    RUN(products_are_compared_exactly);
    RUN(the_nearer_of_two_scales);
    RUN(the_nearer_in_doubt);
    RUN(what_covers);
    RUN(the_bias);
    RUN(channels_near_levels);
    RUN(doubts_of_lights);
    RUN(what_is_within);
    RUN(sums_of_squares);
    return check_status();
}

#else

int main(void)
{
    printf("skip num: no 128-bit integers on this machine\n");
    return 0;
}

#endif
