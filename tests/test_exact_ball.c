/* The balls of src/exact against exact numbers. A result contains the results of all numbers in its operands. Its
 * radius is 0 where it is exact, and never much larger than it has to be. */
#include "exact_balls.h"

/* ---- sums and products ---- */

static void check_sum(int words, const struct ball *a, const struct ball *b, int side)
{
    struct ball r, same = *a;
    struct exact_number x, y, z, least;

    if (side > 0)
        tia_ball_add(words, &r, a, b);
    else
        tia_ball_sub(words, &r, a, b);
    for (int i = -1; i < 2; i++)
        for (int j = -1; j < 2; j++) {
            point_of(words, a, i, &x);
            point_of(words, b, j, &y);
            exact_sum(&z, &x, &y, side);
            CHECK_MSG(contains(words, &r, &z), "%d words: a sum is not in its ball", words);
        }
    exact_radius(&x, a);
    exact_radius(&y, b);
    exact_sum(&least, &x, &y, 1);
    CHECK(is_normal(words, &r));
    CHECK_MSG(is_tight(&r, &least, 17, 3), "%d words: a sum's radius is %x 2^%d", words, r.radius.m, r.radius.e);
    exact_middle(&x, words, a);
    exact_middle(&y, words, b);
    exact_sum(&z, &x, &y, side);
    CHECK(least.sign || exact_bits(&z) > 32 * words || !r.radius.m);
    if (side > 0)
        tia_ball_add(words, &same, &same, b);
    else
        tia_ball_sub(words, &same, &same, b);
    exact_middle(&x, words, &r);
    exact_middle(&y, words, &same);
    CHECK(exact_compare(&x, &y) == 0 && same.radius.m == r.radius.m && same.radius.e == r.radius.e);
}

TEST(sums)
{
    EACH_PRECISION(words)
    for (unsigned i = 0; i < CASES; i++) {
        struct ball a, b;
        int spread = i % 5 == 0 ? 1500 : i % 2 ? 20 : 32 * words + 40;
        random_ball(words, &a, spread, i % 3 == 0);
        random_ball(words, &b, spread, i % 3 == 0);
        if (i % 7 == 0) /* all bits but a few cancel */
            b = a;
        if (i % 14 == 0)
            b.m[random_bits() % (unsigned)words] ^= UINT32_C(1) << random_bits() % 31;
        check_sum(words, &a, &b, i & 1 ? 1 : -1);
    }
}

/* Carries through all words, cancellation, and zero. */
TEST(directed_sums)
{
    EACH_PRECISION(words)
    {
        struct ball ones, last, one, zero, r;
        tia_ball_set(words, &one, 1, 32 * words);
        tia_ball_set(words, &last, 1, 0);
        tia_ball_set(words, &zero, 0, 0);
        tia_ball_sub(words, &ones, &one, &last);
        CHECK(ones.sign == 1 && !ones.radius.m && ones.m[0] == UINT32_MAX && ones.m[words - 1] == UINT32_MAX);
        tia_ball_add(words, &r, &ones, &last);
        CHECK(r.sign == 1 && !r.radius.m && r.m[words - 1] == UINT32_C(1) << 31 && r.m[0] == 0);
        CHECK_EQ(r.e + 32 * words - 1, 32 * words);
        tia_ball_add(words, &r, &ones, &ones);
        CHECK(!r.radius.m && r.e == ones.e + 1);
        tia_ball_sub(words, &r, &ones, &ones);
        CHECK(r.sign == 0 && !r.radius.m);
        tia_ball_sub(words, &r, &zero, &ones);
        CHECK(r.sign == -1 && !r.radius.m && r.m[0] == UINT32_MAX);
        tia_ball_add(words, &r, &zero, &zero);
        CHECK(r.sign == 0 && !r.radius.m);
        for (int down = 0; down < 64 * words + 70; down++) {
            last.e = -down - 32 * words;
            for (int side = -1; side < 2; side += 2) {
                check_sum(words, &ones, &last, side);
                check_sum(words, &last, &ones, side);
                check_sum(words, &one, &last, side);
            }
        }
    }
}

