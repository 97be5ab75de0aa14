/* texels.h - memory for the texels of a picture. */
#ifndef TOOLS_IMAGE_TEXELS_H
#define TOOLS_IMAGE_TEXELS_H

#include <tia/fixed.h>

struct image_texels {
    unsigned width, height;
    unsigned char *rgb; /* red, green, blue; row by row from the upper left; free() it */
};

/* Allocates width x height texels if they are within the limits of image_decode. */
int image_room(struct image_texels *texels, uint64_t width, uint64_t height, unsigned side, size_t most,
               const char **why);

#endif
