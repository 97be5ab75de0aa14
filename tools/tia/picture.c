#include "picture.h"

#include <stdlib.h>
#include <string.h>
#include <tia/debug.h>

#include "common/crc_join.h"
#include "common/image/codec.h"
#include "film_plan.h"

/* Sizes. A band is so large that threads seldom wait for the last job, and so small that its hits, some tens of bytes
 * per pixel, take little memory. A job consists of whole rows, since the core draws row by row. */
enum { BAND_PIXELS = 1 << 19, JOB_PIXELS = 1 << 13 };

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
        for (size_t i = 0; i < count; i++) {
            float value = (float)band->colours[y * count + i] / 65535;
            uint32_t bits;
            memcpy(&bits, &value, sizeof bits);
            for (unsigned k = 0; k < 4; k++)
                picture->floats[4 * i + k] = (unsigned char)(bits >> 8 * k & 255);
        }
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

static void draw_rows(struct picture *picture, unsigned job)
{
    if (tap_chooses(picture->tap) && !tap_wants(picture->tap, picture->frame, picture->band[0].y + job))
        return;
    struct tia_tile tile = tile_of_job(picture, job);
    struct tia_tile place = rotation_tile(&picture->rotation, tile);
    const struct picture_band *band = &picture->band[0];
    struct tia_surface rows = {.pixels = band->pixels + (size_t)(place.y - band->y) * picture->width + place.x,
                               .step = sizeof(tia_rgb565),
                               .pitch = (ptrdiff_t)(picture->width * sizeof(tia_rgb565))};
    struct tia_surface surface = rotation_surface(&picture->rotation, &rows, place.width, place.height);

    struct tia_options pixel_options = picture->pixel_options;
    if (band->colours)
        pixel_options.colours = band->colours + 3 * (size_t)(place.y - band->y) * picture->width;

    int status = tia_view_draw(picture->view, picture->hits, tile, &surface, &pixel_options);
    if (status)
        atomic_store(&picture->status, status);
    progress_add(&picture->progress, (uint64_t)tile.width * tile.height);
}

static void work(void *arg, unsigned index)
{
    struct picture *picture = arg;
    if (index > 0)
        draw_rows(picture, index - 1);
    else if (picture->band[1].rows > 0)
        write_band(picture, &picture->band[1]);
}

/* ---- the picture ---- */

/* Prepares a band for drawing; *jobs receives the number of its jobs. */
static int prepare_band(struct picture *picture, const struct picture_band *band, unsigned *jobs)
{
    picture->tile = tile_of(picture, band);
    *jobs = tap_chooses(picture->tap) ? band->rows : (picture->tile.height + picture->job_rows - 1) / picture->job_rows;
    return tia_hits_init(&picture->hits, picture->hits_memory, picture->hits_bytes, picture->view, picture->tile);
}

static int read_band(struct picture *picture, const struct picture_band *band)
{
    progress_add(&picture->progress, (uint64_t)band->rows * picture->width);
    return finished_read(picture->finished, picture->frame, band->y, band->rows, band->pixels);
}

static int draw_band(struct picture *picture)
{
    struct picture_band *band = &picture->band[0];
    struct finished *finished = picture->finished;
    bool draws = band->rows > 0,
         known = draws && finished && finished_has(finished, picture->frame, band->y, band->rows);
    unsigned jobs = 0;
    int status = known ? read_band(picture, band) : draws ? prepare_band(picture, band, &jobs) : TIA_OK;
    if (status)
        return status;
    threads_run(picture->pool, work, picture, jobs + 1);
    status = atomic_load(&picture->status);
    if (!status && draws && !known && finished)
        status = finished_append(finished, picture->frame, band->y, band->rows, band->pixels);

    struct picture_band written = picture->band[1];
    picture->band[1] = picture->band[0];
    picture->band[0] = written;
    return status;
}

/* Draws all bands in the file's order. Each round also writes the band drawn in the previous round; the last round only
 * writes. */
int picture_draw(struct picture *picture)
{
    unsigned count = (picture->rows + picture->band_rows - 1) / picture->band_rows;
    int status = TIA_OK;
    picture->crc = 0;
    picture->crc_bytes = 0;
    for (unsigned i = 0; i <= count && !status; i++) {
        struct picture_band *band = &picture->band[0];
        band->rows = 0;
        if (i < count) {
            unsigned first = (is_bottom_up(picture) ? count - 1 - i : i) * picture->band_rows;
            unsigned left = picture->rows - first;
            band->y = picture->first_row + first;
            unsigned rows = left < picture->band_rows ? left : picture->band_rows;
            band->rows = tap_wants_any(picture->tap, picture->frame, band->y, rows) ? rows : 0;
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
    unsigned job_pixels = options->resume && part < JOB_PIXELS ? part : (unsigned)JOB_PIXELS;
    picture->band_rows = pixels / film->width < film->rows ? pixels / film->width : film->rows;

    struct picture_band whole = {0, picture->band_rows, NULL, NULL};
    struct tia_tile tile = tile_of(picture, &whole);
    picture->job_rows = tile.width < job_pixels ? job_pixels / tile.width : 1;
    picture->hits_bytes = core->hits_size(core, &options->scene, tile);
    picture->hits_memory = malloc(picture->hits_bytes);
    bool has = allocate_bands(picture);
    picture->pool = threads_create(options->threads);
    progress_begin(&picture->progress, (uint64_t)film->width * film->rows, film->frames, options->progress);
    return has && picture->hits_memory && picture->pool ? TIA_OK : TIA_ERR_MEMORY;
}

void picture_end(struct picture *picture)
{
    progress_end(&picture->progress);
    threads_destroy(picture->pool);
    for (unsigned i = 0; i < 2; i++) {
        free(picture->band[i].pixels);
        free(picture->band[i].colours);
    }
    free(picture->row);
    free(picture->floats);
    free(picture->hits_memory);
}
