/* bands.c - a picture of samples, a band of rows at a time. */
#include <stdlib.h>
#include <string.h>

#include "common/image/image.h"
#include "estimation.h"
#include "fail.h"
#include "resume.h"

struct bands {
    struct estimation *e;
    struct resume resume;
    unsigned y, rows, known; /* the band; how many of its rows, from the top, are known already */
    struct tia_sum *sums;
};

static void draw_row(void *arg, unsigned row)
{
    struct bands *b = arg;
    struct estimation *e = b->e;
    unsigned width = e->film.width, y = b->y + row;
    struct tia_tile tile = {0, (uint16_t)y, (uint16_t)width, 1};
    struct tia_sum *sums = b->sums + (size_t)row * width;
    int status = TIA_OK;

    if (row >= b->known) {
        memset(sums, 0, width * sizeof *sums);
        status =
            e->estimator->sample(e->film_scene.view, tile, e->sums.first, e->sums.first + e->sums.count, sums, width);
    }
    if (status)
        atomic_store(&e->status, status);
    estimation_develop(e, b->y, row, sums);
    progress_add(&e->progress, width);
}

/* Of the rows that an interrupted run has left, those of the band. */
static int read_known(struct bands *b)
{
    unsigned rows = b->resume.rows;

    b->known = rows <= b->y ? 0 : rows - b->y < b->rows ? rows - b->y : b->rows;
    return b->known ? resume_read(&b->resume, b->y, b->known, b->sums) : TIA_OK;
}

static int draw(struct bands *b)
{
    struct estimation *e = b->e;
    unsigned height = e->film.height, band = estimation_band_rows(e), count = (height + band - 1) / band;
    bool bottom_up = e->image && image_bottom_up(e->image);
    int status = TIA_OK;

    for (unsigned i = 0; i < count && !status; i++) {
        b->y = (bottom_up ? count - 1 - i : i) * band;
        b->rows = height - b->y < band ? height - b->y : band;
        status = read_known(b);
        if (status)
            break;
        threads_workers.run(e->pool, draw_row, b, b->rows);
        status = atomic_load(&e->status);
        status = status ? status : resume_append(&b->resume, b->y, b->rows, b->sums);
        status = status ? status : estimation_write(e, b->rows);
    }
    return status;
}

int bands_draw(struct estimation *e)
{
    struct bands b = {.e = e, .sums = malloc((size_t)estimation_band_rows(e) * e->film.width * sizeof *b.sums)};
    int status = b.sums ? TIA_OK : TIA_ERR_MEMORY;

    if (!status && rounds_possible(e)) /* but for their memory */
        note("no memory for %zu bytes: drawn row by row, a signal keeps nothing (see --resume)", rounds_size(e));
    if (!status && e->options->resume)
        status = resume_open(&b.resume, e->options->resume, &e->sums, e->why);
    status = status ? status : estimation_open(e);
    status = status ? status : estimation_head(e);
    status = status ? status : draw(&b);
    resume_close(&b.resume);
    free(b.sums);
    return status;
}
