/* draw.c - one picture into a file: in bands of rows, each drawn by all threads while one of
 * them writes the band before. No more than two bands are in memory. */
#include "draw.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/clock.h"
#include "common/threads.h"
#include "crc.h"
#include "fail.h"
#include "lights.h"
#include "ports.h"
#include "progress.h"
#include "signals.h"
#include "stats.h"
#include "turn.h"

enum { DEFAULT_WIDTH = 640, DEFAULT_HEIGHT = 480 };

/* Enough pixels that the threads seldom wait for the last of them, and little memory: a band's
 * hits are some tens of bytes a pixel. A job is some full rows: the core works by rows. */
enum { BAND_PIXELS = 1 << 19, JOB_PIXELS = 1 << 13 };

struct band {
    unsigned y, rows; /* of the file's rows */
    tia_rgb565 *pixels;
};

struct drawing {
    const struct tia_core *core;
    struct tia_options pixel_options;
    struct turn turn;
    unsigned width, height; /* of the file: the picture turned */
    unsigned band_rows, job_rows;
    struct lights lights;
    void *view_memory, *hits_memory;
    size_t hits_bytes;
    struct tia_view *view;
    struct tia_hits *hits;
    struct threads *pool;
    struct image *image;
    struct band band[2];  /* the one being drawn, and the one being written */
    struct tia_tile tile; /* the band being drawn, on the picture */
    bool checksum;
    uint32_t crc;
    uint64_t crc_bytes;
    atomic_int status; /* of the jobs: the last error */
    char why[PORT_WHY];
};

static struct tia_tile tile_of(const struct drawing *drawing, const struct band *band)
{
    struct turn back = turn_back(&drawing->turn);
    struct tia_tile rows = {0, (uint16_t)band->y, (uint16_t)drawing->width, (uint16_t)band->rows};
    return turn_tile(&back, rows);
}

/* ---- jobs ---- */

static void write_band(struct drawing *drawing, const struct band *band)
{
    size_t count = (size_t)band->rows * drawing->width;
    if (drawing->checksum && image_bottom_up(drawing->image)) {
        drawing->crc = crc_join(tia_crc32(0, band->pixels, count), drawing->crc, drawing->crc_bytes);
    } else if (drawing->checksum) {
        drawing->crc = tia_crc32(drawing->crc, band->pixels, count);
    }
    drawing->crc_bytes += count * sizeof *band->pixels;
    int status = image_band(drawing->image, band->pixels, band->rows);
    if (status != TIA_OK) {
        atomic_store(&drawing->status, status);
    }
}

static void draw_rows(struct drawing *drawing, unsigned job)
{
    unsigned first = job * drawing->job_rows, left = drawing->tile.height - first;
    struct tia_tile tile = drawing->tile;
    tile.y = (uint16_t)(tile.y + first);
    tile.height = (uint16_t)(left < drawing->job_rows ? left : drawing->job_rows);

    struct tia_tile place = turn_tile(&drawing->turn, tile);
    const struct band *band = &drawing->band[0];
    struct tia_surface rows = {band->pixels + (size_t)(place.y - band->y) * drawing->width + place.x,
                               sizeof(tia_rgb565), (ptrdiff_t)(drawing->width * sizeof(tia_rgb565))};
    struct tia_surface surface = turn_surface(&drawing->turn, &rows, place.width, place.height);

    int status = drawing->core->trace(drawing->view, drawing->hits, tile);
    if (status == TIA_OK) {
        status = drawing->core->light(drawing->view, drawing->hits, tile, &surface, &drawing->pixel_options);
    }
    if (status != TIA_OK) {
        atomic_store(&drawing->status, status);
    }
}

static void work(void *arg, unsigned index)
{
    struct drawing *drawing = arg;
    if (index > 0) {
        draw_rows(drawing, index - 1);
    } else if (drawing->band[1].rows > 0) {
        write_band(drawing, &drawing->band[1]);
    }
}

/* ---- the picture ---- */

static int draw_band(struct drawing *drawing)
{
    struct band *band = &drawing->band[0];
    unsigned jobs = 0;
    if (band->rows > 0) {
        drawing->tile = tile_of(drawing, band);
        jobs = (drawing->tile.height + drawing->job_rows - 1) / drawing->job_rows;
        int status = drawing->core->hits_init(&drawing->hits, drawing->hits_memory, drawing->hits_bytes, drawing->tile);
        if (status != TIA_OK) {
            return status;
        }
    }
    threads_workers.run(drawing->pool, work, drawing, jobs + 1);

    struct band written = drawing->band[1];
    drawing->band[1] = drawing->band[0];
    drawing->band[0] = written;
    return atomic_load(&drawing->status);
}

/* All bands, in the order that the file needs; one empty band more writes the last. */
static int draw_bands(struct drawing *drawing)
{
    struct progress progress;
    unsigned count = (drawing->height + drawing->band_rows - 1) / drawing->band_rows;
    int status = TIA_OK;
    progress_begin(&progress);
    for (unsigned i = 0; i <= count && status == TIA_OK && signals_caught == 0; i++) {
        struct band *band = &drawing->band[0];
        band->rows = 0;
        if (i < count) {
            band->y = (image_bottom_up(drawing->image) ? count - 1 - i : i) * drawing->band_rows;
            band->rows =
                drawing->height - band->y < drawing->band_rows ? drawing->height - band->y : drawing->band_rows;
        }
        status = draw_band(drawing);
        progress_update(&progress, i, count);
    }
    progress_end(&progress);
    return status;
}

