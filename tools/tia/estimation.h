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
    struct sums sums;    /* description of the file; `count` is the number requested until all samples are drawn */
    struct image *image; /* the output is one of these */
    struct sink *sink;
    struct threads *pool;
    unsigned char *bytes; /* rows of a band in the file's format */
    size_t row_bytes;
    struct progress progress;
    atomic_int status;     /* status of the threads' jobs */
    uint64_t end_us;       /* end of the time limit; 0: the drawing cannot be stopped */
    atomic_uint looked_us; /* clock_now_us() at the last check for a reason to stop, mod 2^32 */
    atomic_bool stopped;
    char why[PORT_WHY];
};

/* Returns the rows that are drawn, or written, at once. */
unsigned estimation_band_rows(const struct estimation *e);

/* Opens the output. */
int estimation_open(struct estimation *e);
/* Writes the header of a part, which has e->sums.count. */
int estimation_head(struct estimation *e);

/* Converts a row to the output's format: number `row` of a band that begins at `y`. */
void estimation_develop(struct estimation *e, unsigned y, unsigned row, const struct tia_sum *sums);
/* Writes the band. */
int estimation_write(struct estimation *e, unsigned rows);

/* Draws a band at a time, all samples at once, for pictures of any size. Finished rows can be stored for --resume.
 * Including the output rows, a band has at most 16 bytes for each pixel of a picture of 8 rows or more. */
int bands_draw(struct estimation *e);

/* True if there may be memory for rounds. */
bool rounds_possible(const struct estimation *e);
/* Draws the whole picture, a sample of each pixel at a time. Rounds end after any of them, with their number in
 * e->sums.count. TIA_STOPPED: a signal came before the first one was complete. */
int rounds_draw(struct estimation *e);

/* Status of rounds_draw when memory is short; nothing has been opened then. rounds_size returns the bytes that it
 * needs: all samples of a pixel, twice. */
enum { ROUNDS_NO_MEMORY = 1 };
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

/* Puts in e->sums.count samples of row `y`. Rows come in any order, from any threads. */
void denoising_put(struct denoising *denoising, unsigned y, const struct tia_gathered *row);
/* Filters the picture, after all rows. */
void denoising_filter(struct denoising *denoising);
/* Gives the row's sums without noise. */
void denoising_get(const struct denoising *denoising, unsigned y, struct tia_sum *row);

/* Replaces the sums of a row by the guide of --guide. */
void show_guide(const struct estimation *e, const struct tia_gathered *row);

#endif
