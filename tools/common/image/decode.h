/* decode.h - decodes a picture file in memory to texels: PNG, by libpng, and PPM (P3, P6). */
#ifndef PORT_IMAGE_DECODE_H
#define PORT_IMAGE_DECODE_H

#include <tia/fixed.h>

struct image_texels {
    unsigned width, height;
    unsigned char *rgb; /* red, green, blue; row by row from the upper left; free() it */
};

/* Decodes a picture of at most `side` pixels in each direction and `most` bytes of texels. TIA_ERR_RANGE or
 * TIA_ERR_MEMORY with *why, a static string. Transparent pixels are composited on black. */
int image_decode(struct image_texels *texels, const void *bytes, size_t length, unsigned side, size_t most,
                 const char **why);

#ifdef TIA_HAVE_PNG
/* The same, for PNG only. */
int image_decode_png(struct image_texels *texels, const void *bytes, size_t length, unsigned side, size_t most,
                     const char **why);
#endif

/* Allocates width x height texels if they are within the limits. */
int image_room(struct image_texels *texels, uint64_t width, uint64_t height, unsigned side, size_t most,
               const char **why);

#endif
