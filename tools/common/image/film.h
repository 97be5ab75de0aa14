/* film.h - the contents of a picture or film file. */
#ifndef TOOLS_IMAGE_FILM_H
#define TOOLS_IMAGE_FILM_H

#include <tia/fixed.h>

enum image_format {
    IMAGE_UNKNOWN,
    IMAGE_PNG,
    IMAGE_PPM,
    IMAGE_BMP,
    IMAGE_565,
    IMAGE_Y4M,
    IMAGE_PART,
    IMAGE_PFM,
    IMAGE_EXR
};

/* The meaning of a picture's numbers: unspecified, linear light, or light by the transfer function of sRGB. */
enum image_transfer { IMAGE_UNSAID, IMAGE_LINEAR, IMAGE_SRGB };

/* The first surface that a pixel's middle shows. */
struct image_surface {
    float depth;     /* distance from the eye; infinite: nothing */
    float normal[3]; /* unit normal on the visible side; 0 for a light and for nothing */
    uint32_t object; /* number of the object from 1; 0 for a light and for nothing */
};

/* The frames of a film that a file contains, and the rows of each. A picture is a film of one frame. */
struct image_film {
    unsigned width, height;   /* size of a whole frame */
    unsigned first_row, rows; /* rows in the file */
    uint32_t first_frame, frames;
    uint32_t all_frames; /* number of frames in the whole film */
    uint32_t rate[2];    /* frames per second: numerator, denominator */
    unsigned depth;      /* bits a channel: 0 for RGB565, 8, 16, or 32 for floats */
    enum image_transfer transfer;
    const struct image_surface *surfaces; /* NULL, or the surfaces of all pixels, for IMAGE_EXR */
    uint32_t crc;                         /* CRC of the scene and the options: the same for all parts of a film */
};

#endif
