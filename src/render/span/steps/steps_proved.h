/* steps_proved.h - the error bounds of steps.h by name, each with its derivation.
 *
 * "Word": the upper 32 bits of an accumulator; its last bit is the unit. b is below 2^31, W below 2^30.1, g below 2^30,
 * and so A = g - W b below 2^30.7 and W S below 2^29.1. steps_high may be too small by up to 3. K is off
 * by .51 of its last bit, and has K of them. */
#ifndef TIA_RENDER_SPAN_STEPS_STEPS_PROVED_H
#define TIA_RENDER_SPAN_STEPS_STEPS_PROVED_H

#ifdef BOUND_SCALES
#include BOUND_SCALES
#define STEPS_BOUND(name) ((int32_t)BOUND_SCALED(#name, (name)))
#else
#define STEPS_BOUND(name) (name)
#endif

/* The error of W. Mantissas of 32 bits are cut off, by up to 2^-31 of themselves each; reciprocals are off by 1.02 of
 * these. r N.w and f are at most twice the largest u of the table, which is below 2^30.1 units; u is cut off to 2^-32,
 * at most 2^-29 of the largest u. A has the error times b/2^32, W S times S/2^32, both at most 1/2. Proved: steps.g
 * (word), 17.1 of 20. */
#define STEPS_WORD 20

/* The error of A in steps_walk, without those of W and K. At the first pixel: .51 of g and .27 of b, cut off, .8. At a
 * run's first pixel after i others g is off by another .5 i and b by .5 i, which W b has .27 of; and a product of
 * steps_high, 3. From there on A's step, which is rounded once, is off by .5 and by .27 of b's .5. So after 64 pixels
 * in all, in one run or in many, 64 times .64, 41. Proved: steps.g (coarse), 45 of 52. Unseen: small. */
#define STEPS_COARSE 52

/* The error of A and W S by K, .51 of its last bit, of which K has 2^31/STEPS_TURNED at least: G.z K is below 2^30, and
 * W L.z K/2^32 below 2^29.1, so that both are off by .51 (2^30 + 2^29.1)/K, below 2^30/K. .8 of 1. Unseen: small. */
#define STEPS_TURNED 1

/* The error of D's upper word without K. c is cut to 32 bits: .5 v.v, v.v below 2^31, .25. b's accumulator is off by
 * half of its last bit times the pixels to the middle, 2^-17 of a word: 2^-16 of D's upper word. D is computed by five
 * products of halves, each off by 3 of D's last bits, and its steps by the same, times 1024^2/2 pixels: 2^-8. The upper
 * word cuts off 1. 1.3 of 2. */
#define STEPS_DEPTH 2

/* The same by K, as STEPS_TURNED has it: b^2 by 2 b L.z times .51/K, 2^63 .51, and c v.v, which is at most b^2, by 2 K
 * of K^2, as much; 2^31.03/K in all. 2.1 of 3. Unseen: small. */
#define STEPS_DEPTH_TURNED 3

/* The error of A in a decision of 64 bits, without those of W and K: A's lower word is cut off, 1; .51 of g, .27 of b;
 * the product's lower half, 1. 2.8 of 4. Unseen: small. */
#define STEPS_FINE 4

/* How much too small D's upper word is in steps_walk after 64 pixels, where this bound is added at first: a step is cut
 * off, 1 each; steps have a fraction of 8 bits, off by 2^-9, of which there are 64^2/2 and 64; 68.2 of 70. Unseen:
 * small. */
#define STEPS_WALKED 70

/* How much too large it is without that, by the steps' fractions alone; 4.2 of 5. Unseen: small. */
#define STEPS_WALKED_UP 5

/* The error of the upper words of A^2 - W^2 D, without those of A, W S and D: three products, each cut off by 1, of
 * which W^2 counts D/2^32, a quarter: 1 + 1 + .25; and two for the cuts in margin_of. 4.3 of 5. Unseen: small. */
#define STEPS_MARGIN 5

/* The same where products are made of halves, 3 (1 + 1 + .25) and two. 8.8 of 10. Unseen: small. */
#define STEPS_HALVES_MARGIN 10

/* The error of l and omega S, as words, where it is decided whether u grows, without K's and D's, which `turned` and
 * `depth_doubt` count once each. Steps are those of 2^turn_shift pixels, at most a quarter of the image's width. A
 * polynomial of degree n that is at most M on the image's width changes by at most 2 n^2 M there (Markov): so the step
 * of g, below 2^30, is below 2^29, that of b below 2^30, and half of that of D, below 2^30, too; and an error e of g, b
 * and D on the image is an error of at most e/2, e/2 and e of these. Cut off by 1 each are D, g, b and their steps. l
 * has 2^29 1 + 2^30 (1 + 1 + 1) by that, divided by 2^32, .88, and is cut off, 1; omega has 2^30 (1 + 1) + 2^29 1 +
 * 2^31 1, 1.2, and is cut off, 1, of which omega S has half. Of D's doubt, which is counted twice in D, l has 2^29 2 +
 * 2^30, a half; of the doubts of g and b by K less than one. Proved: steps.g (way), 2.94 of 4. Unseen: small. */
#define STEPS_WAY 4

#endif
