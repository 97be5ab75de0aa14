/* texels.h - memory for the texels of a picture. */
#ifndef TOOLS_IMAGE_TEXELS_H
#define TOOLS_IMAGE_TEXELS_H

#include <tia/fixed.h>

struct image_texels {
    unsigned width, height;
    unsigned char *rgb;   /* red, green, blue; row by row from the upper left */
    unsigned char *alpha; /* one byte per texel; NULL: none */
};

/* Allocates width x height texels if they are within the limits of image_decode. Returns as image_decode. */
int image_room(struct image_texels *texels, uint64_t width, uint64_t height, unsigned side, size_t most,
               const char **why);

/* Frees the alpha channel, if there is one. */
void image_drop_alpha(struct image_texels *texels);
/* Frees all texels, and the alpha channel if there is one. */
void image_free(struct image_texels *texels);

/* Splits four bytes per texel, from malloc, into colours and alpha channel. */
void image_split(struct image_texels *texels, unsigned char *rgba);

#endif
