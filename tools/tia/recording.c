#include "recording.h"

#include <errno.h>
#include <libgen.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "arguments.h"
#include "common/image/series.h"
#include "common/inputs.h"
#include "common/message.h"
#include "common/record/row_hashes.h"
#include "common/sink.h"
#include "draw.h"
#include "fail.h"
#include "film_plan.h"

struct recording {
    struct options *options;
    struct record record;
    struct row_hashes hashes;
    char *folder;              /* the record's folder, resolved */
    char outside[RECORD_NAME]; /* a file that is not in the folder; empty: none */
    bool exhausted;
    uint32_t samples; /* samples per pixel that were drawn */
};

/* ---- what is recorded ---- */

bool recording_has(const struct option_row *row)
{
    /* on which no pixel depends, or that the record has in other lines */
    static const char *const without[] = {
        "display",   "format", "size",          "time-limit", "error",         "input",    "threads",
        "connector", "mode",   "checksum",      "stats",      "stats-overlay", "progress", "watch",
        "strict",    "help",   "list-displays", "version",    "thumbnail",     "write",    "benchmark"};

    for (unsigned i = 0; i < sizeof without / sizeof *without; i++)
        if (strcmp(row->name, without[i]) == 0)
            return false;
    return !row->argument || strncmp(row->argument, "FILE", 4) != 0;
}

const struct option_row *recording_option(const char *text)
{
    size_t length = strcspn(text, "=");

    for (const struct option_row *row = tia_command.options; row->name; row++)
        if (strlen(row->name) == length && strncmp(row->name, text, length) == 0)
            return row;
    return NULL;
}

/* Adds an option with a text that is not too long. */
static int add_option(struct recording *r, const char *text)
{
    char *option = strlen(text) <= RECORD_NAME ? record_add_option(&r->record) : NULL;

    if (!option)
        return fail(EXIT_USAGE, "--record: the options are too long");
    (void)snprintf(option, RECORD_NAME + 1, "%s", text);
    message_clean(option);
    return strcmp(option, text) == 0 ? EXIT_FINE : fail(EXIT_USAGE, "--record: control characters in an option");
}

/* Adds the number of samples that were drawn, if the picture is one of samples, in place of the options for it. */
static int add_samples(struct recording *r)
{
    const struct options *o = r->options;
    char text[64];

    if (!r->samples)
        return EXIT_FINE;
    if (o->samples_range)
        (void)snprintf(text, sizeof text, "samples-range=%u-%u", (unsigned)o->first_sample,
                       (unsigned)(o->first_sample + r->samples - 1));
    else
        (void)snprintf(text, sizeof text, "spp=%u", (unsigned)r->samples);
    return add_option(r, text);
}

static int add_options(struct recording *r)
{
    const struct options *o = r->options;
    int status = o->given_bytes == SIZE_MAX ? fail(EXIT_RUNNING, "memory: exhausted") : EXIT_FINE;

    for (size_t at = 0; at < o->given_bytes && !status; at += strlen(o->given + at) + 1) {
        const struct option_row *row = recording_option(o->given + at);
        bool samples = row && (strcmp(row->name, "spp") == 0 || strcmp(row->name, "samples-range") == 0);
        if (row && recording_has(row) && !(samples && r->samples))
            status = add_option(r, o->given + at);
    }
    return status ? status : add_samples(r);
}

/* ---- the files that are read ---- */

/* Adds a file before it is read; one that does not exist is not. */
static bool add_file(void *ctx, const char *path)
{
    struct recording *r = ctx;
    char *real = realpath(path, NULL);
    const char *name = real ? record_name_in(r->folder, real) : NULL;
    bool known = !real;

    if (real && (!name || strlen(name) > RECORD_NAME || !record_name_stays(name)) && !r->outside[0])
        (void)snprintf(r->outside, sizeof r->outside, "%.400s", path);
    for (size_t i = 0; i < r->record.file_count && name && !known; i++)
        known = strcmp(r->record.files[i].name, name) == 0;
    if (!known && name) {
        struct record_file *file = record_add_file(&r->record);
        if (file)
            (void)snprintf(file->name, sizeof file->name, "%s", name);
        r->exhausted = r->exhausted || !file;
    }
    free(real);
    return true;
}

static int hash_files(struct recording *r)
{
    if (r->outside[0])
        return fail(EXIT_USAGE, "--record: %s is not in the record's folder, %.200s", r->outside, r->folder);
    if (r->exhausted)
        return fail(EXIT_RUNNING, "--record: more than %u files, or no memory", (unsigned)RECORD_ITEMS);
    for (size_t i = 0; i < r->record.file_count; i++) {
        struct record_file *file = &r->record.files[i];
        char *path = NULL;
        int length = asprintf(&path, "%s/%s", r->folder, file->name);
        int result = length < 0 ? -1 : sha256_file(path, file->hash, &file->size);
        if (length >= 0)
            free(path);
        if (result)
            return fail(EXIT_RUNNING, "--record: %.300s: %s", file->name, strerror(errno));
    }
    return EXIT_FINE;
}

