/* options.c - the command line: any bytes, a newline between arguments. Accepted options keep their limits. */
#include "tia/arguments.h"
#include "tia/fail.h"
#include "tia/film_plan.h"
#include "words.h"

static void must_keep_limits(const struct options *o)
{
    MUST(o->core && o->display.name && o->input.name);
    MUST(!o->width == !o->height && o->width <= TIA_SIZE_MAX && o->height <= TIA_SIZE_MAX);
    MUST(o->action != ACTION_DRAW || o->output);
    MUST(o->threads >= 1);
    MUST(!o->key_count || o->keys);
    MUST(!o->scene_path || o->scene_format != SCENE_UNKNOWN);
    MUST(o->samples <= TIA_SAMPLES_MAX && o->depth <= TIA_DEPTH_MAX && o->time >= 0 && o->rate[0] >= 1 &&
         o->rate[1] >= 1);
    MUST(o->first_frame <= o->last_frame && o->first_row <= o->last_row);
    MUST(!o->tile_rows || o->format == IMAGE_PART);
}

/* Checks that the keys for the built-in scene are read, and that the frames to draw lie in the film. */
static void must_plan(struct options *o)
{
    struct image_film film;

    if (arguments_load(o) != EXIT_FINE || o->action != ACTION_DRAW || film_plan(o, &film) != EXIT_FINE)
        return;
    MUST(!o->key_count || o->keys);
    MUST(film.width && film.width <= TIA_SIZE_MAX && film.height && film.height <= TIA_SIZE_MAX);
    MUST(film.rows && film.first_row + film.rows <= film.height);
    MUST(film.frames && (uint64_t)film.first_frame + film.frames <= film.all_frames);
    MUST(film_time(o, film.first_frame + film.frames - 1) >= o->time);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct words words = take_words("tia", data, size);
    struct options options;
    int status = arguments_parse(&options, words.argc, words.argv);

    MUST(status == COMMAND_RUN || status == EXIT_FINE || status == EXIT_USAGE || status == EXIT_DISPLAY ||
         status == EXIT_RUNNING);
    if (status == COMMAND_RUN)
        must_keep_limits(&options);
    if (status == COMMAND_RUN && !options.scene_path && options.action <= ACTION_DRAW)
        must_plan(&options);
    arguments_free(&options);
    free(words.text);
    return 0;
}
