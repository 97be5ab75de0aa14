/* decode_png.h - a PNG file as texels. */
#ifndef TOOLS_IMAGE_DECODE_PNG_H
#define TOOLS_IMAGE_DECODE_PNG_H

#include "texels.h"

#ifdef TIA_HAVE_PNG
/* Decodes a PNG file as image_decode does. */
int image_decode_png(struct image_texels *texels, const void *bytes, size_t length, unsigned side, size_t most,
                     const char **why);
#endif

#endif