/* ---- drawing ---- */

static void add_row(void *ctx, uint32_t frame, unsigned y, const unsigned char *bytes, size_t length)
{
    row_hashes_add(&((struct recording *)ctx)->hashes, frame, y, bytes, length);
}

static int check(const struct options *o)
{
    if (o->action != ACTION_DRAW || o->gazes || strcmp(o->output, "-") == 0)
        return fail(EXIT_USAGE, "--record: is for files (-o FILE), without --gaze");
    if (strcmp(o->record, "-") == 0 || series_has(o->output, o->record) || sink_is_same(o->record, o->resume))
        return fail(EXIT_USAGE, "--record: needs a file of its own");
    if (o->light.calibration)
        return fail(EXIT_USAGE, "--record: not with --calibration (--lenticular has its keys)");
    if (o->scene_path && (strcmp(o->scene_path, "-") == 0 || o->scene_format == SCENE_MODEL))
        return fail(EXIT_USAGE, "--record: needs a SCENE that is a file, and not of a format of libassimp");
    return EXIT_FINE;
}

static int find_folder(struct recording *r)
{
    char *copy = strdup(r->options->record);

    r->folder = copy ? realpath(dirname(copy), NULL) : NULL;
    free(copy);
    return r->folder ? EXIT_FINE : fail(EXIT_RUNNING, "%.300s: %s", r->options->record, strerror(errno));
}

static int draw_rows(struct recording *r)
{
    struct options *o = r->options;
    const struct row_tap tap = {NULL, add_row, r, &r->samples};
    int status = film_plan(o, &r->record.film);

    if (status)
        return status;
    r->record.film.depth = o->samples_range ? RECORD_SUMS : o->depth_bits;
    if (!row_hashes_begin(&r->hashes, &r->record.film) || !record_make_groups(&r->record))
        return fail(EXIT_RUNNING, "--record: too many rows, or no memory");
    r->samples = 0;
    o->tap = &tap;
    status = draw_file(o);
    o->tap = NULL;
    return status;
}

/* ---- the record ---- */

static int complete(struct recording *r)
{
    struct record *record = &r->record;
    const char *slash = strrchr(r->options->output, '/');

    for (size_t i = 0; i < record->group_count; i++)
        if (!row_hashes_group(&r->hashes, &record->groups[i]))
            return fail(EXIT_RUNNING, "--record: not all rows were drawn");
    for (uint32_t i = 0; i < record->film.frames; i++)
        record->frames[i] = row_hashes_frame(&r->hashes, record, i);
    (void)snprintf(record->tia, sizeof record->tia, TIA_VERSION);
    record->definition = RECORD_DEFINITION;
    record->format = r->options->format;
    (void)snprintf(record->picture, sizeof record->picture, "%s", slash ? slash + 1 : r->options->output);
    if (!record_name_stays(record->picture))
        return fail(EXIT_USAGE, "--record: control characters in the picture's name");
    return record_set_root(record) ? add_options(r) : EXIT_RUNNING;
}

static int write_record(struct recording *r)
{
    static struct sink sink; /* too large for the stack */
    char why[PORT_WHY];
    struct stat picture;
    size_t length;
    char *text = record_print(&r->record, &length);

    if (!text)
        return fail(EXIT_RUNNING, "memory: exhausted");
    if (stat(r->options->output, &picture) == 0)
        inputs_add(&picture); /* the record must not replace it */
    int status = sink_open(&sink, r->options->record, why);
    if (!status) {
        (void)sink_write(&sink, text, length);
        status = sink_commit(&sink);
    }
    free(text);
    return status ? fail(EXIT_RUNNING, "%s", why) : EXIT_FINE;
}

static int draw_recorded(struct recording *r)
{
    int status = check(r->options);

    status = status ? status : find_folder(r);
    status = status ? status : arguments_load(r->options);
    status = status ? status : hash_files(r);
    status = status ? status : draw_rows(r);
    if (!status && r->options->denoise && !r->samples)
        return fail(EXIT_RUNNING, "--record: the picture was not denoised: no record");
    status = status ? status : complete(r);
    return status ? status : write_record(r);
}

int recording_draw(struct options *options)
{
    struct recording r = {.options = options};

    options->opens = add_file;
    options->opens_ctx = &r;
    int status = draw_recorded(&r);
    options->opens = NULL;
    row_hashes_end(&r.hashes);
    record_free(&r.record);
    free(r.folder);
    return status;
}
