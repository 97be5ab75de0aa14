/* estimate.h - draws samples into a picture that has more than RGB565, .png, .ppm or .pfm; or into a part of them; or
 * continues the file of an interrupted run, see common/image/sums.h. */
#ifndef TOOLS_TIA_ESTIMATE_H
#define TOOLS_TIA_ESTIMATE_H

#include "options.h"

/* Returns an exit status. */
int estimate(const struct options *options);

#endif
