/* coherence_proved.h - logarithms in coherence_bounds.c that make up for sums of several errors, as
 * tests/proofs/coherence.g proves: it reads the numbers here. */
#ifndef TIA_RENDER_SPAN_COHERENCE_COHERENCE_PROVED_H
#define TIA_RENDER_SPAN_COHERENCE_COHERENCE_PROVED_H

#define COHERENCE_ROOT 36    /* S = b + sqrt(D): 2^(this - B - S), relative, for a root of B and a sum of S bits */
#define COHERENCE_INVERSE 28 /* 2^-this, relative: the reciprocal and c */
#define COHERENCE_DEPTH 1    /* t: that, S and its own rounding */
#define COHERENCE_REACH 1    /* |P|^2 */
#define COHERENCE_SQUARE 1   /* |Q - P|^2 */
#define COHERENCE_MOVES 2    /* |Q - P|^2 by |Q - P| |P| times t's relative error */
#define COHERENCE_TURN 2     /* two of |Q - P|^2 */
#define COHERENCE_FACING 1   /* r N.(Q - P) */
#define COHERENCE_RELATIVE 1 /* |Q - P|^2, relative */
#define COHERENCE_KERNELS 26 /* 2^-this: the products of a cosine, see tests/proofs/simd_integer.g */
#define COHERENCE_LAMBERT 3  /* two cosines */
#define COHERENCE_TOWARD 1   /* A.w */
#define COHERENCE_POWER 3    /* |A'|^2 - R^2 */
#define COHERENCE_LENGTH 2   /* A'.w/|w| */

#endif
