/* exact_numbers.h - integers times powers of two, with as many bits as their sums and products need, with which tests
 * compare balls. Nothing is rounded, and no code is shared with src/exact. */
#ifndef TESTS_EXACT_NUMBERS_H
#define TESTS_EXACT_NUMBERS_H

#include "exact/ball.h"

#define EXACT_WORDS 420

/* A number sign m 2^e; m has n words, the lowest first, and the top one is not 0. */
struct exact_number {
    int sign, n, e;
    uint32_t m[EXACT_WORDS];
};

static inline void exact_trim(struct exact_number *a)
{
    while (a->n > 0 && !a->m[a->n - 1])
        a->n--;
    a->sign = a->n ? a->sign : 0;
}

/* Sets r to sign m 2^e, m of n words. */
static inline void exact_set(struct exact_number *r, int sign, const uint32_t *m, int n, int e)
{
    r->sign = sign;
    r->n = sign ? n : 0;
    r->e = e;
    for (int i = 0; i < r->n; i++)
        r->m[i] = m[i];
    exact_trim(r);
}

static inline void exact_of(struct exact_number *r, int64_t x, int e)
{
    uint64_t size = x < 0 ? 0 - (uint64_t)x : (uint64_t)x;
    uint32_t m[2] = {(uint32_t)size, (uint32_t)(size >> 32)};

    exact_set(r, x < 0 ? -1 : 1, m, 2, e);
}

static inline void exact_middle(struct exact_number *r, int words, const struct ball *a)
{
    exact_set(r, a->sign, a->m, words, a->e);
}

static inline void exact_radius(struct exact_number *r, const struct ball *a)
{
    exact_of(r, a->radius.m, a->radius.e);
}

/* Lowers the exponent of a to e. */
static inline void exact_lower(struct exact_number *a, int e)
{
    int up = a->e - e, words = up / 32, bits = up % 32;

    a->e = e;
    if (!a->n)
        return;
    CHECK_MSG(up >= 0 && a->n + words < EXACT_WORDS, "a number does not fit");
    if (up < 0 || a->n + words >= EXACT_WORDS)
        return;
    a->m[a->n++] = 0;
    for (int i = a->n - 1; i >= 0; i--)
        a->m[i + words] = a->m[i] << bits | (bits && i ? a->m[i - 1] >> (32 - bits) : 0);
    for (int i = 0; i < words; i++)
        a->m[i] = 0;
    a->n += words;
    exact_trim(a);
}

/* Compares the sizes of numbers that have the same exponent. Returns -1, 0 or 1. */
static inline int exact_compare_sizes(const struct exact_number *a, const struct exact_number *b)
{
    if (a->n != b->n)
        return a->n < b->n ? -1 : 1;
    for (int i = a->n - 1; i >= 0; i--)
        if (a->m[i] != b->m[i])
            return a->m[i] < b->m[i] ? -1 : 1;
    return 0;
}

/* Sets r to a + side b, side being 1 or -1. */
static inline void exact_sum(struct exact_number *r, const struct exact_number *a, const struct exact_number *b,
                             int side)
{
    struct exact_number x = *a, y = *b;
    int64_t carry = 0;

    y.sign *= side;
    exact_lower(&x, a->e < b->e ? a->e : b->e);
    exact_lower(&y, x.e);
    bool swaps = exact_compare_sizes(&x, &y) < 0;
    const struct exact_number *large = swaps ? &y : &x, *small = swaps ? &x : &y;
    bool adds = large->sign == small->sign;
    r->e = large->e;
    r->sign = large->sign;
    r->n = large->n + 1;
    for (int i = 0; i < r->n; i++) {
        int64_t other = i < small->n ? small->m[i] : 0;
        carry += (i < large->n ? (int64_t)large->m[i] : 0) + (adds ? other : -other);
        r->m[i] = (uint32_t)carry;
        carry >>= 32;
    }
    exact_trim(r);
}

static inline void exact_product(struct exact_number *r, const struct exact_number *a, const struct exact_number *b)
{
    struct exact_number p = {a->sign * b->sign, a->n + b->n, a->e + b->e, {0}};

    CHECK_MSG(p.n <= EXACT_WORDS, "a product does not fit");
    for (int i = 0; p.n <= EXACT_WORDS && i < a->n; i++) {
        uint64_t carry = 0;
        for (int j = 0; j < b->n; j++) {
            carry += (uint64_t)a->m[i] * b->m[j] + p.m[i + j];
            p.m[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
        p.m[i + b->n] = (uint32_t)carry;
    }
    exact_trim(&p);
    *r = p;
}

/* Returns -1, 0 or 1 where a is less than, equal to or more than b. */
static inline int exact_compare(const struct exact_number *a, const struct exact_number *b)
{
    struct exact_number d;

    exact_sum(&d, a, b, -1);
    return d.sign;
}

/* True if |a - b| <= c. */
static inline bool exact_is_within(const struct exact_number *a, const struct exact_number *b,
                                   const struct exact_number *c)
{
    struct exact_number d;

    exact_sum(&d, a, b, -1);
    d.sign = d.sign ? 1 : 0;
    return exact_compare(&d, c) <= 0;
}

/* Returns the number of bits from the lowest set bit to the highest. */
static inline int exact_bits(const struct exact_number *a)
{
    int first = 0, last = 32 * a->n;

    if (!a->n)
        return 0;
    while (!(a->m[first / 32] >> first % 32 & 1))
        first++;
    while (!(a->m[(last - 1) / 32] >> (last - 1) % 32 & 1))
        last--;
    return last - first;
}

#endif
