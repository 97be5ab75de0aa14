/* stored_png.h - decodes a .png of RGB with 8 or 16 bits per channel, without any conversion. */
#ifndef TOOLS_IMAGE_STORED_PNG_H
#define TOOLS_IMAGE_STORED_PNG_H

#include "stored_file.h"

/* Decodes a .png into stored->pixels. Returns 0, or -1 on failure. */
int stored_open_png(struct stored *stored, uint64_t length);

#endif
