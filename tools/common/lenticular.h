/* lenticular.h - the geometry of a panel's lenses: from an option, or from the calibration file of a Looking Glass. */
#ifndef TOOLS_LENTICULAR_H
#define TOOLS_LENTICULAR_H

#include <tia/lightfield.h>

struct lenticular {
    struct tia_lenticular lens;
    uint16_t width, height; /* size of the panel; 0: unknown */
    char why[480];          /* reason of a failure */
};

/* Parses --lenticular "pitch=50.2,slope=-7.1,center=0.3,subpixels=bgr,flip,invert": fields in any order, of which only
 * pitch is needed. `pitch` is the number of lenses in the picture's width; `slope` the number of rows per column along
 * a lens. A lens without a slope is upright. Returns TIA_OK; or TIA_ERR_RANGE or TIA_ERR_MEMORY, with a reason that
 * names the option. */
int lenticular_parse(struct lenticular *panel, const char *text);

/* Sets a lens from numbers; `rise` is pitch/slope. Returns false if a number is not finite or is beyond TIA_PITCH_MAX,
 * or if the pitch is 0. */
bool lenticular_set(struct tia_lenticular *lens, double pitch, double rise, double centre);

/* Reads visual.json. Returns TIA_OK; or TIA_ERR_RANGE, or TIA_ERR_DEVICE if the file cannot be read, with the
 * reason. */
int calibration_read(struct lenticular *panel, const char *path);

#endif
