/* gaze.h - the options that say where the eye looks and how sharply it sees, include/tia/gaze.h. */
#ifndef TOOLS_TIA_GAZE_H
#define TOOLS_TIA_GAZE_H

#include "options.h"

/* EXIT_FINE, or EXIT_USAGE after an error message. */
int gaze_check(struct options *options);

/* The viewer's gaze: none where none is given. */
struct tia_gaze gaze_of(const struct options *options);

#endif
