#include "options.h"

#include <stddef.h>
#include <string.h>

#include <tia/tia.h>

#include "common/choices.h"
#include "common/command_line.h"
#include "common/image/image.h"
#include "common/message.h"
#include "common/parse.h"
#include "common/scene/scene_load.h"
#include "common/thread_pool.h"

static const char *set_percentage(void *percent, char *value)
{
    bool fine = *value >= '0' && *value <= '9' && parse_reals(value, 101, percent, 1);

    return fine && *(double *)percent <= 100 ? NULL : "";
}

static const char *set_arithmetic(void *name, char *value)
{
    static const char *const names[] = {"f64", "f128"};

    for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strcmp(value, names[i]) == 0) {
            *(const char **)name = names[i];
            return NULL;
        }
    return "";
}

#define TO(member) OPTION_TO(struct options, member)

enum { COUNT_MAX = 1000000 };

static const struct option_row rows[] = {
    {"keys", 'k', OPTION_TEXT, "KEYS", "draw the built-in scene after these keys; default: none, a, d, s, w", TO(keys)},
    {"random", 0, OPTION_NUMBER, "N", "draw N random scenes of balls instead", TO(random), .min = 1, .max = COUNT_MAX},
    {"rays-random", 0, OPTION_NUMBER, "N", "draw N random scenes of all shapes, mirrors, glass and lights instead",
     TO(rays_random), .min = 1, .max = COUNT_MAX},
    {"ties", 0, OPTION_NUMBER, "N",
     "draw N random scenes of balls that are equally far, that view or shadow rays touch, that the eye or lights are "
     "on",
     TO(ties), .min = 1, .max = COUNT_MAX},
    {"hard", 0, OPTION_NUMBER, "N",
     "draw N random scenes of balls that need many digits: almost ties, tiny balls, lamps", TO(hard), .min = 1,
     .max = COUNT_MAX},
    {"seed", 0, OPTION_NUMBER, "S", "the seed of the random scenes (default 1)", TO(seed), .max = UINT64_MAX},
    {"thesis", 0, OPTION_FLAG, NULL, "draw the frames of the built-in scene as well", TO(thesis)},
    {"size", 's', OPTION_SIZE, "WIDTHxHEIGHT", "the size of the pictures; default 1920x1080, 640x480 for files",
     OPTION_PAIR(struct options, width, height), .max = TIA_SIZE_MAX},
    {"dither", 0, OPTION_FLAG, NULL, "draw with dithering", TO(dither)},
    {"threads", 'j', OPTION_NUMBER, "N", "#; default: all processors", TO(threads), .min = 1, .max = THREADS_MAX},
    {"arithmetic", 0, OPTION_PARSED, "f64|f128",
     "the reference: double precision (f64, the default), or 113 bits (f128), with which f64 is compared as well",
     TO(arithmetic), .parse = set_arithmetic, .rule = "not f64 or f128"},
    {"json", 0, OPTION_FLAG, NULL, "print one JSON object instead of the table", TO(json)},
    {"summary", 0, OPTION_FLAG, NULL, "print only the totals", TO(summary)},
    {"heatmap", 0, OPTION_TEXT, "FILE.png",
     "draw the differences, q16 left and f32 right: yellow one level, red more, cyan a flip; several frames are named "
     "FILE-1.png, FILE-2.png, ...",
     TO(heatmap)},
    {"require-identical", 0, OPTION_PARSED, "PERCENT", "fail if fewer of the pixels of q16 are identical",
     TO(require_identical), .parse = set_percentage, .rule = "not a percentage from 0 to 100"},
    {"max-flips", 0, OPTION_NUMBER, "N", "fail if q16 has more than N flips", TO(max_flips), .max = INT64_MAX},
    {"max-levels", 0, OPTION_NUMBER, "N", "fail if a pixel of q16, without being a flip, is off by more than N levels",
     TO(max_levels), .max = INT64_MAX},
    {"exact", 0, OPTION_FLAG, NULL,
     "compare with the exact picture instead, for scenes of matt balls: plain C, the code for small boards, each "
     "vector "
     "unit, f64 and f32; fail if a pixel of integers differs",
     TO(exact)},
    {"every", 0, OPTION_NUMBER, "N", "with --exact, compare only every Nth pixel", TO(every), .min = 1,
     .max = COUNT_MAX},
    {"shadows", 0, OPTION_FLAG, NULL,
     "compare shadow techniques with rays instead: pixels, time, memory; goes with --keys, --size, --threads, --json "
     "and --heatmap, a panel for each technique: red wrongly lit, blue wrongly dark, yellow another object",
     TO(shadows)},
    {"technique", 0, OPTION_TEXT, SHADOW_TECHNIQUES, "compare only this technique", TO(technique)},
    {"light", 0, OPTION_NUMBER, "N", "compare only light N of the scene, counted from 1", TO(light), .min = 1,
     .max = COUNT_MAX},
    {"best-of", 0, OPTION_NUMBER, "N", "report the shortest time of N frames (default 3)", TO(best_of), .min = 1,
     .max = COUNT_MAX},
    OPTION_END};

