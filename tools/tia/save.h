/* save.h - saves a display's picture to a file. */
#ifndef TOOLS_TIA_SAVE_H
#define TOOLS_TIA_SAVE_H

#include "common/image/image.h"
#include "device.h"
#include "letterbox.h"

/* Writes the picture of a letterbox with `keeps` set. Returns a negative status on failure, with the reason in `why`,
 * [PORT_WHY]. */
int save_picture(const struct letterbox *letterbox, const char *path, enum image_format format, char *why);

/* Writes the picture to a new file, tia-NNNN.png (.ppm without libpng), where NNNN is the first unused number above
 * *number. `text` receives "saved NAME" or, with a negative status, the reason; *number, at first 0, receives the
 * number in the name. */
int save_numbered(const struct letterbox *letterbox, unsigned *number, char text[PORT_WHY]);

#endif
