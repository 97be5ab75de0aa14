/* picture.h - pictures into files: in bands of rows, each drawn by all threads while one of them writes the
 * band before. No more than two bands are in memory. */
#ifndef TOOLS_TIA_PICTURE_H
#define TOOLS_TIA_PICTURE_H

#include <stdatomic.h>

#include "common/image/image.h"
#include "common/threads.h"
#include "options.h"
#include "progress.h"
#include "rotate.h"

struct picture_band {
    unsigned y, rows; /* of the file's rows */
    tia_rgb565 *pixels;
};

struct picture {
    /* Of the picture that is drawn: filled in by its maker before each. */
    struct tia_view *view;
    struct image *image;

    /* Its own. */
    const struct tia_core *core;
    struct tia_options pixel_options;
    struct rotation rotation;
    unsigned width, first_row, rows; /* of the file: the picture turned */
    unsigned band_rows, job_rows;
    void *hits_memory;
    size_t hits_bytes;
    struct tia_hits *hits;
    struct threads *pool;
    struct picture_band band[2]; /* the one being drawn, and the one being written */
    struct tia_tile tile;        /* the band being drawn, on the picture */
    bool checksum;
    uint32_t crc; /* of the rows that were written */
    uint64_t crc_bytes;
    atomic_int status; /* of the jobs: the last error */
    struct progress progress;
};

/* Room for bands of the film's frames. TIA_ERR_MEMORY; picture_end is safe then. */
int picture_begin(struct picture *picture, const struct options *options, const struct image_film *film);

/* Draws one, until it is done or a signal was caught. */
int picture_draw(struct picture *picture);

void picture_end(struct picture *picture);

#endif
