/* stored.h - reads rows of a picture or film as tia has written them, without conversion, to compare their bits. */
#ifndef TOOLS_IMAGE_STORED_H
#define TOOLS_IMAGE_STORED_H

#include "stored_file.h"

/* Opens a file of the format that tia wrote. A .565 has the size `width` x `height`; other files know theirs. Returns
 * 0; or -1 if the file cannot be read or is not as tia writes it. Then, too, stored_close is to be called. */
int stored_open(struct stored *stored, const char *path, enum image_format format, unsigned width, unsigned height);
void stored_close(struct stored *stored);

/* Sets the depth that the picture was drawn with, see struct image_film: a .png or .ppm with 8 bits may be RGB565.
 * Returns 0; or -1 if the file has another depth. */
int stored_depth(struct stored *stored, unsigned depth);

/* Returns the number of rows in the file, of all frames. */
uint64_t stored_rows(const struct stored *stored);
/* Gives the frame and row of row number `index` of the file. */
void stored_place(const struct stored *stored, uint64_t index, uint32_t *frame, unsigned *y);

/* Returns the number of bytes of a row, as a row_tap receives it (common/row_tap.h). */
size_t stored_row_bytes(const struct stored *stored);

/* Reads a row into bytes[stored_row_bytes]. *exact becomes false if a pixel is no colour of RGB565 though the picture
 * should have only these. Returns 0, or -1 on failure. */
int stored_row(struct stored *stored, uint32_t frame, unsigned y, unsigned char *bytes, bool *exact);

#endif
