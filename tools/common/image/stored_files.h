/* stored_files.h - the interface between stored.c and the formats of pictures. */
#ifndef TOOLS_IMAGE_STORED_FILES_H
#define TOOLS_IMAGE_STORED_FILES_H

#include "stored.h"

/* Writes the reason, after the file's name. Returns -1. */
__attribute__((format(printf, 2, 3))) int stored_failed(struct stored *stored, const char *format, ...);

/* Reads bytes of the open file. Returns 0, or -1 on failure. */
int stored_read_at(struct stored *stored, void *bytes, size_t count, uint64_t offset);

/* Finds the size, the bits and the rows of a picture of `length` bytes. */
int stored_open_picture(struct stored *stored, enum image_format format, uint64_t length);

/* Decodes a .png into stored->pixels. */
int stored_open_png(struct stored *stored, uint64_t length);

#endif
