#include "picture.h"

#include <stdlib.h>
#include <string.h>
#include <tia/debug.h>

#include "common/crc_join.h"
#include "common/forecast.h"
#include "common/image/bytes.h"
#include "common/image/codec.h"
#include "film_plan.h"

/* Sizes. A band is so large that threads seldom wait for the last job, and so small that its hits, some tens of bytes
 * per pixel, take little memory. A job consists of whole rows, since the core draws row by row. Jobs of rays are small,
 * so that a tenth of them is a fair sample of the picture. The rasteriser takes each face again for each job. */
enum { BAND_PIXELS = 1 << 19, JOB_PIXELS = 1 << 13, RAY_JOB_PIXELS = 1 << 11, RAY_JOBS = 120 };

/* Sizes with --resume. A signal loses at most one band, so a band is a small part of the picture, or quickly drawn. */
enum { KEPT_PIXELS = 1 << 14, KEPT_BANDS = 64, KEPT_JOBS = 16 };

static struct tia_tile tile_of(const struct picture *picture, const struct picture_band *band)
{
    struct rotation back = rotation_inverse(&picture->rotation);
    struct tia_tile rows = {0, (uint16_t)band->y, (uint16_t)picture->width, (uint16_t)band->rows};
    return rotation_tile(&back, rows);
}

/* ---- jobs ---- */

/* Converts colours of 16 bits to the file's format, in place. Values of 8 bits are 65535/255 = 257 apart. */
static const unsigned char *colour_bytes(uint16_t *colours, size_t count, unsigned depth)
{
    unsigned char *bytes = (unsigned char *)colours;

    for (size_t i = 0; i < count; i++) {
        unsigned colour = colours[i];
        if (depth == 8) {
            bytes[i] = (unsigned char)((colour + 128) / 257);
        } else {
            bytes[2 * i] = (unsigned char)(colour >> 8);
            bytes[2 * i + 1] = (unsigned char)(colour & 255);
        }
    }
    return bytes;
}

/* Gives a band of RGB565 to the tap. */
static void tap_pixels(struct picture *picture, const struct picture_band *band)
{
    for (unsigned i = 0; picture->tap && i < band->rows; i++) {
        size_t length = image_put565(picture->row, band->pixels + (size_t)i * picture->width, picture->width);
        tap_rows(picture->tap, picture->frame, band->y + i, 1, picture->row, length);
    }
}

/* Writes colours of 16 bits as floats, 0..1, little-endian. */
static int write_floats(struct picture *picture, const struct picture_band *band)
{
    size_t count = (size_t)3 * picture->width;
    int status = TIA_OK;

    for (unsigned y = 0; y < band->rows && !status; y++) {
        for (size_t i = 0; i < count; i++)
            (void)put_float_bytes(picture->floats + 4 * i, (float)band->colours[y * count + i] / 65535);
        tap_rows(picture->tap, picture->frame, band->y + y, 1, picture->floats, 4 * count);
        status = picture->image ? image_rows(picture->image, picture->floats, 1) : TIA_OK;
    }
    return status;
}

static int write_colours(struct picture *picture, const struct picture_band *band)
{
    size_t length = (size_t)picture->width * 3 * picture->depth / 8;

    if (picture->depth == 32)
        return write_floats(picture, band);
    const unsigned char *bytes = colour_bytes(band->colours, (size_t)band->rows * picture->width * 3, picture->depth);
    tap_rows(picture->tap, picture->frame, band->y, band->rows, bytes, length);
    return picture->image ? image_rows(picture->image, bytes, band->rows) : TIA_OK;
}

static bool is_bottom_up(const struct picture *picture)
{
    return picture->image && image_bottom_up(picture->image);
}

static void write_band(struct picture *picture, const struct picture_band *band)
{
    size_t count = (size_t)band->rows * picture->width;
    if (band->colours) {
        int status = write_colours(picture, band);
        if (status)
            atomic_store(&picture->status, status);
        return;
    }
    tap_pixels(picture, band);
    if (picture->checksum && is_bottom_up(picture))
        picture->crc = crc_join(tia_crc32(0, band->pixels, count), picture->crc, picture->crc_bytes);
    else if (picture->checksum)
        picture->crc = tia_crc32(picture->crc, band->pixels, count);
    picture->crc_bytes += count * sizeof *band->pixels;
    int status = picture->image ? image_band(picture->image, band->pixels, band->rows) : TIA_OK;
    if (status)
        atomic_store(&picture->status, status);
}

