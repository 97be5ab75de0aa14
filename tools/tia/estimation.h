/* estimation.h - the state of a picture of samples being drawn: shared by sample_picture.c, which chooses how to draw,
 * and the files that draw. */
#ifndef TOOLS_TIA_ESTIMATION_H
#define TOOLS_TIA_ESTIMATION_H

#include <stdatomic.h>
#include <tia/denoise.h>

#include "common/image/sums.h"
#include "common/thread_pool.h"
#include "film_scene.h"
#include "options.h"
#include "ports.h"
#include "progress.h"

struct estimation {
    const struct options *options;
    struct image_film film;
    struct film_scene film_scene;
    const struct tia_estimator *estimator;
    struct sums sums;    /* description of the samples; until all are drawn, `count` is the requested number */
    struct image *image; /* the output if it is a picture; NULL: it is `sink` */
    struct sink *sink;
    struct threads *pool;
    unsigned char *bytes; /* rows of a band in the file's format */
    size_t row_bytes;
    struct progress progress;
    atomic_int status;     /* status of the threads' jobs */
    uint64_t end_us;       /* end of the time limit; 0: the drawing cannot be stopped */
    atomic_uint looked_us; /* clock_now_us() at the last check for a reason to stop, mod 2^32 */
    atomic_bool stopped;
    bool unfinished; /* a signal came, and the picture was not denoised */
    char why[PORT_WHY];
};

/* Returns the number of rows of a band, which is drawn and written at once. */
unsigned estimation_band_rows(const struct estimation *e);

/* Opens the output. */
int estimation_open(struct estimation *e);
/* Writes the header of a part, with e->sums.count; a picture has none. */
int estimation_head(struct estimation *e);

/* Converts row `row` of the band that begins at row `y` of the picture to the output's format, in e->bytes. */
void estimation_develop(struct estimation *e, unsigned y, unsigned row, const struct tia_sum *sums);
/* Writes the first `rows` rows of e->bytes, which begin at row `y` of the picture. */
int estimation_write(struct estimation *e, unsigned y, unsigned rows);

/* True if row `y` must be drawn. */
bool estimation_wants(const struct estimation *e, unsigned y);

/* Draws one band after the other, each with all its samples. The picture may have any size, and --resume can store the
 * finished rows. Including the output rows, but without the denoiser's guides, a band takes at most 16 bytes for each
 * pixel of a picture of 8 rows or more. */
int bands_draw(struct estimation *e);

/* True if rounds_draw can draw the picture, given enough memory: without --resume, and up to 2^24 pixels. */
bool rounds_possible(const struct estimation *e);
/* Draws the whole picture in rounds of one or more samples of each pixel. The drawing can end after any round;
 * e->sums.count then is the number of samples drawn. TIA_STOPPED: no round was completed. */
int rounds_draw(struct estimation *e);

/* Status of rounds_draw when memory is short; the output is not open then. */
enum { ROUNDS_NO_MEMORY = 1 };
/* Returns the bytes that rounds_draw needs for two copies of the samples of all pixels. */
size_t rounds_size(const struct estimation *e);

/* A denoiser of the whole picture; all zero: none. */
struct denoising {
    struct estimation *e;
    struct tia_denoiser *denoiser;
    void *memory;
    unsigned pass;
};

/* Creates the denoiser, which takes 68 bytes a pixel. */
int denoising_begin(struct denoising *denoising, struct estimation *e);
void denoising_end(struct denoising *denoising);

/* Adds row `y` with e->sums.count samples a pixel. Any thread may call it, for the rows in any order. */
void denoising_put(struct denoising *denoising, unsigned y, const struct tia_gathered *row);
/* Filters the picture, after denoising_put of all rows. */
void denoising_filter(struct denoising *denoising);
/* Gives the filtered sums of row `y`. */
void denoising_get(const struct denoising *denoising, unsigned y, struct tia_sum *row);

/* Replaces the sums of a row by the guide of --guide. */
void show_guide(const struct estimation *e, const struct tia_gathered *row);

#endif
