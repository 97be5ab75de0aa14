#include "checking.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "common/image/series.h"
#include "common/image/stored.h"
#include "common/verify/report.h"
#include "draw.h"
#include "fail.h"
#include "film_plan.h"

struct checking {
    struct options options;
    const char *path;
    bool series;     /* one picture per frame */
    uint32_t opened; /* frame whose picture is open */
    char *name;      /* its name, or that of the only file */
    struct stored stored;
    struct image_film film; /* what the options draw */
    struct choice choice;
    struct report report;
    unsigned char *bytes; /* a stored row */
    bool failed;          /* a row cannot be read: the reason is in `stored` */
};

static int differs(const struct checking *c, const char *what)
{
    report_name(&c->report);
    (void)fprintf(c->report.out, "%s%s\n", what, c->report.from);
    return CHECK_DIFFERS;
}

/* ---- the file ---- */

/* Returns the format of the file, which need not be that of the options: a file of --resume is a part. */
static enum image_format format_of(const struct checking *c)
{
    enum image_format format = image_format_of(c->path);

    return format != IMAGE_UNKNOWN ? format : c->options.format != IMAGE_UNKNOWN ? c->options.format : IMAGE_PART;
}

/* Opens the only file, or the picture of a frame. */
static int open_file(struct checking *c, uint32_t frame)
{
    const struct rotation rotation = film_rotation(&c->options), back = rotation_inverse(&rotation);

    stored_close(&c->stored);
    free(c->name);
    c->opened = frame;
    c->name = c->series ? series_path(c->path, frame) : strdup(c->path);
    if (!c->name) {
        (void)snprintf(c->stored.why, STORED_WHY, "memory: exhausted");
        return -1;
    }
    return stored_open(&c->stored, c->name, format_of(c), back.width, back.height);
}

/* Sets the options for samples to those that the file has. */
static void take_sums(struct options *options, const struct sums *sums)
{
    options->samples_range = true;
    options->first_sample = sums->first;
    options->last_sample = sums->first + sums->count - 1;
    options->format = IMAGE_PART;
    options->resume = NULL;
    options->spp = options->colour = options->guide = 0;
    options->colour_given = options->denoise = false;
    options->time_limit = options->error = 0;
}

/* Completes the options by what the file tells: its size, its samples. */
static void take_file(struct checking *c)
{
    struct options *options = &c->options;
    const struct image_film *film = &c->stored.film;
    bool swaps = rotation_swaps(options->rotate);

    if (!options->width) {
        options->width = (uint16_t)(swaps ? film->height : film->width);
        options->height = (uint16_t)(swaps ? film->width : film->height);
    }
    if (options->format == IMAGE_UNKNOWN)
        options->format = image_format_of(options->output);
    if (options->format == IMAGE_UNKNOWN)
        options->format = format_of(c);
    if (c->stored.is_sums)
        take_sums(options, &c->stored.sums);
    else if (c->stored.is_part && options->format != IMAGE_PART && options->format != IMAGE_Y4M)
        options->resume = c->path; /* so that the scene is hashed, as for the file */
    else
        options->resume = NULL;
}

/* ---- the options ---- */

static int check_options(const struct options *options)
{
    if (options->gazes || options->thumbnail)
        return fail(CHECK_FAILED, "--%s: its pictures are not verified", options->gazes ? "gaze" : "thumbnail");
    if (options->time_limit || options->error)
        return fail(CHECK_FAILED, "--%s: the file does not tell its samples (--spp N instead, as tia said)",
                    options->time_limit ? "time-limit" : "error");
    return CHECK_SAME;
}

/* Compares what the file says of itself with what the options draw. */
static int check_film(const struct checking *c)
{
    const struct image_film *a = &c->stored.film, *b = &c->film;
    char text[120];

    if (a->width != b->width || a->height != b->height) {
        (void)snprintf(text, sizeof text, "is of %ux%u, the options draw %ux%u", a->width, a->height, b->width,
                       b->height);
        return differs(c, text);
    }
    if (!c->stored.is_part)
        return CHECK_SAME;
    if (!c->stored.is_sums &&
        (a->all_frames != b->all_frames || a->rate[0] != b->rate[0] || a->rate[1] != b->rate[1])) {
        (void)snprintf(text, sizeof text, "is of %u frames at %u/%u, the options draw %u at %u/%u",
                       (unsigned)a->all_frames, (unsigned)a->rate[0], (unsigned)a->rate[1], (unsigned)b->all_frames,
                       (unsigned)b->rate[0], (unsigned)b->rate[1]);
        return differs(c, text);
    }
    return a->crc == b->crc ? CHECK_SAME : differs(c, "is of another scene, or drawn with other options");
}

/* Checks that a file of samples has those of the options; before take_sums. */
static int check_samples(const struct checking *c)
{
    const struct options *options = &c->options;
    const struct sums *sums = &c->stored.sums;
    uint32_t first = options->samples_range ? options->first_sample : 0,
             count = options->samples_range ? options->last_sample - first + 1 : options->spp;
    char text[120];

    if (!c->stored.is_sums || !count || (sums->first == first && sums->count == count))
        return CHECK_SAME;
    (void)snprintf(text, sizeof text, "has samples %u to %u, the options draw %u to %u", (unsigned)sums->first,
                   (unsigned)(sums->first + sums->count - 1), (unsigned)first, (unsigned)(first + count - 1));
    return differs(c, text);
}

