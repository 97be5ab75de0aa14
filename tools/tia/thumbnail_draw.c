/* thumbnail_draw.c - a process that draws a thumbnail: 1/64 of its pixels, one sample a pixel, then several. */
#include <stdlib.h>
#include <string.h>
#include <tia/tone.h>
#include <unistd.h>

#include "arguments.h"
#include "arithmetic.h"
#include "clock.h"
#include "common/image/sums.h"
#include "common/scene/model/model.h"
#include "common/scene/whole_file.h"
#include "common/thread_pool.h"
#include "confine.h"
#include "estimation.h"
#include "fail.h"
#include "file_door.h"
#include "thumbnail_page.h"

/* Bounds. Above FACES_MOST, preparing the vector units takes longer than drawing without them. */
enum { MEMORY_MIB = 2048, THREADS_MOST = 8, FACES_MOST = 50000, ROWS = 4 };

/* Samples a pixel of integrators: a picture is shown after each number, from the second on denoised. */
enum { SAMPLES_ONE = 1, SAMPLES_FEW = 4, SAMPLES_ALL = 16, COARSE = 8 };

struct drawer {
    struct options *options;
    struct thumbnail_page *page;
    struct threads *pool;
    struct estimation e;
    uint64_t end_us;
    uint64_t took_us;       /* time that the pixels of the last picture took */
    unsigned coarse, fine;  /* each drawn pixel makes coarse^2 of the thumbnail's, or fine^2 make one */
    unsigned columns, rows; /* drawn pixels */
    unsigned first, step;   /* rows of pixels to be drawn next: first, first + step, ... */
    tia_rgb565 *pixels;     /* drawn by vector units, dithered; or */
    uint16_t *colours;      /* drawn without */
    struct tia_hits *hits;
    struct tia_gathered gathered;
    uint32_t done, round; /* samples drawn, and samples to be added */
    struct denoising denoising;
};

static unsigned char *next_picture(const struct drawer *d)
{
    return d->page->rgb[atomic_load(&d->page->drawn) % 2];
}

static void show(struct drawer *d, uint64_t begun_us)
{
    atomic_fetch_add(&d->page->drawn, 1);
    d->took_us = clock_now_us() - begun_us;
}

/* True if there is time for a picture of `times` as many pixels or samples as the last. */
static bool has_time(const struct drawer *d, unsigned times)
{
    return clock_now_us() + d->took_us * times < d->end_us;
}

/* ---- pictures of rays, spans and the rasteriser ---- */

/* Returns how many rows a job draws: those of a tile. */
static unsigned rows_of_job(const struct drawer *d)
{
    return d->step == 1 ? ROWS : 1;
}

static void draw_rows(void *arg, unsigned job)
{
    struct drawer *d = arg;
    unsigned y = d->first + job * rows_of_job(d) * d->step;
    unsigned rows = d->rows - y < rows_of_job(d) ? d->rows - y : rows_of_job(d);
    size_t at = (size_t)y * d->columns;
    const struct tia_tile tile = {0, (uint16_t)y, (uint16_t)d->columns, (uint16_t)rows};
    const struct tia_surface surface = {
        .pixels = d->pixels + at, .step = sizeof *d->pixels, .pitch = (ptrdiff_t)(d->columns * sizeof *d->pixels)};
    const struct tia_options how = {.dither = !d->colours, .colours = d->colours ? d->colours + 3 * at : NULL};
    int status = tia_view_draw(d->e.film_scene.view, d->hits, tile, &surface, &how);

    if (status)
        atomic_store(&d->e.status, status);
}

/* Adds a drawn pixel, 0..65535 a channel. */
static void add_pixel(const struct drawer *d, size_t at, unsigned sum[3])
{
    if (d->colours) {
        for (unsigned c = 0; c < 3; c++)
            sum[c] += d->colours[3 * at + c];
        return;
    }
    unsigned pixel = d->pixels[at];
    sum[0] += (pixel >> 11) * 65535u / 31;
    sum[1] += (pixel >> 5 & 63u) * 65535u / 63;
    sum[2] += (pixel & 31u) * 65535u / 31;
}

