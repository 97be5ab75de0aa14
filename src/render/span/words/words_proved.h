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
 * cutting off y^2 and q y^2 makes e too large by up to 2 2^-26; the step, of y from 2^29 on, is off by less than 1. The
 * products are cut off, 1 each; 1/r is off by 1.02 2^-31. Proved: words.g (cosine), 8.7 of 9. Unseen: small. */
#define WORDS_COSINE 9

/* The error of |w|^2 as a word, without those of t and |P|^2: the constant is cut off, 1; a form times t, of which the
 * words of the middle and the step are cut off and that of the pixel's number, half a word each by the other factor,
 * below 2^31; two products, 1 each; the accumulator of Q.v, .51 twice, by half a word; and |P|^2 times a power of two,
 * 1. Proved: words.g (square), 6.01 of 7. Unseen: small. */
#define WORDS_SQUARE 7

/* The error of |P|^2 as a word: t^2 is cut off, 1, of which v.v as a word below 2^31 has half; v.v is cut off, 1, and
 * off by .51 before; and the product is cut off, 1. Proved: words.g (reach), 3.01 of 4. Unseen: small. */
#define WORDS_REACH 4

/* The error of r N.w's word, without those of t and the line: the constant is cut off, 1; and a form times t, as
 * WORDS_SQUARE has it, 3.51. Proved: words.g (facing), 4.51 of 5. Unseen: small. */
#define WORDS_FACING 5

#endif
