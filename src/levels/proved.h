/* proved.h - how many units (half an ulp) the sums of kernel.h and exact.c may be off by, as tests/proofs/level_*.g
 * prove: they read the numbers here. */
#ifndef TIA_LEVELS_PROVED_H
#define TIA_LEVELS_PROVED_H

#define LEVEL_LINEAR 4    /* c0 + c1 x, of |c0| + |c1| X */
#define LEVEL_QUADRATIC 8 /* d0 + x (d1 + x d2), of |d0| + |d1| X + |d2| X^2 */
#define LEVEL_SUM 10      /* b + sqrt(D), of itself, but for what its parts are off by */
#define LEVEL_ROOT 12     /* 1/sqrt(x), of itself */
#define LEVEL_INVERSE 6   /* 1/x, of itself, from an estimate */
#define LEVEL_TERM 8      /* each term of a s^2 + h s + v.v, but for what s is off by */
#define LEVEL_FACING 6    /* K s of K s + G.v */
#define LEVEL_TURN 7      /* and G.v */
#define LEVEL_LAMBERT 24  /* r N.w/(r |w|), but for what both are off by */
#define LEVEL_COLOUR 6    /* for a light: lambert times tint and colour, and the sum; as much for a caster */
#define LEVEL_LINE 15     /* two lines between three samples */
#define LEVEL_DELTA 10    /* (A'.w)^2 and |w|^2 k (1 + B), each */

#endif