/* Reduces, or enlarges, drawn pixels to a row of the thumbnail. */
static void put_row(void *arg, unsigned y)
{
    struct drawer *d = arg;
    unsigned count = (d->first + 1 < d->step ? d->first + 1 : d->fine) * d->fine;
    unsigned char *to = next_picture(d) + (size_t)3 * y * d->page->width;

    for (unsigned x = 0; x < d->page->width; x++) {
        unsigned sum[3] = {0};
        for (unsigned i = 0; i < count; i++) {
            unsigned column = x / d->coarse * d->fine + i % d->fine, row = y / d->coarse * d->fine + i / d->fine;
            add_pixel(d, (size_t)row * d->columns + column, sum);
        }
        for (unsigned c = 0; c < 3; c++)
            *to++ = (unsigned char)((sum[c] / count + 128) / 257);
    }
}

/* Prepares a view of columns x rows pixels. */
static int begin_view(struct drawer *d)
{
    d->options->width = (uint16_t)d->columns;
    d->options->height = (uint16_t)d->rows;
    d->e.film_scene = (struct film_scene){.job = {.stop = NULL}};
    int status = film_scene_begin(&d->e.film_scene, d->options, d->e.why);
    return status ? status : film_scene_update(&d->e.film_scene, 0);
}

static int begin_hits(struct drawer *d, void **memory)
{
    const struct tia_core *core = d->options->core;
    const struct tia_tile all = {0, 0, (uint16_t)d->columns, (uint16_t)d->rows};
    size_t pixels = (size_t)d->columns * d->rows, size = core->hits_size(core, &d->options->scene, all);

    *memory = malloc(size);
    d->pixels = malloc(pixels * sizeof *d->pixels);
    d->colours = d->options->simd ? NULL : malloc(3 * pixels * sizeof *d->colours);
    if (!*memory || !d->pixels || (!d->options->simd && !d->colours))
        return TIA_ERR_MEMORY;
    return tia_hits_init(&d->hits, *memory, size, d->e.film_scene.view, all);
}

/* Prepares a picture. *memory receives the memory of the hits. */
static int begin_picture(struct drawer *d, unsigned coarse, unsigned fine, void **memory)
{
    d->coarse = coarse;
    d->fine = fine;
    d->columns = (d->page->width + coarse - 1) / coarse * fine;
    d->rows = (d->page->height + coarse - 1) / coarse * fine;
    int status = begin_view(d);
    return status ? status : begin_hits(d, memory);
}

static void end_picture(struct drawer *d, void *memory)
{
    free(memory);
    free(d->pixels);
    free(d->colours);
    film_scene_end(&d->e.film_scene);
}

/* Draws the rows first, first + step, ..., then shows the picture. */
static int add_rows(struct drawer *d, unsigned first, unsigned step)
{
    uint64_t begun_us = clock_now_us();

    d->first = first;
    d->step = step;
    unsigned each = rows_of_job(d) * step;
    threads_run(d->pool, draw_rows, d, (d->rows - first + each - 1) / each);
    int status = atomic_load(&d->e.status);
    if (!status)
        threads_run(d->pool, put_row, d, d->page->height);
    if (!status)
        show(d, begun_us);
    return status;
}

static int draw_picture(struct drawer *d, unsigned coarse, unsigned fine)
{
    void *memory = NULL;
    int status = begin_picture(d, coarse, fine, &memory);

    status = status ? status : add_rows(d, 0, 1);
    end_picture(d, memory);
    return status;
}

/* Draws 2 samples a pixel, then 2 more: the upper and the lower half of each. */
static int draw_halves(struct drawer *d)
{
    void *memory = NULL;
    int status = begin_picture(d, 1, 2, &memory);

    status = status ? status : add_rows(d, 0, 2);
    if (!status && has_time(d, 1))
        status = add_rows(d, 1, 2);
    end_picture(d, memory);
    return status;
}

