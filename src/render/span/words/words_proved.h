/* words_proved.h - the error bounds of words.h by name, each with its derivation. The row for a point that is off is in
 * span_proved.h, which has BOUND_SCALES, too. */
#ifndef TIA_RENDER_SPAN_WORDS_WORDS_PROVED_H
#define TIA_RENDER_SPAN_WORDS_WORDS_PROVED_H

#ifdef BOUND_SCALES
#include BOUND_SCALES
#define WORDS_BOUND(name) ((uint32_t)BOUND_SCALED(#name, (name)))
#else
#define WORDS_BOUND(name) ((uint32_t)(name))
#endif

/* The error of a cosine of 2^28 by that of y = 1/sqrt(q), and by the last bits of two products and of 1/r. With e = 1 -
 * q y^2, |e| at most 2^-12, a step y (1 + e/2) is below 1/sqrt(q) by up to 3/8 e^2 and e^3/8; q is below 2^32, so that
 * cutting off y^2 and q y^2 makes e too large by up to 2 2^-26; y, from 2^29 on, is cut off, as is its half. The
 * products are cut off, 1 each; 1/r is off by 1.02 2^-31. Proved: words.g (cosine), 9.2 of 10. Unseen: small. */
#define WORDS_COSINE 10

/* The error of |w|^2 as a word, without those of t and |P|^2: the constant is cut off, 1, and so is |P|^2 when it is
 * shifted, 1; Q.v is cut off twice, 1 and its accumulator's .51, of which a product with t, below 2^31, has half, and
 * the product is cut off, 1; that counts twice. Proved: words.g (square), 5.6 of 6. Unseen: small. */
#define WORDS_SQUARE 6

/* The error of |P|^2 as a word: t^2 is cut off, 1, of which v.v as a word below 2^32 has at most 1; v.v, below 2^32
 * with a factor of 2, is cut off, 2, and off by .51 before; and the product is cut off, 1. Proved: words.g (reach), 5.1
 * of 6. Unseen: small. */
#define WORDS_REACH 6

/* The error of r N.w's word, without those of t and the line: the constant is cut off, 1; G.v is cut off twice, 1 and
 * the accumulator's step, of which a product with t has half, and the product is cut off, 1. Proved: words.g
 * (facing), 2.6 of 3. Unseen: small. */
#define WORDS_FACING 3

#endif
