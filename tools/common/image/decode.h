/* decode.h - decodes a picture file in memory to texels: PNG by libpng, JPEG, BMP, TGA and GIF by stb_image, PPM. */
#ifndef TOOLS_IMAGE_DECODE_H
#define TOOLS_IMAGE_DECODE_H

#include <tia/read.h>

#include "texels.h"

/* Decodes a picture of at most `side` pixels in each direction and `most` bytes of colours. TIA_ERR_RANGE or
 * TIA_ERR_MEMORY with *why, a static string. Transparent texels have the file's colours, too: transparency is in the
 * alpha channel alone. */
int image_decode(struct image_texels *texels, const void *bytes, size_t length, unsigned side, size_t most,
                 const char **why);

/* Keeps one channel of a decoded picture, which becomes its alpha. */
void image_channel(struct image_texels *texels, enum tia_channel channel);

#endif