static bool is_large(const struct tia_scene *scene)
{
    uint64_t count = (uint64_t)scene->sphere_count + scene->shape_count;

    for (uint32_t i = 0; i < scene->mesh_count; i++)
        count += scene->meshes[i].face_count;
    return count > FACES_MOST;
}

/* Draws 4 samples a pixel, 16 where vector units draw, whose pixels have fewer bits and take less time. A large scene
 * has one view without vector units: to prepare it takes longer than to draw. */
static int draw_pictures(struct drawer *d)
{
    if (is_large(&d->options->scene)) {
        d->options->simd = NULL;
        return draw_halves(d);
    }
    unsigned fine = d->options->simd ? 4 : 2;
    int status = draw_picture(d, COARSE, 1);
    if (!status)
        status = draw_picture(d, 1, 1);
    if (!status && has_time(d, fine * fine))
        status = draw_picture(d, 1, fine);
    return status;
}

/* ---- pictures of samples ---- */

static struct tia_gathered row_at(const struct drawer *d, unsigned y)
{
    return gathered_at(&d->gathered, (size_t)y * d->columns);
}

static void gather_row(void *arg, unsigned y)
{
    struct drawer *d = arg;
    const struct tia_tile row = {0, (uint16_t)y, (uint16_t)d->columns, 1};
    const struct tia_gathered to = row_at(d, y);
    int status = d->e.estimator->gather(d->e.film_scene.view, row, d->done, d->done + d->round, &to);

    if (status)
        atomic_store(&d->e.status, status);
}

static void give_row(void *arg, unsigned y)
{
    struct drawer *d = arg;
    const struct tia_gathered row = row_at(d, y);

    denoising_put(&d->denoising, y, &row);
}

static void develop_row(void *arg, unsigned y)
{
    const struct drawer *d = arg;
    struct tia_sum sums[THUMBNAIL_MAX];

    if (d->done < SAMPLES_FEW)
        memcpy(sums, row_at(d, y).sums, d->columns * sizeof *sums);
    else
        denoising_get(&d->denoising, y, sums);
    sums_develop(d->e.bytes + (size_t)3 * y * d->columns, &d->e.sums, sums, 8);
}

static void enlarge_row(void *arg, unsigned y)
{
    const struct drawer *d = arg;
    const unsigned char *from = d->e.bytes + (size_t)3 * (y / d->coarse) * d->columns;
    unsigned char *to = next_picture(d) + (size_t)3 * y * d->page->width;

    for (unsigned x = 0; x < d->page->width; x++, to += 3)
        memcpy(to, from + (size_t)3 * (x / d->coarse), 3);
}

/* Adds samples until each pixel has `count`, and shows them. */
static int add_samples(struct drawer *d, uint32_t count)
{
    uint64_t begun_us = clock_now_us();

    d->round = count - d->done;
    threads_run(d->pool, gather_row, d, d->rows);
    int status = atomic_load(&d->e.status);
    d->e.sums.count = d->done = count;
    if (!status && count >= SAMPLES_FEW) {
        status = denoising_begin(&d->denoising, &d->e);
        threads_run(d->pool, give_row, d, status ? 0 : d->rows);
        if (!status)
            denoising_filter(&d->denoising);
    }
    if (!status) {
        threads_run(d->pool, develop_row, d, d->rows);
        threads_run(d->pool, enlarge_row, d, d->page->height);
        show(d, begun_us);
    }
    denoising_end(&d->denoising);
    return status;
}

