#include "replay.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tia/arguments.h"
#include "tia/checking.h"
#include "tia/draw.h"
#include "tia/fail.h"
#include "tia/film_plan.h"
#include "tia/recording.h"

/* A command line made of a record. */
struct arguments {
    char **words;
    int count;
};

/* Adds a word with memory of its own, since parsing changes words. */
static bool add_word(struct arguments *line, const char *before, const char *text)
{
    return asprintf(&line->words[line->count], "%s%s", before, text) >= 0 && ++line->count;
}

/* Adds the scene's path, as it can be opened from here; "-" alone would be standard input. */
static bool add_scene(struct arguments *line, const struct record_place *place)
{
    char *before = NULL;
    bool here = strcmp(place->given, ".") == 0 && place->record.files[0].name[0] != '-';
    bool fine = here || asprintf(&before, "%s/", place->given) >= 0;

    fine = fine && add_word(line, here ? "" : before, place->record.files[0].name);
    free(before);
    return fine;
}

static int make_line(struct arguments *line, const struct record_place *place)
{
    const struct record *r = &place->record;

    line->words = calloc(r->option_count + 4, sizeof *line->words);
    bool fine = line->words && add_word(line, "", "tia-verify");
    for (size_t i = 0; i < r->option_count && fine; i++) {
        const struct option_row *row = recording_option(r->options[i]);
        if (!row || !recording_has(row))
            return fail(CHECK_FAILED, "%.200s: --%.100s: not an option of a record", place->path, r->options[i]);
        fine = add_word(line, "--", r->options[i]);
    }
    fine = fine && add_word(line, "", "--");
    if (fine && r->file_count)
        fine = add_scene(line, place);
    return fine ? CHECK_SAME : fail(CHECK_FAILED, "memory: exhausted");
}

static void free_line(struct arguments *line)
{
    for (int i = 0; i < line->count; i++)
        free(line->words[i]);
    free(line->words);
}

/* Sets what the record has in other lines than those of options. */
static void take_record(struct options *o, const struct record *r)
{
    bool swaps = rotation_swaps(o->rotate);

    o->output = r->picture;
    o->format = r->format;
    o->width = (uint16_t)(swaps ? r->film.height : r->film.width);
    o->height = (uint16_t)(swaps ? r->film.width : r->film.height);
}

static int check_film(const struct record_place *place, const struct options *o)
{
    const struct image_film *a = &place->record.film;
    struct image_film b;

    if (film_plan(o, &b))
        return CHECK_FAILED;
    b.depth = o->samples_range ? RECORD_SUMS : o->depth_bits;
    if (a->width == b.width && a->height == b.height && a->first_row == b.first_row && a->rows == b.rows &&
        a->first_frame == b.first_frame && a->frames == b.frames && a->all_frames == b.all_frames &&
        a->rate[0] == b.rate[0] && a->rate[1] == b.rate[1] && a->depth == b.depth)
        return CHECK_SAME;
    return fail(CHECK_FAILED, "%.200s:5: its options draw another size, other frames or another depth", place->path);
}

static int draw_line(struct record_place *place, struct options *o, struct arguments *line)
{
    struct command command = tia_command;
    int argc = line->count;
    char **argv = line->words;

    command.name = "tia-verify";
    if (command_parse(&command, o, &argc, &argv) != COMMAND_RUN)
        return CHECK_FAILED;
    take_record(o, &place->record);
    int status = arguments_check(o, argc, argv);
    if (!status && (o->scene_format == SCENE_MODEL || o->gazes || o->action != ACTION_DRAW))
        status = fail(CHECK_FAILED, "%.200s: not what a record can have", place->path);
    status = status ? status : arguments_load(o);
    status = status ? status : check_film(place, o);
    return status || draw_file(o) ? CHECK_FAILED : CHECK_SAME;
}

int replay(struct record_place *place, const struct row_tap *tap, unsigned threads)
{
    struct options options;
    struct arguments line = {.words = NULL};
    int result = make_line(&line, place);

    arguments_default(&options);
    options.tap = tap;
    options.opens = record_file_allows;
    options.opens_ctx = place;
    options.threads = threads;
    result = result ? result : draw_line(place, &options, &line);
    arguments_free(&options);
    free_line(&line);
    return result;
}
