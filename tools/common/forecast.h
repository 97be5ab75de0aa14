/* forecast.h - the order in which the parts of a picture are drawn, so that the time left can be estimated early.
 *
 * Rows cost differently: those of the sky a tenth of the others, or a hundredth. From top to bottom, a tenth of the
 * rows does not predict the rest: the scenes of the gallery then take up to a hundred times as long as the rows so far
 * let one expect. Spread over the picture, a tenth of the rows is a fair sample of it. */
#ifndef TOOLS_COMMON_FORECAST_H
#define TOOLS_COMMON_FORECAST_H

#include <stdint.h>

/* Returns the part, 0..count-1, that is drawn as number `index` of `count`. The first parts of the order, however many,
 * are spread evenly over all. `count` is below 65536. */
unsigned forecast_part(unsigned index, unsigned count);

/* A picture that is drawn in bands, one after the other, is surveyed first: one part of FORECAST_STEP of each band is
 * drawn, and kept. */
enum { FORECAST_STEP = 16 };

/* Returns the number of parts of a band of `parts` that are drawn beforehand. */
unsigned forecast_probes(unsigned parts);

/* Returns the part that is drawn beforehand as number `probe`. */
unsigned forecast_probe(unsigned probe);

/* Returns the work of a pixel of a band whose probes, of that many pixels, took `ns` nanoseconds: 1 or more, in units
 * of 2^-8 ns. */
uint64_t forecast_weight(uint64_t ns, uint64_t pixels);

#endif
