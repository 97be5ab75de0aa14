/* gaze_options.h - the options for the gaze and for the acuity of the eye, see tia/gaze.h. */
#ifndef TOOLS_TIA_GAZE_OPTIONS_H
#define TOOLS_TIA_GAZE_OPTIONS_H

#include "options.h"

/* Checks the options. EXIT_FINE, or EXIT_USAGE after an error message. */
int gaze_check(struct options *options);

/* Returns the viewer's gaze; its view_angle is 0 if none is given. */
struct tia_gaze gaze_of(const struct options *options);

#endif
