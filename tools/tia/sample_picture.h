/* sample_picture.h - draws a picture by samples into a .png, .ppm or .pfm with more bits than RGB565, or into a
 * .tiapart of summed samples, and continues interrupted runs: see common/image/sums.h. */
#ifndef TOOLS_TIA_SAMPLE_PICTURE_H
#define TOOLS_TIA_SAMPLE_PICTURE_H

#include "options.h"

/* Draws options->output by samples. Returns the exit status, after an error message if it is not 0. */
int estimate(const struct options *options);

#endif