/* Returns the tile of a job: some rows of the picture; but a row of the file if a tap chooses rows. */
static struct tia_tile tile_of_job(const struct picture *picture, unsigned job)
{
    const struct picture_band row = {picture->band[0].y + job, 1, NULL, NULL};
    unsigned first = job * picture->job_rows, left = picture->tile.height - first;
    struct tia_tile tile = picture->tile;
    if (tap_chooses(picture->tap))
        return tile_of(picture, &row);
    tile.y = (uint16_t)(tile.y + first);
    tile.height = (uint16_t)(left < picture->job_rows ? left : picture->job_rows);
    return tile;
}

/* Draws a tile into `pixels`, the memory of its first pixel in the file, whose rows are `pitch` pixels apart. */
static void draw_tile(struct picture *picture, struct tia_tile tile, tia_rgb565 *pixels, size_t pitch,
                      uint16_t *colours)
{
    struct tia_tile place = rotation_tile(&picture->rotation, tile);
    struct tia_surface rows = {
        .pixels = pixels, .step = sizeof(tia_rgb565), .pitch = (ptrdiff_t)(pitch * sizeof(tia_rgb565))};
    struct tia_surface surface = rotation_surface(&picture->rotation, &rows, place.width, place.height);
    struct tia_options pixel_options = picture->pixel_options;

    pixel_options.colours = colours;
    int status = tia_view_draw(picture->view, picture->hits, tile, &surface, &pixel_options);
    if (status)
        atomic_store(&picture->status, status);
}

/* Copies a tile that was drawn beforehand. */
static void copy_tile(const struct survey *survey, size_t number, struct tia_tile place, tia_rgb565 *pixels,
                      size_t pitch, uint16_t *colours)
{
    const tia_rgb565 *from = survey->pixels + number * survey->probe_pixels;
    size_t count = (size_t)place.width * place.height;

    for (unsigned y = 0; y < place.height; y++)
        memcpy(pixels + y * pitch, from + (size_t)y * place.width, place.width * sizeof *pixels);
    if (colours)
        memcpy(colours, survey->colours + 3 * number * survey->probe_pixels, 3 * count * sizeof *colours);
}

static uint64_t work_of(const struct picture *picture, unsigned band, uint64_t pixels)
{
    return picture->survey.probes ? pixels * picture->survey.weights[band] : pixels;
}

static void draw_rows(struct picture *picture, unsigned job)
{
    if (tap_chooses(picture->tap) && !tap_wants(picture->tap, picture->frame, picture->band[0].y + job))
        return;
    struct tia_tile tile = tile_of_job(picture, job);
    struct tia_tile place = rotation_tile(&picture->rotation, tile);
    const struct picture_band *band = &picture->band[0];
    size_t row = (size_t)(place.y - band->y) * picture->width;
    tia_rgb565 *pixels = band->pixels + row + place.x;
    uint16_t *colours = band->colours ? band->colours + 3 * row : NULL;
    ptrdiff_t probe = survey_place(&picture->survey, picture->number, job);

    if (probe >= 0) {
        copy_tile(&picture->survey, (size_t)probe, place, pixels, picture->width, colours);
        return;
    }
    draw_tile(picture, tile, pixels, picture->width, colours);
    progress_add(&picture->progress, work_of(picture, picture->number, (uint64_t)tile.width * tile.height));
}

static void work(void *arg, unsigned index)
{
    struct picture *picture = arg;
    if (index > 0)
        draw_rows(picture, forecast_part(index - 1, picture->jobs));
    else if (picture->band[1].rows > 0)
        write_band(picture, &picture->band[1]);
}

/* ---- the picture ---- */

/* Prepares a band for drawing. */
static int prepare_band(struct picture *picture, const struct picture_band *band)
{
    picture->tile = tile_of(picture, band);
    picture->jobs =
        tap_chooses(picture->tap) ? band->rows : (picture->tile.height + picture->job_rows - 1) / picture->job_rows;
    return tia_hits_init(&picture->hits, picture->hits_memory, picture->hits_bytes, picture->view, picture->tile);
}

