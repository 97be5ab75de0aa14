/* lenticular.h - how the lenses of a panel lie: from an option, or from the calibration that a Looking Glass holds. */
#ifndef TOOLS_TIA_LENTICULAR_H
#define TOOLS_TIA_LENTICULAR_H

#include "lightfield_options.h"

/* "pitch=50.2,slope=-7.1,center=0.3,subpixels=bgr,flip,invert": fields in any order, of which only pitch is needed.
 * Pitch is lenses to the picture's width; slope is rows to a column along a lens, none: upright. EXIT_FINE, or
 * EXIT_USAGE after an error message. */
int lenticular_parse(struct tia_lenticular *lens, const char *text);

/* Sets a lens from numbers; false: one of them is no number or beyond TIA_PITCH_MAX. `rise` is pitch/slope. */
bool lenticular_set(struct tia_lenticular *lens, double pitch, double rise, double centre);

/* Reads visual.json. EXIT_FINE, or EXIT_USAGE or EXIT_RUNNING after an error message. */
int calibration_read(struct light_options *light, const char *path);

#endif
