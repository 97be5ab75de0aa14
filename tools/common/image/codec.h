/* codec.h - what image.c and the files of the formats share. */
#ifndef PORT_IMAGE_CODEC_H
#define PORT_IMAGE_CODEC_H

#include "image.h"
#include "sink.h"

struct image;

/* One file format. Failures of the file are kept by the sink; what these return is looked at
 * for the rest: a negative tia_status, with *why filled in. */
struct image_codec {
    const char *name;
    bool bottom_up;
    int (*begin)(struct image *image);
    int (*row)(struct image *image, const tia_rgb565 *pixels);
    int (*end)(struct image *image);
    void (*free)(struct image *image); /* after begin, however the picture ended */
};

struct image {
    const struct image_codec *codec;
    struct image_film film;
    unsigned width, height; /* of what is written of each frame */
    uint64_t rows;          /* so far, of all frames */
    int status;             /* the first error */
    unsigned char *line;    /* room for one row: 3 bytes a pixel and padding */
    void *state;            /* the codec's own */
    struct sink sink;
};

extern const struct image_codec image_codec_ppm, image_codec_bmp, image_codec_565;
extern const struct image_codec image_codec_y4m, image_codec_part;
#ifdef TIA_HAVE_PNG
extern const struct image_codec image_codec_png;
#endif

/* Little-endian bytes of `count` pixels; returns how many bytes. */
size_t image_put565(unsigned char *line, const tia_rgb565 *pixels, size_t count);

/* Red, green and blue of `count` pixels with 8 bits each: the high bits are repeated below the
 * low ones, so that 0 stays 0 and full becomes 255. */
void image_expand(unsigned char *rgb, const tia_rgb565 *pixels, size_t count);

#endif