static void check_product(int words, const struct ball *a, const struct ball *b)
{
    struct ball r;
    struct exact_number x, y, z, least, other;

    tia_ball_mul(words, &r, a, b);
    for (int i = -1; i < 2; i++)
        for (int j = -1; j < 2; j++) {
            point_of(words, a, i, &x);
            point_of(words, b, j, &y);
            exact_product(&z, &x, &y);
            CHECK_MSG(contains(words, &r, &z), "%d words: a product is not in its ball", words);
        }
    exact_middle(&x, words, a);
    exact_middle(&y, words, b);
    exact_product(&z, &x, &y);
    exact_radius(&other, b);
    x.sign = x.sign ? 1 : 0;
    exact_radius(&least, a);
    exact_sum(&x, &x, &least, 1);
    exact_product(&least, &x, &other); /* (|a| + ra) rb + (|b| + rb) ra */
    exact_radius(&x, a);
    y.sign = y.sign ? 1 : 0;
    exact_sum(&y, &y, &other, 1);
    exact_product(&y, &y, &x);
    exact_sum(&least, &least, &y, 1);
    CHECK(is_normal(words, &r));
    CHECK_MSG(is_tight(&r, &least, 17, 2), "%d words: a product's radius is %x 2^%d", words, r.radius.m, r.radius.e);
    CHECK(least.sign || exact_bits(&z) > 32 * words || !r.radius.m);
}

TEST(products)
{
    EACH_PRECISION(words)
    {
        struct ball a, b, zero;
        for (unsigned i = 0; i < CASES; i++) {
            random_ball(words, &a, 300, i % 3 == 0);
            random_ball(words, &b, 300, i % 3 == 0);
            check_product(words, &a, &b);
            check_product(words, &a, &a);
        }
        tia_ball_set(words, &zero, 0, 0);
        check_product(words, &a, &zero);
        check_product(words, &zero, &a);
    }
}

/* ---- quotients and roots ---- */

/* True if x/y is in the ball: |r y - x| <= radius |y|. */
static bool contains_quotient(int words, const struct ball *r, const struct exact_number *x,
                              const struct exact_number *y)
{
    struct exact_number p, radius;

    exact_middle(&p, words, r);
    exact_product(&p, &p, y);
    exact_radius(&radius, r);
    exact_product(&radius, &radius, y);
    radius.sign = radius.sign ? 1 : 0;
    return exact_is_within(&p, x, &radius);
}

/* Checks a/b, where b is at least four times its radius. */
static void check_quotient(int words, const struct ball *a, const struct ball *b)
{
    struct ball r;
    struct exact_number x, y, least, q;

    tia_ball_div(words, &r, a, b);
    for (int i = -1; i < 2; i++)
        for (int j = -1; j < 2; j++) {
            point_of(words, a, i, &x);
            point_of(words, b, j, &y);
            CHECK_MSG(contains_quotient(words, &r, &x, &y), "%d words: a quotient is not in its ball", words);
        }
    CHECK(is_normal(words, &r));
    exact_middle(&q, words, &r); /* twice (ra + |q| rb) / 2^e, 2^e the top bit of b */
    q.sign = q.sign ? 1 : 0;
    exact_radius(&y, b);
    exact_product(&least, &q, &y);
    exact_radius(&x, a);
    exact_sum(&least, &least, &x, 1);
    least.e -= b->e + 32 * words - 2;
    CHECK_MSG(is_tight(&r, &least, 17, 70), "%d words: a quotient's radius is %x 2^%d, last bit 2^%d", words,
              r.radius.m, r.radius.e, r.e);
    CHECK(words == 2 || least.sign || is_tight(&r, &nothing, 0, 2));
}

TEST(quotients)
{
    EACH_PRECISION(words)
    for (unsigned i = 0; i < CASES; i++) {
        struct ball a, b, p;
        random_ball(words, &a, 300, i % 3 == 0);
        random_ball(words, &b, 300, i % 3 == 0);
        b.radius.e = b.radius.m && b.radius.e + 15 > b.e + 32 * words - 4 ? b.e + 32 * words - 19 : b.radius.e;
        if (!b.sign)
            continue;
        check_quotient(words, &a, &b);
        tia_ball_set(words, &a, (int64_t)(random_bits() >> 40) + 1, -9); /* exact quotients */
        tia_ball_set(words, &b, (int64_t)(random_bits() >> 34) + 1, 11);
        tia_ball_mul(words, &p, &a, &b);
        tia_ball_div(words, &p, &p, &b);
        tia_ball_sub(words, &a, &a, &p);
        /* Two words may be divided by a reciprocal, which is rounded. */
        CHECK((words == 2 && tia_ball_sign(words, &a) == BALL_OPEN) || (a.sign == 0 && !a.radius.m));
    }
}

