#include "estimate.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "common/image/sums.h"
#include "common/sink.h"
#include "common/thread_pool.h"
#include "fail.h"
#include "film.h"
#include "film_scene.h"
#include "ports.h"
#include "progress.h"
#include "resume.h"

enum { BAND_PIXELS = 1 << 16 };

struct estimate {
    const struct options *options;
    struct image_film film;
    struct film_scene film_scene;
    const struct tia_estimator *estimator;
    struct sums sums;
    struct image *image; /* one of these is written to */
    struct sink *sink;
    struct resume resume;
    struct threads *pool;
    unsigned y, rows, known; /* the band; how many of its rows, from the top, are known already */
    struct tia_sum *band;
    unsigned char *bytes; /* the same as they are written */
    size_t row_bytes;
    struct progress progress;
    atomic_int status;
    char why[PORT_WHY];
};

static const struct tia_estimator *estimator_of(const struct tia_core *core)
{
#ifdef TIA_HAVE_F64
    if (core == &tia_core_f64)
        return &tia_estimator_f64;
#endif
    (void)core;
    return &tia_estimator_q16;
}

static void draw_row(void *arg, unsigned row)
{
    struct estimate *e = arg;
    unsigned width = e->film.width, y = e->y + row;
    struct tia_tile tile = {0, (uint16_t)y, (uint16_t)width, 1};
    struct tia_sum *sums = e->band + (size_t)row * width;
    unsigned char *at = e->bytes + row * e->row_bytes;
    int status = TIA_OK;

    if (row >= e->known) {
        memset(sums, 0, width * sizeof *sums);
        status =
            e->estimator->sample(e->film_scene.view, tile, e->sums.first, e->sums.first + e->sums.count, sums, width);
    }
    if (status)
        atomic_store(&e->status, status);
    if (e->sink)
        sums_put_row(at, &e->sums, y, sums);
    else
        sums_develop(at, &e->sums, sums, e->film.depth);
    progress_add(&e->progress, width);
}

/* Of the rows that an interrupted run has left, those of the band. */
static int read_known(struct estimate *e)
{
    unsigned rows = e->resume.rows;

    e->known = rows <= e->y ? 0 : rows - e->y < e->rows ? rows - e->y : e->rows;
    return e->known ? resume_read(&e->resume, e->y, e->known, e->band, e->why) : TIA_OK;
}

static int write_band(struct estimate *e)
{
    int status = resume_append(&e->resume, e->y, e->rows, e->band, e->why);

    if (status)
        return status;
    return e->sink ? sink_write(e->sink, e->bytes, e->rows * e->row_bytes) : image_rows(e->image, e->bytes, e->rows);
}

static int draw_bands(struct estimate *e)
{
    unsigned height = e->film.height, band = BAND_PIXELS / e->film.width ? BAND_PIXELS / e->film.width : 1;
    unsigned count = (height + band - 1) / band;
    bool bottom_up = e->image && image_bottom_up(e->image);
    int status = TIA_OK;

    for (unsigned i = 0; i < count && !status; i++) {
        e->y = (bottom_up ? count - 1 - i : i) * band;
        e->rows = height - e->y < band ? height - e->y : band;
        status = read_known(e);
        if (status)
            break;
        threads_workers.run(e->pool, draw_row, e, e->rows);
        status = atomic_load(&e->status);
        status = status ? status : write_band(e);
    }
    return status;
}

static int open_output(struct estimate *e)
{
    const struct options *options = e->options;
    char header[SUMS_HEADER];

    if (options->format != IMAGE_PART) {
        e->image = image_create_film(options->output, options->format, &e->film, e->why);
        return e->image ? TIA_OK : TIA_ERR_DEVICE;
    }
    e->sink = calloc(1, sizeof *e->sink);
    if (!e->sink)
        return TIA_ERR_MEMORY;
    int status = sink_open(e->sink, options->output, e->why);
    if (status) {
        free(e->sink);
        e->sink = NULL;
        return status;
    }
    return sink_write(e->sink, header, sums_print(header, &e->sums));
}

static int begin(struct estimate *e)
{
    const struct options *options = e->options;
    size_t pixels = (size_t)(BAND_PIXELS > e->film.width ? BAND_PIXELS : e->film.width);

    e->band = malloc(pixels * sizeof *e->band);
    e->bytes = malloc(pixels * (sizeof(struct tia_sum) + 4));
    e->pool = threads_create(options->threads);
    if (!e->band || !e->bytes || !e->pool)
        return TIA_ERR_MEMORY;
    int status = film_scene_begin(&e->film_scene, options, e->why);
    status = status ? status : film_scene_update(&e->film_scene, 0);
    if (!status && options->resume)
        status = resume_open(&e->resume, options->resume, &e->sums, e->why);
    return status ? status : open_output(e);
}

static int finish(struct estimate *e, int status)
{
    if (e->sink) {
        if (!status)
            status = sink_commit(e->sink);
        else
            sink_discard(e->sink);
        free(e->sink);
    } else if (e->image && !status) {
        return image_finish(e->image);
    } else if (e->image) {
        image_discard(e->image);
    }
    return status;
}

static void prepare(struct estimate *e, const struct options *options)
{
    const struct tia_integration *how = &options->scene.integration;

    e->options = options;
    e->estimator = estimator_of(options->core);
    e->film.depth = options->format == IMAGE_PART ? 0 : options->depth_bits;
    e->sums = (struct sums){.width = e->film.width,
                            .height = e->film.height,
                            .count = how->spp ? how->spp : TIA_SPP,
                            .tone = tia_tone_of(how),
                            .exposure = how->exposure,
                            .crc = e->film.crc};
    if (options->samples_range) {
        e->sums.first = options->first_sample;
        e->sums.count = options->last_sample - options->first_sample + 1;
    }
    e->film.transfer = sums_transfer(&e->sums, e->film.depth);
    e->row_bytes =
        options->format == IMAGE_PART ? sums_row_bytes(&e->sums) : (size_t)e->film.width * 3 * e->film.depth / 8;
}

static int report(const struct estimate *e, int status)
{
    if (!status)
        return EXIT_FINE;
    return fail(status == TIA_ERR_RANGE ? EXIT_USAGE : EXIT_RUNNING, "%s", e->why[0] ? e->why : fail_reason(status));
}

int estimate(const struct options *options)
{
    struct estimate e = {.options = options};
    int status = film_plan(options, &e.film);

    if (status != EXIT_FINE)
        return status;
    prepare(&e, options);
    progress_begin(&e.progress, (uint64_t)e.film.width * e.film.height, 1, options->progress);
    status = begin(&e);
    status = finish(&e, !status ? draw_bands(&e) : status);
    progress_end(&e.progress);
    resume_close(&e.resume);
    threads_destroy(e.pool);
    film_scene_end(&e.film_scene);
    free(e.band);
    free(e.bytes);
    return report(&e, status);
}
