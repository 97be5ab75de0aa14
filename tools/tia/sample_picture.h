/* sample_picture.h - draws samples into a picture of .png, .ppm or .pfm, with more bits than RGB565; or into a part of
 * one; or continues the file of an interrupted run, see common/image/sums.h. */
#ifndef TOOLS_TIA_SAMPLE_PICTURE_H
#define TOOLS_TIA_SAMPLE_PICTURE_H

#include "options.h"

/* Draws options->output; returns an exit status. */
int estimate(const struct options *options);

#endif
