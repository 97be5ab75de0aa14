/* estimation.h - a picture of samples while it is drawn: what estimate.c, which decides, shares with those who draw. */
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
    struct sums sums;    /* what the file has; `count` is what was asked for until all is drawn */
    struct image *image; /* one of these is written to */
    struct sink *sink;
    struct threads *pool;
    unsigned char *bytes; /* as many rows as a band has, as they are written */
    size_t row_bytes;
    struct progress progress;
    atomic_int status;     /* of what threads do */
    uint64_t end_us;       /* when the time is over; 0: the drawing is not one that is asked to stop */
    atomic_uint looked_us; /* clock_now_us() at the last look for a reason to stop, mod 2^32 */
    atomic_bool stopped;
    char why[PORT_WHY];
};

/* The rows that are drawn, or written, at once. */
unsigned estimation_band_rows(const struct estimation *e);

/* Opens the file; then begins a part, whose header says e->sums.count. */
int estimation_open(struct estimation *e);
int estimation_head(struct estimation *e);

/* A row as it is written, number `row` of a band that begins at `y`; then the band. */
void estimation_develop(struct estimation *e, unsigned y, unsigned row, const struct tia_sum *sums);
int estimation_write(struct estimation *e, unsigned rows);

/* A band at a time, all samples at once: whatever the picture's size, and finished rows can be kept for --resume. With
 * what a band is written from it has at most 16 bytes for each pixel of a picture of 8 rows or more. */
int bands_draw(struct estimation *e);

/* Whether there may be memory for rounds: the whole picture, a sample of each pixel at a time. They end after any
 * round, with e->sums.count told. TIA_STOPPED: a signal came before the first one was complete. */
bool rounds_possible(const struct estimation *e);
int rounds_draw(struct estimation *e);

/* The bytes of memory that rounds_draw asks for: all samples of a pixel, twice. Without them it returns
 * ROUNDS_NO_MEMORY, and nothing has been opened. */
enum { ROUNDS_NO_MEMORY = 1 };
size_t rounds_size(const struct estimation *e);

/* A denoiser of the whole picture; all zero, there is none. */
struct denoising {
    struct estimation *e;
    struct tia_denoiser *denoiser;
    void *memory;
    unsigned pass;
};

/* Takes 68 bytes a pixel. */
int denoising_begin(struct denoising *denoising, struct estimation *e);
void denoising_end(struct denoising *denoising);

/* What e->sums.count samples of row `y` have gathered; and, after all rows and the filter, its sums without noise. Rows
 * come in any order, from any threads. */
void denoising_put(struct denoising *denoising, unsigned y, const struct tia_gathered *row);
void denoising_filter(struct denoising *denoising);
void denoising_get(const struct denoising *denoising, unsigned y, struct tia_sum *row);

/* Puts the guide of --guide into the sums of a row. */
void show_guide(const struct estimation *e, const struct tia_gathered *row);

#endif
