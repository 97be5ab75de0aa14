/* tia-join - joins separately drawn parts of a picture or film. */
#include <stdio.h>
#include <stdlib.h>

#include <tia/tia.h>

#include "common/choices.h"
#include "common/command_line.h"
#include "common/image/parts.h"
#include "common/image/series.h"
#include "common/message.h"
#include "common/signals.h"
#include "join_sums.h"
#include "ports.h"
#include "verify_parts.h"

enum { FINE, NOT_WRITTEN, REFUSED };

struct join {
    const char *output;
    enum image_format format;
    struct parts parts;
    struct verify_wish verify;
    char why[PORT_WHY];
};

static int refuse(int status, const char *what, const char *why)
{
    return message_why("tia-join", status, what, why);
}

/* ---- joining ---- */

static int join_frame(struct join *join, struct series *series, uint32_t frame, tia_rgb565 *pixels)
{
    if (parts_frame(&join->parts, frame, pixels) != 0)
        return refuse(REFUSED, join->parts.why, "");
    if (series_begin(series, frame) || image_band(series->image, pixels, series->film.height) || series_end(series))
        return refuse(NOT_WRITTEN, join->why, "");
    return FINE;
}

static int join_frames(struct join *join, const struct image_film *film)
{
    struct series series = {.name = join->output, .format = join->format, .film = *film, .why = join->why};
    tia_rgb565 *pixels = malloc((size_t)film->width * film->height * sizeof *pixels);
    int result = pixels ? FINE : refuse(NOT_WRITTEN, "memory", "exhausted");
    for (uint32_t frame = 0; frame < film->frames && result == FINE; frame++)
        result = join_frame(join, &series, frame, pixels);
    free(pixels);
    if (result != FINE) {
        series_discard(&series);
        return result;
    }
    return !series_finish(&series) ? FINE : refuse(NOT_WRITTEN, join->why, "");
}

static int join_parts(struct join *join, char *const *paths, unsigned count)
{
    char why[SUMS_WHY];

    if (is_sums(paths[0])) {
        int result = join_sums(paths, count, join->output, join->format, why);
        return result == FINE ? FINE : refuse(result, why, "");
    }
    if (!image_format_has(join->format, 0))
        return refuse(REFUSED, join->output, "such parts have RGB565 (use .png or .ppm)");
    if (parts_open(&join->parts, paths, count) != 0)
        return refuse(REFUSED, join->parts.why, "");
    struct image_film film = join->parts.array[0].film;
    film.first_row = film.first_frame = 0;
    film.rows = film.height;
    film.frames = film.all_frames;
    if (film.frames > 1 && !image_format_films(join->format) && !series_is_pattern(join->output))
        return refuse(REFUSED, join->output, "one picture for a film (name it .y4m, or with %04d in its name)");
    return join_frames(join, &film);
}

/* ---- the command line ---- */

static int check(struct join *join, int parts)
{
    if (!join->output)
        return refuse(REFUSED, "--output", "is missing (tia-join -h)");
    if (join->format == IMAGE_UNKNOWN)
        join->format = image_format_of(join->output);
    if (join->format == IMAGE_UNKNOWN) {
        return refuse(REFUSED, join->output,
                      "unknown picture format (name it .png, .ppm, .bmp, .565 or .y4m, or use --format)");
    }
    if (!image_format_built(join->format))
        return refuse(REFUSED, join->output, "this build does not write such files (use .ppm)");
    return parts > 0 ? FINE : refuse(REFUSED, "no part is named", "(tia-join -h)");
}

static const struct option_row rows[] = {{"output", 'o', OPTION_TEXT, "FILE",
                                          "a picture (.png .ppm .bmp .565), a film (.y4m, or one picture per frame "
                                          "with %04d in its name), a part (.tiapart), or "
                                          "- for standard output",
                                          OPTION_TO(struct join, output)},
                                         {"format", 0, OPTION_CHOICE, IMAGE_FORMATS,
                                          "the format of FILE, if its name has no such extension",
                                          OPTION_TO(struct join, format), .min = IMAGE_PNG},
                                         {"verify", 0, OPTION_FLAG, NULL,
                                          "draw random rows of each part again and refuse parts with other bits; the "
                                          "scene and the options of tia, as drawn, follow --",
                                          OPTION_TO(struct join, verify.asked)},
                                         CHOICE_ROWS(struct join, verify.choice),
                                         OPTION_END};

static const struct command command = {"tia-join",
                                       "Usage: tia-join -o FILE PART...\n"
                                       "       tia-join -o FILE --verify PART... -- SCENE [options of tia, as drawn]\n"
                                       "Joins parts that tia drew, -o PART.tiapart with --frame-range or --tile-rows,\n"
                                       "or -o PART.y4m with --frame-range, in any order. Adds parts with\n"
                                       "--samples-range, into .png, .ppm, .pfm, .exr or .tiapart.\n"
                                       "\n",
                                       rows,
                                       "\n"
                                       "Exit status: 0 success, 1 the file cannot be written, 2 usage error or parts\n"
                                       "that do not fit.\n"};

int main(int argc, char **argv)
{
    struct join join = {.format = IMAGE_UNKNOWN};
    signals_prepare();
    verify_split(&join.verify, &argc, argv);
    int result = command_parse(&command, &join, &argc, &argv);
    if (result != COMMAND_RUN)
        return result;
    result = check(&join, argc);
    if (result == FINE)
        result = verify_parts(&join.verify, argv, argc) ? REFUSED : FINE;
    if (result == FINE)
        result = join_parts(&join, argv, (unsigned)argc);
    parts_close(&join.parts);
    return result;
}
