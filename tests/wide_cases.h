/* wide_cases.h - tests src/math/wide.h against exact definitions, for either implementation of products. */
#include <math.h>

#include "check.h"
#include "math/wide.h"
#include "random.h"

__extension__ typedef __int128 exact;

/* Returns a random number of up to `most` bits, of random length and sign. */
static int64_t some(int most)
{
    int64_t n = (int64_t)(random_bits() >> (64 - 1 - random_bits() % (unsigned)most));
    return random_bits() & 1 ? n : -n;
}

static exact value(wide a)
{
    return (exact)wide_high(a) * ((exact)1 << 32) * ((exact)1 << 32) + wide_low(a);
}

TEST(sums_and_products_are_exact)
{
    for (int i = 0; i < 200000; i++) {
        int64_t a = some(62), b = some(62), c = some(62), d = some(62);
        unsigned s = 1 + (unsigned)(random_bits() % 60);
        wide ab = wide_product(a, b), cd = wide_product(c, d);
        CHECK(value(ab) == (exact)a * b);
        CHECK(value(wide_sum(ab, cd)) == (exact)a * b + (exact)c * d);
        CHECK(value(wide_difference(ab, cd)) == (exact)a * b - (exact)c * d);
        CHECK(wide_round(ab, s + 63) == (int64_t)(((exact)a * b + ((exact)1 << (s + 62))) >> (s + 63)));
        CHECK(value(wide_up(wide_product(a, 1), s)) == (exact)a * ((exact)1 << s));
    }
}

static bool is_root(exact n, int64_t r)
{
    return r >= 0 && (exact)r * r <= n && n < ((exact)r + 1) * ((exact)r + 1);
}

TEST(square_roots_are_exact)
{
    for (int i = 0; i < 300000; i++) {
        int64_t r = some(63);
        r = r < 0 ? -r : r;
        for (int d = -1; d <= 1; d++) {
            exact n = (exact)r * r + d;
            if (n >= 0 && n < (exact)1 << 126)
                CHECK(is_root(n, wide_sqrt(wide_sum(wide_product(r, r), wide_product(d, 1)))));
        }
        if (r < INT64_C(1) << 62) /* r^2 + 2r has the root r */
            CHECK_EQ(wide_sqrt(wide_product(r, r + 2)), r);
        exact n = (exact)(some(62)) * some(62);
        n = n < 0 ? -n : n;
        CHECK(is_root(n, wide_sqrt(wide_sum(wide_up(wide_product((int64_t)(n >> 62), 1), 62),
                                            wide_product((int64_t)(n & (((exact)1 << 62) - 1)), 1)))));
    }
}

TEST(quotients_err_by_half_a_unit_and_a_little)
{
    for (int i = 0; i < 300000; i++) {
        int64_t a = some(62), b = some(62);
        int e = (int)(random_bits() % 63);
        if (!b)
            continue;
        exact most = (exact)1 << 62, wanted = a * ((exact)1 << e) / b, got = wide_quotient(a, b, e);
        exact error = wanted - got, size = wanted < 0 ? -wanted : wanted;
        if (size >= most)
            CHECK((size < most + 16 && error < 16 && error > -16) || got == (wanted < 0 ? -most : most));
        else
            CHECK_MSG((error < 0 ? -error : error) <= 1 + (size >> 58), "%lld / %lld e %d: off by %lld", (long long)a,
                      (long long)b, e, (long long)error);
    }
    CHECK_EQ(wide_quotient(1, 0, 3), INT64_C(1) << 62);
    CHECK_EQ(wide_quotient(-1, 0, 3), -(INT64_C(1) << 62));
    CHECK_EQ(wide_quotient(0, 0, 3), 0);
    CHECK_EQ(wide_quotient(6, 3, 0), 2);
}

TEST(vectors_are_normalised)
{
    for (int i = 0; i < 200000; i++) {
        int64_t v[3] = {some(61), some(61), some(61)}, d[3];
        long double length = sqrtl((long double)v[0] * v[0] + (long double)v[1] * v[1] + (long double)v[2] * v[2]);
        bool any = wide_normalise(v, d);
        CHECK_EQ(any, length > 0);
        for (int k = 0; any && k < 3; k++) {
            long double off = (long double)d[k] / (INT64_C(1) << 62) - (long double)v[k] / length;
            CHECK_MSG(fabsl(off) < 0x1p-58L, "off by %Lg of 2^-62", off * 0x1p62L);
        }
    }
}

/* Returns a random number of 128 bits, of random length up to `most` bits. */
static exact any(unsigned most)
{
    exact n = (exact)(int64_t)random_bits() * ((exact)1 << 64) + random_bits();

    return n >> (128 - most + (unsigned)(random_bits() % most));
}

static wide given(exact n)
{
    return wide_of_halves((int64_t)(n >> 64), (uint64_t)n);
}

TEST(numbers_of_128_bits_are_multiplied_and_ordered)
{
    for (int i = 0; i < 200000; i++) {
        exact a = any(65), b = any(128);
        int64_t n = some(62);
        CHECK(value(given(b)) == b);
        CHECK(value(wide_times(given(a), n)) == a * n);
        CHECK(value(wide_negative(given(a))) == -a);
        CHECK_EQ(wide_sign(given(b)), (b > 0) - (b < 0));
    }
    CHECK_EQ(wide_sign(given(0)), 0);
    CHECK_EQ(wide_sign(given((exact)1 << 64)), 1);
}

/* Products: with a = p q, b = r s, c = p r, d = q s + e: a b - c d = -p r e. */
TEST(products_of_256_bits_are_ordered)
{
    for (int i = 0; i < 200000; i++) {
        exact p = any(62), q = any(62), r = any(62), s = any(62);
        int e = (int)(random_bits() % 3) - 1, sign = ((p > 0) - (p < 0)) * ((r > 0) - (r < 0)) * -e;
        CHECK_EQ(wide_order_of_products(given(p * q), given(r * s), given(p * r), given(q * s + e)), sign);
        exact a = any(63), b = any(63), c = any(63), d = any(63);
        CHECK_EQ(wide_order_of_products(given(a), given(b), given(c), given(d)), (a * b > c * d) - (a * b < c * d));
    }
}

int main(void)
{
    RUN(sums_and_products_are_exact);
    RUN(numbers_of_128_bits_are_multiplied_and_ordered);
    RUN(products_of_256_bits_are_ordered);
    RUN(square_roots_are_exact);
    RUN(quotients_err_by_half_a_unit_and_a_little);
    RUN(vectors_are_normalised);
    return check_status();
}