TEST(quotients_by_what_may_be_zero)
{
    EACH_PRECISION(words)
    {
        struct ball one, b, r, s;
        tia_ball_set(words, &one, 1, 0);
        tia_ball_set(words, &b, 0, 0);
        tia_ball_div(words, &r, &one, &b);
        CHECK_EQ(tia_ball_sign(words, &r), BALL_OPEN);
        CHECK(r.radius.m && r.radius.e + 14 >= 1 << 13);
        b = one;
        b.radius = (struct ball_radius){UINT32_C(3) << 13, -15}; /* .75 */
        tia_ball_div(words, &r, &one, &b);
        CHECK(r.radius.m && (r.radius.e + 14 >= 1 << 13 || contains(words, &r, &(struct exact_number){1, 1, 2, {1}})));
        tia_ball_set(words, &b, 0, 0); /* from zero */
        tia_ball_div(words, &r, &b, &one);
        CHECK(r.sign == 0 && !r.radius.m);
        tia_ball_set(words, &b, 0, 0); /* all is unknown, and stays so */
        tia_ball_div(words, &r, &one, &b);
        tia_ball_add(words, &s, &r, &one);
        CHECK_EQ(tia_ball_sign(words, &s), BALL_OPEN);
        tia_ball_mul(words, &s, &r, &r);
        CHECK_EQ(tia_ball_sign(words, &s), BALL_OPEN);
        tia_ball_sqrt(words, &s, &r);
        CHECK_EQ(tia_ball_sign(words, &s), BALL_OPEN);
        tia_ball_div(words, &s, &one, &r);
        CHECK_EQ(tia_ball_sign(words, &s), BALL_OPEN);
        CHECK(is_normal(words, &s));
    }
}

/* True if the root of max(0, x) is in the ball: its ends' squares are on both sides of x. */
static bool contains_root(int words, const struct ball *r, const struct exact_number *x)
{
    struct exact_number end, radius, zero = {0, 0, 0, {0}};

    exact_radius(&radius, r);
    for (int side = -1; side < 2; side += 2) {
        exact_middle(&end, words, r);
        exact_sum(&end, &end, &radius, side);
        if (side > 0 && end.sign < 0)
            return false;
        bool below = end.sign < 0;
        exact_product(&end, &end, &end);
        int order = exact_compare(&end, x->sign > 0 ? x : &zero);
        if (side < 0 ? !below && order > 0 : order < 0)
            return false;
    }
    return true;
}

static void check_root(int words, const struct ball *a)
{
    struct ball r;
    struct exact_number x, least;
    int top = a->e + 32 * words - 1;

    tia_ball_sqrt(words, &r, a);
    for (int i = -1; i < 2; i++) {
        point_of(words, a, i, &x);
        CHECK_MSG(contains_root(words, &r, &x), "%d words: a root is not in its ball", words);
    }
    CHECK(is_normal(words, &r));
    if (tia_ball_sign(words, a) != BALL_ABOVE)
        return;
    exact_radius(&least, a); /* by the power of two below the root, which is at most the root */
    least.e -= top >= 0 ? top / 2 : -((1 - top) / 2);
    CHECK_MSG(is_tight(&r, &least, 17, words == 2 ? 4 : 2), "%d words: a root's radius is %x 2^%d, last bit 2^%d",
              words, r.radius.m, r.radius.e, r.e);
}

TEST(roots)
{
    EACH_PRECISION(words)
    {
        struct ball a, b;
        for (unsigned i = 0; i < CASES; i++) {
            random_ball(words, &a, 300, i % 3 == 0);
            a.sign = i % 16 ? 1 : a.sign;
            a.sign = a.m[words - 1] >> 31 ? a.sign : 0;
            check_root(words, &a);
            tia_ball_set(words, &b, (int64_t)(random_bits() >> (33 + random_bits() % 20)) + 1, (int)(i % 9) - 4);
            tia_ball_mul(words, &a, &b, &b); /* perfect squares */
            tia_ball_sqrt(words, &a, &a);
            tia_ball_sub(words, &a, &a, &b);
            CHECK_MSG(a.sign == 0 && !a.radius.m, "%d words: the root of a square is not exact", words);
        }
        tia_ball_set(words, &a, 0, 0);
        check_root(words, &a);
        tia_ball_sqrt(words, &a, &a);
        CHECK(a.sign == 0 && !a.radius.m);
        tia_ball_set(words, &a, -5, 0);
        tia_ball_sqrt(words, &a, &a);
        CHECK(a.sign == 0 && !a.radius.m);
        for (int e = -40; e < 40; e++) { /* zero within any radius, also below it */
            tia_ball_set(words, &a, e % 3, e);
            a.radius = (struct ball_radius){UINT32_C(1) << 14, e - 12};
            check_root(words, &a);
        }
    }
}

