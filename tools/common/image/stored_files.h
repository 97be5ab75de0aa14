/* stored_files.h - the formats of pictures, as tia writes them. */
#ifndef TOOLS_IMAGE_STORED_FILES_H
#define TOOLS_IMAGE_STORED_FILES_H

#include "stored_file.h"

/* Finds the size, the bits and the rows of a picture of `length` bytes. Returns 0, or -1 on failure. */
int stored_open_picture(struct stored *stored, enum image_format format, uint64_t length);

#endif
