/* decode_stb.h - JPEG, BMP, TGA and GIF files as texels. */
#ifndef TOOLS_IMAGE_DECODE_STB_H
#define TOOLS_IMAGE_DECODE_STB_H

#include "texels.h"

#ifdef TIA_HAVE_STB
/* Decodes a file as image_decode does. */
int image_decode_stb(struct image_texels *texels, const unsigned char *bytes, size_t length, unsigned side, size_t most,
                     const char **why);
#endif

#endif
