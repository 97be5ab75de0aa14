/* bands.c - draws a picture of samples, a band of rows at a time. */
#include <stdlib.h>
#include <string.h>

#include "common/forecast.h"
#include "common/image/image.h"
#include "estimation.h"
#include "fail.h"
#include "resume.h"

struct bands {
    struct estimation *e;
    struct resume resume;
    struct denoising denoising;
    unsigned y, rows, known; /* first row and size of the band; number of its first rows that are read from the file */
    bool again;              /* all rows have been drawn before */
    struct tia_gathered band;
};

static struct tia_gathered row_of(const struct bands *b, unsigned row)
{
    return gathered_at(&b->band, (size_t)row * b->e->film.width);
}

static void clear(const struct tia_gathered *row, size_t width)
{
    memset(row->sums, 0, width * sizeof *row->sums);
    if (row->guides)
        memset(row->guides, 0, width * sizeof *row->guides);
    if (row->squares)
        memset(row->squares, 0, width * sizeof *row->squares);
}

static void draw_row(void *arg, unsigned index)
{
    struct bands *b = arg;
    struct estimation *e = b->e;
    unsigned width = e->film.width, row = forecast_part(index, b->rows), y = b->y + row;
    struct tia_tile tile = {0, (uint16_t)y, (uint16_t)width, 1};
    struct tia_gathered to = row_of(b, row);
    int status = TIA_OK;

    if (row >= b->known && estimation_wants(e, y)) {
        clear(&to, width);
        status = e->estimator->gather(e->film_scene.view, tile, e->sums.first, e->sums.first + e->sums.count, &to);
    }
    if (status)
        atomic_store(&e->status, status);
    if (!b->again && row >= b->known)
        progress_add(&e->progress, width);
    else if (!b->again)
        progress_skip(&e->progress, width);
}

/* Reads the first rows of the band, as far as the file of --resume has them. */
static int read_known(struct bands *b)
{
    unsigned rows = b->resume.rows;

    b->known = rows <= b->y ? 0 : rows - b->y < b->rows ? rows - b->y : b->rows;
    return b->known ? resume_read(&b->resume, b->y, b->known, &b->band) : TIA_OK;
}

static unsigned band_count(const struct bands *b)
{
    unsigned band = estimation_band_rows(b->e);

    return (b->e->film.height + band - 1) / band;
}

static void choose(struct bands *b, unsigned number)
{
    unsigned band = estimation_band_rows(b->e), left;

    b->y = number * band;
    left = b->e->film.height - b->y;
    b->rows = left < band ? left : band;
}

/* Gathers the samples of a band: reads them from the file, or draws and appends them. */
static int gather(struct bands *b, unsigned number)
{
    choose(b, number);
    int status = read_known(b);
    if (status)
        return status;
    threads_run(b->e->pool, draw_row, b, b->rows);
    status = atomic_load(&b->e->status);
    return status ? status : resume_append(&b->resume, b->y, b->rows, &b->band);
}

static void put_row(void *arg, unsigned row)
{
    struct bands *b = arg;
    const struct tia_gathered from = row_of(b, row);

    denoising_put(&b->denoising, b->y + row, &from);
}

static void develop_row(void *arg, unsigned row)
{
    struct bands *b = arg;
    const struct tia_gathered from = row_of(b, row);

    if (!tap_wants(b->e->options->tap, 0, b->y + row))
        return;
    if (b->e->options->denoise)
        denoising_get(&b->denoising, b->y + row, from.sums);
    else if (b->e->options->guide)
        show_guide(b->e, &from);
    estimation_develop(b->e, b->y, row, from.sums);
}

/* Gathers all rows before the first is written: the denoiser needs all, and the file of --resume grows from the top
 * even if the picture is written bottom-up. */
static int gather_all(struct bands *b)
{
    bool denoise = b->e->options->denoise;
    int status = TIA_OK;

    for (unsigned i = 0; i < band_count(b) && !status; i++) {
        status = gather(b, i);
        if (!status && denoise)
            threads_run(b->e->pool, put_row, b, b->rows);
    }
    if (!status && denoise)
        denoising_filter(&b->denoising);
    b->again = true;
    return status;
}

static int draw(struct bands *b)
{
    struct estimation *e = b->e;
    bool bottom_up = e->image && image_bottom_up(e->image), denoise = e->options->denoise;
    unsigned count = band_count(b);
    int status = denoise || (bottom_up && e->options->resume) ? gather_all(b) : TIA_OK;

    for (unsigned i = 0; i < count && !status; i++) {
        unsigned number = bottom_up ? count - 1 - i : i;
        if (denoise)
            choose(b, number);
        else
            status = gather(b, number);
        if (status)
            break;
        threads_run(e->pool, develop_row, b, b->rows);
        status = estimation_write(e, b->y, b->rows);
    }
    return status;
}

static int get_memory(struct bands *b)
{
    size_t pixels = (size_t)estimation_band_rows(b->e) * b->e->film.width;

    b->band.pitch = b->e->film.width;
    b->band.sums = malloc(pixels * sizeof *b->band.sums);
    if (b->e->sums.guided) {
        b->band.guides = malloc(pixels * sizeof *b->band.guides);
        b->band.squares = malloc(pixels * sizeof *b->band.squares);
    }
    if (!b->band.sums || (b->e->sums.guided && (!b->band.guides || !b->band.squares)))
        return TIA_ERR_MEMORY;
    return b->e->options->denoise ? denoising_begin(&b->denoising, b->e) : TIA_OK;
}

int bands_draw(struct estimation *e)
{
    struct bands b = {.e = e};
    int status = get_memory(&b);

    if (!status && rounds_possible(e)) /* rounds_draw lacked memory */
        note("no memory for %zu bytes: drawn row by row, a signal keeps nothing (see --resume)", rounds_size(e));
    if (!status && e->options->resume)
        status = resume_open(&b.resume, e->options->resume, &e->sums, e->why);
    status = status ? status : estimation_open(e);
    status = status ? status : estimation_head(e);
    progress_start(&e->progress);
    status = status ? status : draw(&b);
    resume_close(&b.resume);
    denoising_end(&b.denoising);
    free(b.band.sums);
    free(b.band.guides);
    free(b.band.squares);
    return status;
}
