/* picture.h - draws a picture into a file in bands of rows. All threads draw a band, but one of them first writes the
 * previous band. Only two bands are in memory. */
#ifndef TOOLS_TIA_PICTURE_H
#define TOOLS_TIA_PICTURE_H

#include <stdatomic.h>

#include "common/image/image.h"
#include "common/thread_pool.h"
#include "finished.h"
#include "options.h"
#include "progress.h"
#include "rotate.h"
#include "survey.h"

struct picture_band {
    unsigned y, rows; /* rows of the file */
    tia_rgb565 *pixels;
    uint16_t *colours; /* NULL: RGB565 is written */
};

struct picture {
    /* Set by the caller before each picture. */
    struct tia_view *view;
    struct image *image;       /* NULL: no file is written */
    struct finished *finished; /* NULL: finished rows are not stored */
    uint32_t frame;            /* number of the frame in `finished` */

    /* Private. */
    const struct tia_core *core;
    struct tia_options pixel_options;
    struct rotation rotation;
    unsigned width, first_row, rows; /* size and rows of the file, that is, of the rotated picture */
    unsigned band_rows, job_rows;
    unsigned number, jobs; /* the band being drawn, counted from the top; number of its jobs */
    struct survey survey;
    void *hits_memory;
    size_t hits_bytes;
    struct tia_hits *hits;
    struct threads *pool;
    struct picture_band band[2]; /* one band being drawn, one being written */
    struct tia_tile tile;        /* tile of the picture: the band being drawn */
    unsigned depth;              /* bits of the colours, see struct image_film */
    const struct row_tap *tap;   /* NULL: none */
    unsigned char *row;          /* a row as bytes, for the tap */
    bool checksum;
    unsigned char *floats; /* a row of 32 bits a channel; NULL: other colours */
    uint32_t crc;          /* CRC of the rows written so far */
    uint64_t crc_bytes;
    atomic_int status; /* the last error of a job */
    struct progress progress;
};

/* Allocates bands for the film's frames. After TIA_ERR_MEMORY picture_end is safe. */
int picture_begin(struct picture *picture, const struct options *options, const struct image_film *film);

/* Draws the picture into `image`. A negative status on failure. */
int picture_draw(struct picture *picture);

void picture_end(struct picture *picture);

#endif