static const struct command command = {
    "tia-compare",
    "Usage: tia-compare [options] [SCENE...]\n"
    "Draws scenes in integers (q16), in single (f32) and in double precision (f64),\n"
    "and counts how q16 and f32 differ from f64. Or: tia-compare --exact [options]\n"
    "[SCENE...], or tia-compare --shadows [options] SCENE...\n"
    "\n",
    rows,
    "\n"
    "Exit status: 0 success, 1 a limit is exceeded, a pixel is not exact or\n"
    "something failed, 2 usage error.\n"};

static int mistake(const char *what, const char *why)
{
    return message_why("tia-compare", 2, what, why);
}

static bool has_limits(const struct options *options)
{
    return options->require_identical >= 0 || options->max_flips >= 0 || options->max_levels >= 0;
}

/* Checks --exact, whose limit is 0 pixels. */
static int check_exact(struct options *options)
{
    if (!options->exact && options->every)
        return mistake("--every", "needs --exact");
    if (options->exact && options->rays_random)
        return mistake("--exact", "cannot be combined with --rays-random");
    if (options->exact && (options->heatmap || has_limits(options)))
        return mistake("--exact",
                       "cannot be combined with --heatmap, --require-identical, --max-flips or --max-levels");
    options->every = options->every ? options->every : 1;
    return 0;
}

static int check_heatmap(const struct options *options)
{
    const char *name = options->heatmap;

    if (name && (strlen(name) <= strlen(".png") || image_format_of(name) != IMAGE_PNG))
        return mistake("--heatmap", "not a file in .png");
    return 0;
}

/* Checks --shadows, which excludes the options for comparing arithmetics. */
static int check_shadows(struct options *options)
{
    bool others = options->random || options->rays_random || options->ties || options->hard || options->thesis ||
                  options->summary || options->dither || options->exact || has_limits(options) ||
                  strcmp(options->arithmetic, "f64") != 0;

    if (!options->shadows && options->light)
        return mistake("--light", "needs --shadows");
    if (!options->shadows && options->best_of)
        return mistake("--best-of", "needs --shadows");
    if (!options->shadows && options->technique)
        return mistake("--technique", "needs --shadows");
    if (options->shadows && others)
        return mistake("--shadows", "cannot be combined with options for arithmetics");
    if (options->shadows && options->scene_count == 0)
        return mistake("--shadows", "needs a SCENE");
    options->best_of = options->best_of ? options->best_of : 3;
    return 0;
}

int options_parse(struct options *options, int argc, char **argv)
{
    *options = (struct options){.seed = 1,
                                .arithmetic = "f64",
                                .threads = threads_processors(),
                                .require_identical = -1,
                                .max_flips = -1,
                                .max_levels = -1,
                                .best_of = 0};
    int result = command_parse(&command, options, &argc, &argv);
    if (result != COMMAND_RUN)
        return result;
    result = 0;
    options->scenes = argv;
    options->scene_count = argc;
    for (int i = 0; i < options->scene_count && result == 0; i++)
        if (scene_format_of(options->scenes[i]) == SCENE_UNKNOWN)
            result = mistake(options->scenes[i], "not a scene: must end in .tia, .nff, .obj, .stl, .ply, .off or .pgm");
    if (result == 0)
        result = check_shadows(options);
    if (result == 0)
        result = check_exact(options);
    if (result == 0)
        result = check_heatmap(options);
    bool any = options->random || options->rays_random || options->ties || options->hard || options->scene_count;
    options->thesis |= !any || options->keys;
    return result == 0 ? COMMAND_RUN : result;
}