static int read_band(struct picture *picture, const struct picture_band *band)
{
    progress_skip(&picture->progress, (uint64_t)band->rows * picture->width);
    return finished_read(picture->finished, picture->frame, band->y, band->rows, band->pixels);
}

static int draw_band(struct picture *picture)
{
    struct picture_band *band = &picture->band[0];
    struct finished *finished = picture->finished;
    bool draws = band->rows > 0,
         known = draws && finished && finished_has(finished, picture->frame, band->y, band->rows);
    picture->jobs = 0;
    int status = known ? read_band(picture, band) : draws ? prepare_band(picture, band) : TIA_OK;
    if (status)
        return status;
    threads_run(picture->pool, work, picture, picture->jobs + 1);
    status = atomic_load(&picture->status);
    if (!status && draws && !known && finished)
        status = finished_append(finished, picture->frame, band->y, band->rows, band->pixels);

    struct picture_band written = picture->band[1];
    picture->band[1] = picture->band[0];
    picture->band[0] = written;
    return status;
}

/* ---- the survey ---- */

/* Returns a band, counted from the top. */
static struct picture_band band_at(const struct picture *picture, unsigned number)
{
    unsigned first = number * picture->band_rows, left = picture->rows - first;
    struct picture_band band = picture->band[0];

    band.y = picture->first_row + first;
    band.rows = left < picture->band_rows ? left : picture->band_rows;
    return band;
}

static void draw_probe(void *arg, unsigned probe)
{
    struct picture *picture = arg;
    struct survey *survey = &picture->survey;
    struct tia_tile tile = tile_of_job(picture, forecast_probe(probe));
    size_t number = (size_t)picture->number * survey->probes + probe;
    uint64_t begun = survey_clock();

    draw_tile(picture, tile, survey->pixels + number * survey->probe_pixels,
              rotation_tile(&picture->rotation, tile).width,
              survey->colours ? survey->colours + 3 * number * survey->probe_pixels : NULL);
    survey->ns[number] = survey_clock() - begun;
    progress_add(&picture->progress, (uint64_t)tile.width * tile.height);
}

/* Draws the probes of a band; *done and *all receive the work of the probes and of the band. */
static int survey_band(struct picture *picture, unsigned number, uint64_t *done, uint64_t *all)
{
    struct picture_band band = band_at(picture, number);
    int status = prepare_band(picture, &band);
    unsigned probes = forecast_probes(picture->jobs);
    uint64_t pixels = 0;

    if (status)
        return status;
    picture->number = number;
    threads_run(picture->pool, draw_probe, picture, probes);
    for (unsigned i = 0; i < probes; i++) {
        struct tia_tile tile = tile_of_job(picture, forecast_probe(i));
        pixels += (uint64_t)tile.width * tile.height;
    }
    survey_weigh(&picture->survey, number, probes, pixels);
    *done = work_of(picture, number, pixels);
    *all = work_of(picture, number, (uint64_t)band.rows * picture->width);
    return atomic_load(&picture->status);
}

/* Draws the probes of all bands if the progress is shown. One picture of several bands needs them. Where rows are
 * known, or a tap chooses them, the share of pixels is the measure; in a film, that of frames. */
static int survey_bands(struct picture *picture, unsigned count)
{
    const struct progress *progress = &picture->progress;
    unsigned tile_rows = tile_of(picture, &(struct picture_band){.rows = picture->band_rows}).height;
    unsigned parts = (tile_rows + picture->job_rows - 1) / picture->job_rows;
    size_t pixels = (size_t)picture->band_rows * picture->width / tile_rows * picture->job_rows;
    uint64_t done = 0, all = 0, some, band;
    int status = TIA_OK;

    if (!progress_shows(progress) || progress->frames > 1 || count < 2 || tap_chooses(picture->tap) ||
        picture->finished || !survey_begin(&picture->survey, count, parts, pixels, picture->depth != 0))
        return TIA_OK;
    for (unsigned i = 0; i < count && !status; i++) {
        status = survey_band(picture, i, &some, &band);
        done += some;
        all += band;
    }
    if (!status)
        progress_weigh(&picture->progress, done, all);
    return status;
}

