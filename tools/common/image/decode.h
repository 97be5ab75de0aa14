/* decode.h - decodes a picture file in memory to texels: PNG by libpng; JPEG, BMP, TGA and GIF by stb_image; PPM
 * without a library. */
#ifndef TOOLS_IMAGE_DECODE_H
#define TOOLS_IMAGE_DECODE_H

#include <tia/read.h>

#include "texels.h"

/* Decodes a picture of at most `side` pixels in each direction and `most` bytes of colours. Returns TIA_OK; or
 * TIA_ERR_RANGE or TIA_ERR_MEMORY, with the reason in *why, a static string. Transparency affects only the alpha
 * channel: the colours are those of the file. */
int image_decode(struct image_texels *texels, const void *bytes, size_t length, unsigned side, size_t most,
                 const char **why);

/* Reduces a decoded picture to one of its channels, which becomes its alpha channel. */
void image_channel(struct image_texels *texels, enum tia_channel channel);

#endif