/* Checks that a part has all rows and frames that the options draw; the file of an interrupted run may lack some. */
static int check_complete(const struct checking *c)
{
    uint64_t rows = (uint64_t)c->film.rows * c->film.frames;
    bool asked = c->options.frame_range || c->options.tile_rows;

    if (!asked || !c->stored.is_part || c->stored.is_sums || stored_rows(&c->stored) == rows)
        return CHECK_SAME;
    return differs(c, "has fewer or other rows than the options draw");
}

static int load(struct checking *c, int argc, char **argv)
{
    struct options *options = &c->options;
    int status = arguments_check(options, argc, argv);

    status = status ? status : arguments_load(options);
    if (!status && options->action != ACTION_DRAW)
        status = fail(CHECK_FAILED, "a file is verified, without options for displays");
    status = status ? status : film_plan(options, &c->film);
    options->resume = NULL;
    options->checksum = options->stats = false;
    return status ? CHECK_FAILED : check_film(c);
}

/* ---- the rows ---- */

static uint64_t count_rows(const struct checking *c)
{
    return c->series ? (uint64_t)c->film.rows * c->film.frames : stored_rows(&c->stored);
}

static void place_of(const void *rows, uint64_t index, uint32_t *frame, unsigned *y)
{
    const struct checking *c = rows;

    if (!c->series) {
        stored_place(&c->stored, index, frame, y);
        return;
    }
    *frame = c->film.first_frame + (uint32_t)(index / c->film.rows);
    *y = (unsigned)(index % c->film.rows);
}

static bool wants(void *ctx, uint32_t frame, unsigned y)
{
    return choice_has(&((struct checking *)ctx)->choice, frame, y);
}

/* Opens the picture of a frame, which must be like the first one. */
static int open_next(struct checking *c, uint32_t frame)
{
    if (!c->series || frame == c->opened)
        return 0;
    if (open_file(c, frame) || stored_depth(&c->stored, c->options.depth_bits))
        return -1;
    if (c->stored.film.width == c->film.width && c->stored.film.height == c->film.height)
        return 0;
    (void)snprintf(c->stored.why, STORED_WHY, "%.300s: of another size", c->name);
    return -1;
}

static void compare_row(void *ctx, uint32_t frame, unsigned y, const unsigned char *bytes, size_t length)
{
    struct checking *c = ctx;
    bool exact;

    if (c->failed)
        return;
    if (open_next(c, frame) || stored_row(&c->stored, frame, y, c->bytes, &exact))
        c->failed = true;
    else
        report_row(&c->report, frame, y, c->bytes, bytes, length, exact);
}

static int draw_again(struct checking *c)
{
    const struct row_tap tap = {wants, compare_row, c, NULL};

    c->options.tap = &tap;
    int status = draw_file(&c->options);
    c->options.tap = NULL;
    if (status)
        return CHECK_FAILED;
    if (c->failed)
        return fail(CHECK_FAILED, "%s", c->stored.why);
    if (c->report.seen != c->choice.count)
        return differs(c, "has rows or frames that the options do not draw");
    return report_end(&c->report, &c->choice) ? CHECK_SAME : CHECK_DIFFERS;
}

static int check_rows(struct checking *c, const struct choice_wish *wish)
{
    if (!c->stored.is_part && stored_depth(&c->stored, c->options.depth_bits))
        return fail(CHECK_FAILED, "%s", c->stored.why);
    c->report.pixels = c->film.width;
    c->report.film = c->film.all_frames > 1;
    c->bytes = malloc(stored_row_bytes(&c->stored));
    if (!c->bytes || choice_make(&c->choice, wish, count_rows(c), place_of, c))
        return fail(CHECK_FAILED, "memory: exhausted");
    if (!c->choice.count)
        return wish->has_rows ? fail(CHECK_FAILED, "--rows %u-%u: none of them is in %.200s", (unsigned)wish->first_row,
                                     (unsigned)wish->last_row, c->path)
                              : fail(CHECK_FAILED, "%.200s: has no complete row", c->path);
    return draw_again(c);
}

static int check_file(struct checking *c, int argc, char **argv, const struct choice_wish *wish)
{
    c->series = series_is_pattern(c->path);
    if (open_file(c, c->options.frame_range ? c->options.first_frame : 0))
        return fail(CHECK_FAILED, "%s", c->stored.why);
    int result = check_samples(c);
    if (result)
        return result;
    take_file(c);
    result = check_options(&c->options);
    result = result ? result : load(c, argc, argv);
    result = result ? result : check_complete(c);
    return result ? result : check_rows(c, wish);
}

int checking_picture(const struct options *options, int argc, char **argv, const char *path, struct checking_wish *wish)
{
    struct checking c = {.options = *options, .path = path, .stored = {.fd = -1}};

    c.report = (struct report){.out = wish->out,
                               .before = wish->before,
                               .quiet = wish->quiet,
                               .name = path,
                               .unit = "rows",
                               .done = "drawn again",
                               .from = wish->from};
    if (!c.options.output)
        c.options.output = path;
    int result = check_file(&c, argc, argv, &wish->choice);
    wish->seen += c.report.seen;
    arguments_free(&c.options);
    stored_close(&c.stored);
    choice_free(&c.choice);
    free(c.name);
    free(c.bytes);
    return result;
}
