/* dither.h - rounding offsets for quantising, plain or dithered. */
#ifndef TIA_RENDER_DITHER_H
#define TIA_RENDER_DITHER_H

#include "num/num.h"

/* Writes the rounding offsets of row y, indexed by x & 7: one half everywhere or, with `dither`, a row of the 8x8 Bayer
 * matrix. */
void dither_thresholds(bool dither, int y, num_u threshold[8]);

#endif
