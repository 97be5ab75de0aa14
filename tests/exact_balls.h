/* exact_balls.h - for tests of src/exact: random balls, and the numbers that a ball contains. */
#ifndef TESTS_EXACT_BALLS_H
#define TESTS_EXACT_BALLS_H

#include "check.h"
#include "exact_numbers.h"
#include "random.h"

static const int precisions[] = {2, 4, 8, 16};
#define EACH_PRECISION(words) for (int at_ = 0, words; at_ < 4 && (words = precisions[at_], true); at_++)
#define CASES check_count(4000)

/* Returns a word of a mantissa: any word, mostly 0, or mostly all ones. */
static inline uint32_t random_word(int kind)
{
    return kind == 0   ? random_u32()
           : kind == 1 ? (random_bits() & 7 ? 0 : random_u32())
                       : ~(random_bits() & 7 ? 0 : 1u);
}

/* Sets a to a random ball whose midpoint is any mantissa below 1 times 2^e, |e| <= spread; one of seven is a small
 * integer times 2^e. With `exact` its radius is 0. */
static inline void random_ball(int words, struct ball *a, int spread, bool exact)
{
    int kind = (int)(random_bits() % 3), e = (int)(random_bits() % (2 * (unsigned)spread + 1)) - spread;

    if (random_bits() % 7 == 0) {
        tia_ball_set(words, a, (int64_t)(random_bits() % 2000) - 1000, e);
    } else {
        for (int i = 0; i < words; i++)
            a->m[i] = random_word(kind);
        a->m[words - 1] |= UINT32_C(1) << 31;
        a->e = e - 32 * words;
        a->sign = random_bits() & 1 ? 1 : -1;
    }
    a->radius = (struct ball_radius){0, 0};
    if (!exact && random_bits() % 4) {
        a->radius.m = (random_u32() | UINT32_C(1) << 31) >> 17;
        a->radius.e = e - 15 - (int)(random_bits() % (unsigned)(32 * words + 40));
    }
}

/* True if a ball has the form that ball.h describes. */
static inline bool is_normal(int words, const struct ball *a)
{
    return a->sign >= -1 && a->sign <= 1 && (!a->sign || a->m[words - 1] >> 31) &&
           (!a->radius.m || a->radius.m >> 14 == 1);
}

static inline bool contains(int words, const struct ball *a, const struct exact_number *x)
{
    struct exact_number middle, radius;

    exact_middle(&middle, words, a);
    exact_radius(&radius, a);
    return exact_is_within(&middle, x, &radius);
}

/* Sets x to the middle of a ball, or with side -1 or 1 to an end. */
static inline void point_of(int words, const struct ball *a, int side, struct exact_number *x)
{
    struct exact_number radius;

    exact_middle(x, words, a);
    exact_radius(&radius, a);
    if (side)
        exact_sum(x, x, &radius, side);
}

/* True if the radius of `a` is at most `times`/16 of `least` plus `ulps` last bits of its midpoint. */
static inline bool is_tight(const struct ball *a, const struct exact_number *least, int times, int ulps)
{
    struct exact_number radius, most, share, last;

    exact_radius(&radius, a);
    exact_of(&share, times, -4);
    exact_product(&most, least, &share);
    exact_of(&last, ulps, a->e);
    if (a->sign)
        exact_sum(&most, &most, &last, 1);
    return exact_compare(&radius, &most) <= 0;
}

static const struct exact_number nothing;

#endif
