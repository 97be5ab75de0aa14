/* rounds.c - draws a picture in rounds, one or a few samples of each pixel at a time, so that it can end after any
 * round. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/debug.h>

#include "clock.h"
#include "common/forecast.h"
#include "common/image/image.h"
#include "common/signals.h"
#include "estimation.h"
#include "fail.h"
#include "pixels/pages.h"

/* Sizes and times. The samples of a picture of up to PIXELS_MAX pixels are in memory twice: those of the complete
 * rounds, and those including the round being drawn. A round of a small picture has several samples per pixel, so that
 * threads have enough work. Fewer than SPREAD_MIN samples give no estimate of their spread. After a signal the picture
 * must be complete within 0.2 s, on a slow processor too: denoising SMALL_PIXELS pixels takes up to 0.1 s. */
enum { PIXELS_MAX = 1 << 24, ROUND_PIXELS = 1 << 12, SPREAD_MIN = 8, TOLD_US = 500000, SMALL_PIXELS = 1 << 15 };

struct gathered {
    struct tia_gathered all;
    void *memory;
};

struct rounds {
    struct estimation *e;
    size_t pixels;
    struct gathered kept, next;
    uint32_t done, round; /* number of samples in `kept`, and number to be added */
    uint64_t begun_us, told_us;
    double error; /* the estimated error; negative: none yet */
    struct row_error *row_errors;
    struct denoising *denoising;
};

/* Sums over the pixels of a row: of standard errors, and of luminance, both in units of 2^-16. */
struct row_error {
    uint64_t errors, light;
};

bool rounds_possible(const struct estimation *e)
{
    return !e->options->resume && !tap_chooses(e->options->tap) &&
           (uint64_t)e->film.width * e->film.height <= PIXELS_MAX;
}

/* ---- memory ---- */

static bool watched(const struct estimation *e)
{
    return e->progress.terminal || e->progress.asked;
}

/* True if sums of squares are needed: for the denoiser, or to estimate the error as a limit or for a message. */
static bool has_squares(const struct estimation *e)
{
    return e->sums.guided || e->options->error || e->options->time_limit || watched(e);
}

static size_t pixels_of(const struct estimation *e)
{
    return (size_t)e->film.width * e->film.height;
}

/* Returns the size of one of the two copies of the samples. */
static size_t gathered_size(const struct estimation *e)
{
    size_t guide = e->sums.guided ? sizeof(struct tia_guide) : 0, square = has_squares(e) ? sizeof(uint64_t) : 0;

    return pixels_of(e) * (sizeof(struct tia_sum) + guide + square);
}

size_t rounds_size(const struct estimation *e)
{
    return 2 * gathered_size(e);
}

static bool get_memory(struct gathered *g, const struct rounds *r)
{
    bool guides = r->e->sums.guided;
    size_t sums = r->pixels * sizeof *g->all.sums, more = guides ? r->pixels * sizeof *g->all.guides : 0;

    g->memory = pages_alloc(gathered_size(r->e));
    g->all.sums = g->memory;
    g->all.guides = guides ? (void *)((char *)g->memory + sums) : NULL;
    g->all.squares = has_squares(r->e) ? (void *)((char *)g->memory + sums + more) : NULL;
    g->all.pitch = r->e->film.width;
    return g->memory;
}

/* True if a signal has come and optional steps must be left out, so that the picture is complete in time. */
static bool hurries(const struct rounds *r)
{
    return r->pixels > SMALL_PIXELS && signals_asked(NULL);
}

static void estimate_row(void *arg, unsigned y)
{
    struct rounds *r = arg;
    struct tia_gathered row = gathered_at(&r->kept.all, (size_t)y * r->e->film.width);
    struct row_error *sum = &r->row_errors[y];
    bool late = hurries(r);

    *sum = (struct row_error){0, 0};
    for (size_t x = 0; x < r->e->film.width && !late; x++) {
        const struct tia_sum *s = &row.sums[x];
        sum->errors += tia_standard_error(s, row.squares[x], r->done);
        sum->light += (uint64_t)(s->rgb[0] + 2 * s->rgb[1] + s->rgb[2]) / 4 / r->done >> 8;
    }
}

/* Returns the mean of the pixels' standard errors divided by the mean of their luminance; -1: there is no time to
 * compute it. */
static double estimated_error(struct rounds *r)
{
    struct row_error all = {0, 0};

    threads_run(r->e->pool, estimate_row, r, r->e->film.height);
    for (unsigned y = 0; y < r->e->film.height; y++) {
        all.errors += r->row_errors[y].errors;
        all.light += r->row_errors[y].light;
    }
    return hurries(r) ? -1 : all.light ? (double)all.errors / (double)all.light : 0;
}

/* ---- a round ---- */

