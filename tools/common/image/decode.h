/* decode.h - decodes a picture file in memory to texels: PNG by libpng, JPEG, BMP, TGA and GIF by stb_image, PPM. */
#ifndef PORT_IMAGE_DECODE_H
#define PORT_IMAGE_DECODE_H

#include "texels.h"

/* Decodes a picture of at most `side` pixels in each direction and `most` bytes of texels. TIA_ERR_RANGE or
 * TIA_ERR_MEMORY with *why, a static string. Transparent pixels are composited on black. */
int image_decode(struct image_texels *texels, const void *bytes, size_t length, unsigned side, size_t most,
                 const char **why);

/* The mean, 0..1, of a picture's alpha channel or, if it has none, of its three colours. Otherwise as image_decode. */
int image_opacity(tia_q30 *mean, const void *bytes, size_t length, unsigned side, size_t most, const char **why);

#endif