/* ---- signs, floors and conversions ---- */

TEST(signs)
{
    EACH_PRECISION(words)
    for (unsigned i = 0; i < CASES; i++) {
        struct ball a;
        struct exact_number middle, radius;
        random_ball(words, &a, 50, false);
        if (a.radius.m && i & 1) /* nearly the midpoint */
            a.radius = (struct ball_radius){(a.m[words - 1] >> 17) + (uint32_t)(random_bits() % 3) - 1,
                                            a.e + 32 * (words - 1) + 17};
        a.radius = a.radius.m >> 14 == 1 ? a.radius : (struct ball_radius){0, 0};
        int sign = tia_ball_sign(words, &a);
        exact_middle(&middle, words, &a);
        exact_radius(&radius, &a);
        middle.sign = middle.sign ? 1 : 0;
        if (!a.radius.m) {
            CHECK_EQ(sign, a.sign);
        } else if (exact_compare(&middle, &radius) <= 0) {
            CHECK_EQ(sign, BALL_OPEN);
        } else {
            CHECK(sign == a.sign || sign == BALL_OPEN);
            radius.m[0] += 2;
            CHECK(exact_compare(&middle, &radius) <= 0 || sign == a.sign);
        }
    }
}

TEST(floors)
{
    EACH_PRECISION(words)
    for (unsigned i = 0; i < CASES; i++) {
        struct ball a;
        struct exact_number floor, x, next;
        random_ball(words, &a, 29, true);
        if (i % 3 == 0)
            tia_ball_set(words, &a, (int64_t)(random_bits() % 200) - 100, 0);
        if (!a.sign || a.e + 32 * words > 30)
            continue;
        exact_middle(&x, words, &a);
        exact_of(&floor, tia_ball_floor(words, &a), 0);
        exact_of(&next, (int64_t)tia_ball_floor(words, &a) + 1, 0);
        CHECK(exact_compare(&floor, &x) <= 0 && exact_compare(&x, &next) < 0);
    }
}

TEST(conversions)
{
    EACH_PRECISION(words)
    for (unsigned i = 0; i < CASES; i++) {
        struct ball a, r;
        struct exact_number x, radius;
        int from = precisions[random_bits() % 4];
        random_ball(from, &a, 100, i & 1);
        tia_ball_convert(words, &r, from, &a);
        for (int side = -1; side < 2; side++) {
            point_of(from, &a, side, &x);
            CHECK(contains(words, &r, &x));
        }
        exact_middle(&x, from, &a);
        exact_radius(&radius, &a);
        CHECK(is_normal(words, &r));
        CHECK_MSG(is_tight(&r, &radius, 17, 2), "%d to %d words: radius %x 2^%d of %x 2^%d, last bit 2^%d", from, words,
                  r.radius.m, r.radius.e, a.radius.m, a.radius.e, r.e);
        CHECK(a.radius.m || exact_bits(&x) > 32 * words || !r.radius.m);
    }
}

TEST(integers)
{
    static const int64_t integers[] = {0, 1, -1, INT64_MAX, INT64_MIN, INT64_C(1) << 32, -(INT64_C(1) << 31), 12345};

    EACH_PRECISION(words)
    for (size_t i = 0; i < sizeof integers / sizeof *integers; i++) {
        struct ball a;
        struct exact_number x;
        tia_ball_set(words, &a, integers[i], -7);
        exact_of(&x, integers[i], -7);
        CHECK(contains(words, &a, &x) && !a.radius.m && is_normal(words, &a));
        CHECK_EQ(tia_ball_sign(words, &a), (integers[i] > 0) - (integers[i] < 0));
    }
}

int main(void)
{
    RUN(sums);
    RUN(directed_sums);
    RUN(products);
    RUN(quotients);
    RUN(quotients_by_what_may_be_zero);
    RUN(roots);
    RUN(signs);
    RUN(floors);
    RUN(conversions);
    RUN(integers);
    return check_status();
}