/* Copies the samples so far into a row of the next round; clears the row in the first round. */
static void begin_row(const struct rounds *r, size_t place, const struct tia_gathered *to)
{
    const struct tia_gathered from = gathered_at(&r->kept.all, place);
    size_t width = r->e->film.width;

    if (r->done == 0) {
        memset(to->sums, 0, width * sizeof *to->sums);
        if (to->squares)
            memset(to->squares, 0, width * sizeof *to->squares);
        if (to->guides)
            memset(to->guides, 0, width * sizeof *to->guides);
        return;
    }
    memcpy(to->sums, from.sums, width * sizeof *to->sums);
    if (to->squares)
        memcpy(to->squares, from.squares, width * sizeof *to->squares);
    if (to->guides)
        memcpy(to->guides, from.guides, width * sizeof *to->guides);
}

/* Draws a row. Once a row was stopped the round is invalid, so the remaining rows are not drawn. */
static void draw_row(void *arg, unsigned index)
{
    struct rounds *r = arg;
    struct estimation *e = r->e;
    unsigned y = forecast_part(index, e->film.height);
    size_t width = e->film.width, place = y * width;
    struct tia_gathered to = gathered_at(&r->next.all, place);
    struct tia_tile row = {0, (uint16_t)y, (uint16_t)width, 1};
    uint32_t first = e->sums.first + r->done;

    if (atomic_load(&e->status))
        return;
    begin_row(r, place, &to);
    int status = e->estimator->gather(e->film_scene.view, row, first, first + r->round, &to);
    if (status)
        atomic_store(&e->status, status);
    progress_add(&e->progress, width * r->round);
}

static int draw_round(struct rounds *r)
{
    struct gathered kept = r->next;

    threads_run(r->e->pool, draw_row, r, r->e->film.height);
    if (atomic_load(&r->e->status))
        return atomic_load(&r->e->status);
    r->next = r->kept;
    r->kept = kept;
    r->done += r->round;
    return TIA_OK;
}

/* ---- messages ---- */

/* Returns the estimated seconds until the first limit is reached. */
static double seconds_left(const struct rounds *r, uint64_t now)
{
    double took = (double)(now - r->begun_us) / 1e6, each = took / r->done,
           limit = (double)r->e->options->error / 65536;
    double left = each * (r->e->sums.count - r->done), by_error;

    if (r->e->end_us != UINT64_MAX && (double)(r->e->end_us - now) / 1e6 < left)
        left = (double)(r->e->end_us - now) / 1e6;
    if (limit > 0 && r->error >= 0) {
        by_error = took * (r->error * r->error / (limit * limit) - 1);
        left = by_error < left ? by_error : left;
    }
    return left > 0 ? left : 0;
}

/* Shows the samples and, if the time or the error is limited, the time left until that limit; otherwise the rows that
 * are drawn tell it. */
static void tell(struct rounds *r, uint64_t now)
{
    char text[PROGRESS_TEXT];
    bool limited = r->e->options->time_limit || r->e->options->error;
    double left = limited ? seconds_left(r, now) : -1, took = (double)(now - r->begun_us) / 1e6;
    int used = snprintf(text, sizeof text, "%u", (unsigned)r->done);

    if (r->e->sums.count < TIA_SPP_MAX)
        used += snprintf(text + used, sizeof text - (size_t)used, " of %u", (unsigned)r->e->sums.count);
    used += snprintf(text + used, sizeof text - (size_t)used, " samples");
    if (r->error >= 0)
        (void)snprintf(text + used, sizeof text - (size_t)used, ", error %.4f", r->error);
    progress_say(&r->e->progress, text, limited ? took / (took + left + 1e-6) : -1, left);
}

/* Shows the state of the drawing. Estimates the error only if it is a limit or is shown, since that takes a while. */
static void look(struct rounds *r)
{
    bool tells = watched(r->e);
    uint64_t now = clock_now_us();

    if (r->done < SPREAD_MIN || (!r->e->options->error && (!tells || now < r->told_us))) {
        if (tells && r->done < SPREAD_MIN)
            tell(r, now);
        return;
    }
    r->told_us = now + TOLD_US;
    r->error = estimated_error(r);
    if (tells)
        tell(r, now);
}

static bool is_good(const struct rounds *r)
{
    const struct options *options = r->e->options;

    return options->error && r->error >= 0 && r->error * 65536 <= options->error;
}

/* Draws rounds; TIA_STOPPED: no round is complete. */
static int draw(struct rounds *r)
{
    uint32_t count = r->e->sums.count;
    uint32_t most = r->pixels < ROUND_PIXELS ? (uint32_t)(ROUND_PIXELS / r->pixels) : 1;
    int status = TIA_OK;

    while (r->done < count && !is_good(r) && !status) {
        r->round = count - r->done < most ? count - r->done : most;
        status = draw_round(r);
        if (!status)
            look(r);
    }
    return status == TIA_STOPPED && r->done ? TIA_OK : status;
}

