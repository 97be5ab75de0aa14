/* long_number.h - integers that are long enough for exact paths.
 *
 * An image after k reflections has k factors n.n in its denominator, n being the planes' normals. Sizes of the numbers:
 *
 *     corners and points of the scene                below 2^31 in size
 *     a normal's component                           below 2^62; n.n below 2^126, n.v below 2^95
 *     images, as points                              |p'| <= 2 |v| + |p| for any corner v of the plane: after 8
 *                                                    reflections below 2^31 sqrt(3) 17 < 2^36
 *     the denominators of both images of a segment   together at most one factor for each reflection: below 2^1024
 *     a side, n.p - d w                              w times |n| < 2^64 times a distance < 2^37: w 2^101
 *     a product of two sides, at either end          2^(1024 + 202)
 *     a meeting point                                2^(1024 + 101) times 2^36
 *     an edge's cross product                        2^34 times the size of a meeting point
 *     the square of a distance on a disc             2^(2 (1024 + 101 + 38) + 2) < 2^2330
 *
 * So 40 words are enough. If all planes are perpendicular to an axis, their normals have length 1, and all numbers are
 * below 2^128.
 */
#ifndef TIA_RADIO_LONG_NUMBER_H
#define TIA_RADIO_LONG_NUMBER_H

#include "math/wide.h"

#define NUMBER_WORDS 40

struct number {
    int sign;       /* -1, 0 or 1 */
    unsigned count; /* number of words, without leading zeros */
    uint64_t word[NUMBER_WORDS];
};

void tia_number_set(struct number *out, int64_t a);
void tia_number_copy(struct number *out, const struct number *a);

/* Sets out to a b; `out` must not be one of the factors. */
void tia_number_multiply(struct number *out, const struct number *a, const struct number *b);
/* Sets out to a b; `out` must not be a. */
void tia_number_times(struct number *out, const struct number *a, int64_t b);
/* Sets out to a b; `out` must not be a. */
void tia_number_times_wide(struct number *out, const struct number *a, wide b);

/* Adds s a to `out`; s is 1 or -1. */
void tia_number_add(struct number *out, const struct number *a, int s);

/* Returns the sign of |a| - |b|: -1, 0 or 1. */
int tia_number_compare_sizes(const struct number *a, const struct number *b);

/* Returns the length of |a| in bits. */
int tia_number_bits(const struct number *a);
/* Returns the lower 64 bits of |a| 2^-shift, rounded down. */
uint64_t tia_number_part(const struct number *a, int shift);

/* Returns a/b rounded to nearest, ties up, clamped to +-2^40; b > 0. */
int64_t tia_number_quotient(const struct number *a, const struct number *b, struct number room[2]);

#endif