/* Everything that has to be there before the first pixel. */
static int prepare(struct drawing *drawing, const struct options *options)
{
    const struct tia_core *core = drawing->core = options->core;
    drawing->pixel_options.dither = options->dither;
    drawing->checksum = options->checksum;
    drawing->turn = (struct turn){options->rotate, options->width ? options->width : DEFAULT_WIDTH,
                                  options->height ? options->height : DEFAULT_HEIGHT};
    struct turn back = turn_back(&drawing->turn);
    drawing->width = back.width;
    drawing->height = back.height;
    drawing->band_rows =
        BAND_PIXELS / drawing->width < drawing->height ? BAND_PIXELS / drawing->width : drawing->height;

    struct band whole = {0, drawing->band_rows, NULL};
    struct tia_tile tile = tile_of(drawing, &whole);
    drawing->job_rows = tile.width < JOB_PIXELS ? (unsigned)JOB_PIXELS / tile.width : 1;
    drawing->hits_bytes = core->hits_size(tile);
    drawing->hits_memory = malloc(drawing->hits_bytes);
    for (unsigned i = 0; i < 2; i++) {
        drawing->band[i].pixels = malloc((size_t)drawing->band_rows * drawing->width * sizeof(tia_rgb565));
    }
    drawing->pool = threads_create(options->threads);
    if (!lights_copy(&drawing->lights, options->scene) || drawing->hits_memory == NULL || drawing->pool == NULL ||
        drawing->band[0].pixels == NULL || drawing->band[1].pixels == NULL) {
        return TIA_ERR_MEMORY;
    }
    return TIA_OK;
}

static int prepare_view(struct drawing *drawing, const struct options *options)
{
    const struct tia_core *core = drawing->core;
    struct lights *lights = &drawing->lights;
    size_t bytes = core->view_size(options->scene, lights->capacity);
    drawing->view_memory = malloc(bytes);
    if (drawing->view_memory == NULL) {
        return TIA_ERR_MEMORY;
    }
    int status = core->view_init(&drawing->view, drawing->view_memory, bytes, options->scene, lights->capacity,
                                 drawing->turn.width, drawing->turn.height);
    if (status != TIA_OK) {
        return status;
    }
    lights_press(lights, options->scene, options->keys, options->key_count);
    return core->set_lights(drawing->view, lights->array, lights->count);
}

/* The file: a signal must not leave a temporary one, but where there is none, in a pipe's write,
 * it may end the program at once. */
static int draw_image(struct drawing *drawing, const struct options *options)
{
    signals_catch();
    drawing->image = image_create(options->output, options->format, drawing->width, drawing->height, drawing->why);
    if (drawing->image == NULL) {
        return TIA_ERR_DEVICE;
    }
    if (!image_temporary(drawing->image)) {
        signals_release();
    }
    int status = draw_bands(drawing);
    if (status != TIA_OK || signals_caught != 0) {
        image_discard(drawing->image);
        return status;
    }
    return image_finish(drawing->image);
}

/* As of a display with one frame. */
static void print_stats(const struct drawing *drawing, const struct options *options, uint64_t us)
{
    static struct stats stats; /* too large for a stack */
    stats.frames = 1;
    stats.display = "file";
    stats.format = image_format_name(options->format);
    stats.width = drawing->turn.width;
    stats.height = drawing->turn.height;
    stats.threads = threads_count(drawing->pool);
    stats_add(&stats.draw, us);
    stats_print(&stats);
}

static int report(struct drawing *drawing, const struct options *options, int status, uint64_t us)
{
    if (signals_caught != 0) {
        return EXIT_RUNNING; /* dies of the signal */
    }
    if (status != TIA_OK) {
        return fail(EXIT_RUNNING, "%s",
                    drawing->why[0] != '\0'    ? drawing->why
                    : status == TIA_ERR_MEMORY ? "memory: exhausted"
                                               : "scene: a value is out of range");
    }
    if (options->checksum && (printf("0 %08x\n", drawing->crc) < 0 || fflush(stdout) != 0)) {
        return fail_output();
    }
    if (options->stats) {
        print_stats(drawing, options, us);
    }
    return EXIT_FINE;
}

int draw(const struct options *options)
{
    struct drawing drawing = {.core = options->core};
    uint64_t start = clock_now_us();
    int status = prepare(&drawing, options);
    if (status == TIA_OK) {
        status = prepare_view(&drawing, options);
    }
    if (status == TIA_OK) {
        status = draw_image(&drawing, options);
    }
    int result = report(&drawing, options, status, clock_now_us() - start);
    threads_destroy(drawing.pool);
    for (unsigned i = 0; i < 2; i++) {
        free(drawing.band[i].pixels);
    }
    free(drawing.hits_memory);
    free(drawing.view_memory);
    free(drawing.lights.array);
    return signals_end(result);
}