/* ---- the file ---- */

/* Rows that are written at once. */
struct rows {
    const struct rounds *r;
    unsigned y, count;
};

static void develop_row(void *arg, unsigned row)
{
    const struct rows *rows = arg;
    struct estimation *e = rows->r->e;

    estimation_develop(e, rows->y, row, rows->r->kept.all.sums + (size_t)(rows->y + row) * e->film.width);
}

static int write_all(const struct rounds *r)
{
    struct estimation *e = r->e;
    unsigned height = e->film.height, band = estimation_band_rows(e), count = (height + band - 1) / band;
    bool bottom_up = e->image && image_bottom_up(e->image);
    int status = estimation_head(e);

    for (unsigned i = 0; i < count && !status; i++) {
        unsigned y = (bottom_up ? count - 1 - i : i) * band;
        struct rows rows = {r, y, height - y < band ? height - y : band};
        threads_run(e->pool, develop_row, &rows, rows.count);
        status = estimation_write(e, rows.y, rows.count);
    }
    return status;
}

static void put_row(void *arg, unsigned y)
{
    const struct rounds *r = arg;
    const struct tia_gathered from = gathered_at(&r->kept.all, (size_t)y * r->e->film.width);

    denoising_put(r->denoising, y, &from);
}

static void get_row(void *arg, unsigned y)
{
    const struct rounds *r = arg;

    denoising_get(r->denoising, y, r->kept.all.sums + (size_t)y * r->e->film.width);
}

static int denoise(struct rounds *r)
{
    struct denoising denoising;
    int status = denoising_begin(&denoising, r->e);

    r->denoising = &denoising;
    if (!status) {
        threads_run(r->e->pool, put_row, r, r->e->film.height);
        denoising_filter(&denoising);
        threads_run(r->e->pool, get_row, r, r->e->film.height);
    }
    denoising_end(&denoising);
    return status;
}

static void guide_row(void *arg, unsigned y)
{
    const struct rounds *r = arg;
    const struct tia_gathered row = gathered_at(&r->kept.all, (size_t)y * r->e->film.width);

    show_guide(r->e, &row);
}

/* Writes the picture. After a signal, a large picture is neither denoised nor compressed. */
static int finish(struct rounds *r)
{
    const struct options *options = r->e->options;
    bool late = hurries(r);
    int status = TIA_OK;

    r->e->sums.count = r->done;
    r->e->unfinished = late && options->denoise;
    if (late && r->e->image)
        image_hurry(r->e->image);
    if (options->denoise && !late)
        status = denoise(r);
    else if (options->guide)
        threads_run(r->e->pool, guide_row, r, r->e->film.height);
    return status ? status : write_all(r);
}

/* Reports the number of samples, which is unpredictable after --time-limit, --error or a signal. */
static void say_samples(struct rounds *r, uint32_t asked)
{
    bool limited = r->e->options->time_limit || r->e->options->error;
    const char *noise = r->e->options->denoise && hurries(r) ? ", not denoised (see --resume)" : "";

    if (r->done == asked && !limited)
        return;
    double error = r->done < SPREAD_MIN || !has_squares(r->e) ? -1
                   : r->error >= 0 && r->e->options->error    ? r->error
                                                              : estimated_error(r);
    progress_erase(&r->e->progress);
    if (error < 0)
        note("%u samples a pixel%s", (unsigned)r->done, noise);
    else
        note("%u samples a pixel, estimated error %.4f%s", (unsigned)r->done, error, noise);
}

static int begin(struct rounds *r)
{
    struct estimation *e = r->e;

    r->row_errors = malloc(e->film.height * sizeof *r->row_errors);
    if (!r->row_errors || !get_memory(&r->kept, r) || !get_memory(&r->next, r))
        return ROUNDS_NO_MEMORY;
    int status = estimation_open(e);
    if (status)
        return status;
    signals_catch_waiting();
    r->begun_us = clock_now_us();
    progress_start(&e->progress);
    progress_weigh(&e->progress, 0, (uint64_t)r->pixels * e->sums.count);
    e->end_us = e->options->time_limit ? r->begun_us + (uint64_t)e->options->time_limit * 1000000 / 65536 : UINT64_MAX;
    return TIA_OK;
}

int rounds_draw(struct estimation *e)
{
    struct rounds r = {.e = e, .pixels = pixels_of(e), .error = -1};
    uint32_t asked = e->sums.count;
    int status = begin(&r);

    if (!status)
        status = draw(&r);
    signals_release(); /* a second signal ends the program at once */
    if (!status) {
        say_samples(&r, asked);
        status = finish(&r);
    }
    free(r.kept.memory);
    free(r.next.memory);
    free(r.row_errors);
    return status;
}
