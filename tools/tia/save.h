/* save.h - saves a display's picture to a file. */
#ifndef TOOLS_TIA_SAVE_H
#define TOOLS_TIA_SAVE_H

#include "common/image/image.h"
#include "device.h"
#include "letterbox.h"

/* Writes the picture of a letterbox that keeps its picture. Returns a negative status, and the reason in `why`,
 * [PORT_WHY], on failure. */
int save_picture(const struct letterbox *letterbox, const char *path, enum image_format format, char *why);

/* Writes the picture to the first of tia-0001.png, tia-0002.png, ... that does not exist; .ppm without libpng. `text`
 * has the name, or the reason with a negative status. *number is the last one that existed, 0 at first. */
int save_numbered(const struct letterbox *letterbox, unsigned *number, char text[PORT_WHY]);

#endif