/* Draws all bands in the file's order. Each round also writes the band drawn in the previous round; the last round only
 * writes. */
int picture_draw(struct picture *picture)
{
    unsigned count = (picture->rows + picture->band_rows - 1) / picture->band_rows;
    picture->crc = 0;
    picture->crc_bytes = 0;
    progress_start(&picture->progress);
    int status = survey_bands(picture, count);
    for (unsigned i = 0; i <= count && !status; i++) {
        struct picture_band *band = &picture->band[0];
        band->rows = 0;
        if (i < count) {
            picture->number = is_bottom_up(picture) ? count - 1 - i : i;
            *band = band_at(picture, picture->number);
            band->rows = tap_wants_any(picture->tap, picture->frame, band->y, band->rows) ? band->rows : 0;
        }
        status = draw_band(picture);
    }
    return status;
}

/* ---- memory ---- */

static unsigned band_pixels(const struct options *options, const struct image_film *film)
{
    unsigned part = film->width * film->rows / KEPT_BANDS;
    if (!options->resume || part > BAND_PIXELS)
        return BAND_PIXELS;
    return part < KEPT_PIXELS ? (unsigned)KEPT_PIXELS : part;
}

static bool allocate_bands(struct picture *picture)
{
    size_t pixels = (size_t)picture->band_rows * picture->width;
    picture->row = malloc(picture->width * sizeof(tia_rgb565));
    bool has = picture->row;

    for (unsigned i = 0; i < 2; i++) {
        struct picture_band *band = &picture->band[i];
        band->pixels = malloc(pixels * sizeof *band->pixels);
        band->colours = picture->depth ? malloc(3 * pixels * sizeof *band->colours) : NULL;
        has = has && band->pixels && (band->colours || !picture->depth);
    }
    picture->floats = picture->depth == 32 ? malloc((size_t)12 * picture->width) : NULL;
    return has && (picture->floats || picture->depth != 32);
}

int picture_begin(struct picture *picture, const struct options *options, const struct image_film *film)
{
    const struct tia_core *core = options->core;
    *picture = (struct picture){.core = core,
                                .pixel_options = {.dither = options->dither},
                                .rotation = film_rotation(options),
                                .width = film->width,
                                .first_row = film->first_row,
                                .rows = film->rows,
                                .depth = options->depth_bits,
                                .tap = options->tap,
                                .checksum = options->checksum};
    unsigned pixels = band_pixels(options, film), part = pixels / KEPT_JOBS;
    bool rays = options->scene.shadows == TIA_SHADOWS_TRACED;
    unsigned most = rays ? RAY_JOB_PIXELS : JOB_PIXELS, job_pixels = options->resume && part < most ? part : most;
    picture->band_rows = pixels / film->width < film->rows ? pixels / film->width : film->rows;

    struct picture_band whole = {0, picture->band_rows, NULL, NULL};
    struct tia_tile tile = tile_of(picture, &whole);
    picture->job_rows = tile.width < job_pixels ? job_pixels / tile.width : 1;
    if (rays && picture->job_rows > tile.height / RAY_JOBS)
        picture->job_rows = tile.height > RAY_JOBS ? tile.height / RAY_JOBS : 1;
    picture->hits_bytes = core->hits_size(core, &options->scene, tile);
    picture->hits_memory = malloc(picture->hits_bytes);
    bool has = allocate_bands(picture);
    picture->pool = threads_create(options->threads);
    progress_begin(&picture->progress, options, (uint64_t)film->width * film->rows, film->frames);
    return has && picture->hits_memory && picture->pool ? TIA_OK : TIA_ERR_MEMORY;
}

void picture_end(struct picture *picture)
{
    progress_end(&picture->progress);
    survey_end(&picture->survey);
    threads_destroy(picture->pool);
    for (unsigned i = 0; i < 2; i++) {
        free(picture->band[i].pixels);
        free(picture->band[i].colours);
    }
    free(picture->row);
    free(picture->floats);
    free(picture->hits_memory);
}
