/* save.h - saves a display's picture to a file. */
#ifndef TOOLS_TIA_SAVE_H
#define TOOLS_TIA_SAVE_H

#include "common/image/image.h"
#include "device.h"
#include "letterbox.h"

/* Writes the picture of a letterbox with `keeps` set. Returns a negative status on failure, with the reason in `why`,
 * [PORT_WHY]. */
int save_picture(const struct letterbox *letterbox, const char *path, enum image_format format, char *why);

/* Writes the picture to the first of tia-0001.png, tia-0002.png, ... after *number that does not exist; .ppm without
 * libpng. `text` receives "saved NAME" or, with a negative status, the reason; *number receives the number in the name,
 * and is 0 at first. */
int save_numbered(const struct letterbox *letterbox, unsigned *number, char text[PORT_WHY]);

#endif
