/* ball.h - balls: a midpoint of 64 to 512 bits with a radius, as in Arb.
 *
 * A ball stands for a real number that is within its radius of its midpoint. The result of an operation contains all
 * results of numbers in the operands. A radius of 0 means that the number is exactly the midpoint: sums and products of
 * scene numbers stay exact as long as their bits fit.
 *
 * `words` is the precision of operands and result in words of 32 bits: 2, 4, 8 or 16, at most TIA_BALL_WORDS. The
 * result may be one of the operands. */
#ifndef TIA_EXACT_BALL_H
#define TIA_EXACT_BALL_H

#include <stdbool.h>
#include <stdint.h>

#ifndef TIA_BALL_WORDS
#define TIA_BALL_WORDS 16 /* words of the last precision */
#endif

/* An upper bound m 2^e. m is 0, or has exactly 15 bits. */
struct ball_radius {
    uint32_t m;
    int e;
};

/* A midpoint sign m 2^e, and a radius. m has `words` words, the lowest first, and its top bit is set; sign is -1, 0 or
 * 1. */
struct ball {
    uint32_t m[TIA_BALL_WORDS];
    int e, sign;
    struct ball_radius radius;
};

/* The common sign of all numbers in a ball; BALL_OPEN where they differ, or may differ. */
enum { BALL_BELOW = -1, BALL_ZERO = 0, BALL_ABOVE = 1, BALL_OPEN = 2 };

/* Sets r to x 2^e. */
void tia_ball_set(int words, struct ball *r, int64_t x, int e);

/* Sets r to `from`, which has from_words words. r may be `from` unless words > from_words. */
void tia_ball_convert(int words, struct ball *r, int from_words, const struct ball *from);

/* Sets r to a + b. */
void tia_ball_add(int words, struct ball *r, const struct ball *a, const struct ball *b);
/* Sets r to a - b. */
void tia_ball_sub(int words, struct ball *r, const struct ball *a, const struct ball *b);
/* Sets r to a b. */
void tia_ball_mul(int words, struct ball *r, const struct ball *a, const struct ball *b);

/* Sets r to a/b; to all numbers up to 2^2^13 in size where b may be 0, or |b| is below some four times its radius. */
void tia_ball_div(int words, struct ball *r, const struct ball *a, const struct ball *b);

/* Sets r to the square root of max(0, a). */
void tia_ball_sqrt(int words, struct ball *r, const struct ball *a);

/* Returns the sign, one of the four above. */
int tia_ball_sign(int words, const struct ball *a);

/* Returns the midpoint, rounded down. Its size must be below 2^30. */
int32_t tia_ball_floor(int words, const struct ball *a);

/* Sets r to K = height cot(fov/2), fov in degrees, Q16.16; exact for 90 degrees. */
void tia_ball_depth(int words, struct ball *r, uint32_t height, int32_t fov);

#endif