/* Prepares a picture of columns x rows pixels without samples. */
static int begin_samples(struct drawer *d, unsigned coarse)
{
    const struct tia_integration *how = &d->options->scene.integration;

    d->coarse = coarse;
    d->columns = (d->page->width + coarse - 1) / coarse;
    d->rows = (d->page->height + coarse - 1) / coarse;
    d->done = 0;
    d->e.film = (struct image_film){.width = d->columns, .height = d->rows, .depth = 8};
    d->e.sums =
        (struct sums){.width = d->columns, .height = d->rows, .tone = tia_tone_of(how), .exposure = how->exposure};
    size_t pixels = (size_t)d->columns * d->rows;
    d->e.bytes = malloc(3 * pixels);
    d->gathered = (struct tia_gathered){.sums = calloc(pixels, sizeof *d->gathered.sums),
                                        .guides = calloc(pixels, sizeof *d->gathered.guides),
                                        .squares = calloc(pixels, sizeof *d->gathered.squares),
                                        .pitch = d->columns};
    bool has = d->e.bytes && d->gathered.sums && d->gathered.guides && d->gathered.squares;
    return has ? begin_view(d) : TIA_ERR_MEMORY;
}

static void end_samples(struct drawer *d)
{
    film_scene_end(&d->e.film_scene);
    free(d->e.bytes);
    free(d->gathered.sums);
    free(d->gathered.guides);
    free(d->gathered.squares);
}

static int draw_samples(struct drawer *d)
{
    int status = begin_samples(d, COARSE);
    status = status ? status : add_samples(d, SAMPLES_FEW);
    end_samples(d);
    if (status)
        return status;
    status = begin_samples(d, 1);
    status = status ? status : add_samples(d, SAMPLES_ONE);
    if (!status && has_time(d, SAMPLES_FEW - SAMPLES_ONE))
        status = add_samples(d, SAMPLES_FEW);
    if (!status && d->done == SAMPLES_FEW && has_time(d, (SAMPLES_ALL - SAMPLES_FEW) / (SAMPLES_FEW - SAMPLES_ONE)))
        status = add_samples(d, SAMPLES_ALL);
    end_samples(d);
    return status;
}

/* ---- the process ---- */

/* Presses the first key of a scene that has no other light. */
static int light_up(struct options *options)
{
    const struct tia_scene *scene = &options->scene;

    if (scene->light_count || !scene->binding_count || options->keys)
        return EXIT_FINE;
    options->keys = malloc(sizeof *options->keys);
    if (!options->keys)
        return fail(EXIT_RUNNING, "memory: exhausted");
    options->keys[options->key_count++] = scene->bindings[0].key;
    return EXIT_FINE;
}

static int draw(struct drawer *d)
{
    struct options *options = d->options;

    d->page->width = options->width;
    d->page->height = options->height;
    d->e.options = options;
    d->e.estimator = arithmetic_estimator(options->core);
    d->pool = d->e.pool = threads_create(options->threads);
    int status = !d->pool                                               ? TIA_ERR_MEMORY
                 : options->scene.integration.integrator == TIA_WHITTED ? draw_pictures(d)
                                                                        : draw_samples(d);
    return status ? fail(status == TIA_ERR_RANGE ? EXIT_USAGE : EXIT_RUNNING, "%s",
                         d->e.why[0] ? d->e.why : fail_reason(status))
                  : EXIT_FINE;
}

_Noreturn void thumbnail_draw(struct options *options, struct thumbnail_page *page, int socket, uint64_t end_us)
{
    static struct drawer d;
    unsigned seconds = (unsigned)((end_us - clock_now_us()) / 1000000 + 1);

    fail_into(page->why, sizeof page->why);
    options->threads = options->threads < THREADS_MOST ? options->threads : (uint32_t)THREADS_MOST;
    options->time_limit = 0;
    options->samples = options->samples ? options->samples : 1; /* pictures of more pixels have the others */
    whole_open_by(file_door_open, &socket);
    if (options->scene_format == SCENE_MODEL)
        model_confine();
    if (!confine_descriptors(socket))
        page->status = fail(EXIT_RUNNING, "/dev/null: cannot be opened");
    (void)confine((uint64_t)MEMORY_MIB << 20, seconds * options->threads);
    page->status = page->status ? page->status : arguments_load(options);
    page->status = page->status ? page->status : light_up(options);
    d = (struct drawer){.options = options, .page = page, .end_us = end_us};
    page->status = page->status ? page->status : draw(&d);
    atomic_store(&page->ended, true);
    _exit(EXIT_FINE);
}
