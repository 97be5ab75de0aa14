/* codec.h - the interface between image.c and the file formats. */
#ifndef TOOLS_IMAGE_CODEC_H
#define TOOLS_IMAGE_CODEC_H

#include "common/sink.h"
#include "film.h"

struct image;

/* A file format. The sink stores write errors; for all other errors these functions return a negative tia_status, with
 * the reason in `why`. */
struct image_codec {
    const char *name;
    bool bottom_up;
    int (*begin)(struct image *image);
    int (*row)(struct image *image, const tia_rgb565 *pixels);
    int (*bytes)(struct image *image, const unsigned char *row); /* NULL: only RGB565; see image_rows */
    void (*hurry)(struct image *image);                          /* NULL: no compression; see image_hurry */
    int (*end)(struct image *image);
    void (*free)(struct image *image); /* called after begin in any case */
};

struct image {
    const struct image_codec *codec;
    struct image_film film;
    unsigned width, height; /* size of the file's part of each frame */
    uint64_t rows;          /* rows of all frames written so far */
    uint32_t sum;           /* checksum of the frame so far, in formats that have one */
    int status;             /* the first error */
    unsigned char *line;    /* one row: 3 bytes per pixel, and padding */
    void *state;            /* the codec's own data */
    struct sink sink;
};

extern const struct image_codec image_codec_ppm, image_codec_bmp, image_codec_565;
extern const struct image_codec image_codec_y4m, image_codec_part, image_codec_pfm, image_codec_exr;
#ifdef TIA_HAVE_PNG
extern const struct image_codec image_codec_png;
#endif

/* Implements `bytes` for files that store rows unchanged. */
int image_put_bytes(struct image *image, const unsigned char *row);

/* Writes `count` pixels as little-endian bytes; returns the number of bytes. */
size_t image_put565(unsigned char *line, const tia_rgb565 *pixels, size_t count);

/* Expands `count` pixels to red, green and blue of 8 bits each by bit replication: 0 stays 0, full intensity becomes
 * 255. */
void image_expand(unsigned char *rgb, const tia_rgb565 *pixels, size_t count);

/* Adds the next row to image->sum, in formats whose frames have checksums. Returns true if it was the frame's last
 * row. */
bool image_part_add(struct image *image, const tia_rgb565 *pixels);

#endif
