#include "options.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <tia/tia.h>

#include "common/message.h"
#include "common/scene/scene.h"
#include "common/thread_pool.h"

enum {
    THESIS = 256,
    RANDOM,
    SEED,
    JSON,
    SUMMARY,
    HEATMAP,
    IDENTICAL,
    FLIPS,
    RAYS_RANDOM,
    LEVELS,
    SHADOWS,
    LIGHT,
    BEST_OF,
    TECHNIQUE
};

static const struct option long_options[] = {{"keys", required_argument, NULL, 'k'},
                                             {"thesis", no_argument, NULL, THESIS},
                                             {"random", required_argument, NULL, RANDOM},
                                             {"rays-random", required_argument, NULL, RAYS_RANDOM},
                                             {"seed", required_argument, NULL, SEED},
                                             {"size", required_argument, NULL, 's'},
                                             {"threads", required_argument, NULL, 'j'},
                                             {"json", no_argument, NULL, JSON},
                                             {"summary", no_argument, NULL, SUMMARY},
                                             {"heatmap", required_argument, NULL, HEATMAP},
                                             {"require-identical", required_argument, NULL, IDENTICAL},
                                             {"max-flips", required_argument, NULL, FLIPS},
                                             {"max-levels", required_argument, NULL, LEVELS},
                                             {"shadows", no_argument, NULL, SHADOWS},
                                             {"technique", required_argument, NULL, TECHNIQUE},
                                             {"light", required_argument, NULL, LIGHT},
                                             {"best-of", required_argument, NULL, BEST_OF},
                                             {"help", no_argument, NULL, 'h'},
                                             {"version", no_argument, NULL, 'V'},
                                             {0}};

static const char usage[] =
    "Usage: tia-compare [options] [SCENE...]\n"
    "Draws scenes in integers (q16), in single (f32) and in double precision (f64), and counts how\n"
    "q16 and f32 differ from f64. Or: tia-compare --shadows [options] SCENE...\n"
    "\n"
    "  -k, --keys STRING            the built-in scene after these keys; default: as it is, a, d, s, w\n"
    "      --random N               N random scenes of balls instead\n"
    "      --rays-random N          N random scenes of all shapes, mirrors, glass and lights instead\n"
    "      --seed S                 of this series (default 1)\n"
    "      --thesis                 the built-in scene's frames besides the others\n"
    "  -s, --size WxH               default 1920x1080, files 640x480, random scenes their own\n"
    "  -j, --threads N              default: all processors\n"
    "      --json                   one JSON object instead of the table\n"
    "      --summary                the sums alone\n"
    "      --heatmap FILE.png       where the differences are, q16 left and f32 right: yellow one level,\n"
    "                               red more, cyan another object or shadow; with several frames\n"
    "                               FILE-1.png, FILE-2.png, ...\n"
    "      --require-identical P    fail when less than P percent of q16's pixels are identical\n"
    "      --max-flips N            fail when more than N of q16's pixels show another object or shadow\n"
    "      --max-levels N           fail when another of q16's pixels is off by more than N levels\n"
    "      --shadows                compare techniques for shadows with rays instead: pixels, time, memory;\n"
    "                               with --keys, --size, --threads, --json and --heatmap, a panel for each\n"
    "                               technique: red wrongly lit, blue wrongly dark, yellow another object\n"
    "      --technique NAME         only this technique\n"
    "      --light N                only light N of the scene, from 1\n"
    "      --best-of N              times are the least of N frames (default 3)\n"
    "  -h, --help, -V, --version\n"
    "\n"
    "Exit status: 0 fine, 1 a bound is not met or something failed, 2 wrong usage.\n";

static int mistake(const char *what, const char *why)
{
    return message_why("tia-compare", -1, what, why);
}

/* A whole number in low..high, digits only. */
static bool number(const char *text, uint64_t low, uint64_t high, uint64_t *out)
{
    char *end;

    if (*text < '0' || *text > '9')
        return false;
    errno = 0;
    *out = strtoull(text, &end, 10);
    return errno == 0 && *end == '\0' && *out >= low && *out <= high;
}

static bool percentage(const char *text, double *out)
{
    char *end;

    if (*text < '0' || *text > '9')
        return false;
    *out = strtod(text, &end);
    return *end == '\0' && *out <= 100;
}

static bool size(const char *text, struct options *options)
{
    char width[6] = "";
    const char *x = strchr(text, 'x');
    uint64_t w, h;

    if (!x || x - text >= (ptrdiff_t)sizeof width)
        return false;
    memcpy(width, text, (size_t)(x - text));
    if (!number(width, 1, TIA_SIZE_MAX, &w) || !number(x + 1, 1, TIA_SIZE_MAX, &h))
        return false;
    options->width = (unsigned)w;
    options->height = (unsigned)h;
    return true;
}

static bool count(const char *text, unsigned *out)
{
    uint64_t n = 0;
    bool ok = number(text, 1, 1000000, &n);

    *out = (unsigned)n;
    return ok;
}

static bool bound(const char *text, int64_t *out)
{
    uint64_t n = 0;
    bool ok = number(text, 0, INT64_MAX, &n);

    *out = (int64_t)n;
    return ok;
}

/* The options that take numbers. */
static int set_number(struct options *options, int option, const char *text)
{
    uint64_t n = 0;

    switch (option) {
    case RANDOM:
        return count(text, &options->random) ? 0 : mistake("--random", "must be a number from 1 to 1000000");
    case RAYS_RANDOM:
        return count(text, &options->rays_random) ? 0 : mistake("--rays-random", "must be a number from 1 to 1000000");
    case SEED:
        return number(text, 0, UINT64_MAX, &options->seed) ? 0 : mistake("--seed", "must be a number");
    case 'j':
        if (!number(text, 1, THREADS_MAX, &n))
            return mistake("--threads", "must be a number from 1 to 1024");
        options->threads = (unsigned)n;
        return 0;
    case IDENTICAL:
        return percentage(text, &options->require_identical)
                   ? 0
                   : mistake("--require-identical", "must be a percentage from 0 to 100");
    case LIGHT:
        return count(text, &options->light) ? 0 : mistake("--light", "must be a number from 1 to 1000000");
    case BEST_OF:
        return count(text, &options->best_of) ? 0 : mistake("--best-of", "must be a number from 1 to 1000000");
    case LEVELS:
        return bound(text, &options->max_levels) ? 0 : mistake("--max-levels", "must be a number");
    default:
        return bound(text, &options->max_flips) ? 0 : mistake("--max-flips", "must be a number");
    }
}

static bool is_technique(const char *text)
{
    unsigned i = 0;

    while (tia_shadows_name(i) && strcmp(tia_shadows_name(i), text) != 0)
        i++;
    return tia_shadows_name(i);
}

static int set(struct options *options, int option, const char *text)
{
    switch (option) {
    case 'k':
        options->keys = text;
        return 0;
    case 's':
        return size(text, options) ? 0 : mistake("--size", "must be WIDTHxHEIGHT, 1x1 to 8192x8192");
    case THESIS:
        options->thesis = true;
        return 0;
    case JSON:
        options->json = true;
        return 0;
    case SUMMARY:
        options->summary = true;
        return 0;
    case HEATMAP:
        options->heatmap = text;
        return 0;
    case SHADOWS:
        options->shadows = true;
        return 0;
    case TECHNIQUE:
        options->technique = text;
        return is_technique(text) ? 0 : mistake("--technique", "there is no such technique");
    case 'h':
        (void)fputs(usage, stdout);
        return 1;
    case 'V':
        (void)puts("tia-compare " TIA_VERSION);
        return 1;
    default:
        return set_number(options, option, text);
    }
}

/* Replaces getopt_long's own messages, which start with argv[0]: that may be a path. */
static int reject(int option, char **argv)
{
    return mistake(argv[optind - 1], option == ':' ? "needs a value (see --help)" : "unknown option (see --help)");
}

/* Arithmetics and techniques are compared in runs of their own. */
static int check_shadows(struct options *options)
{
    bool others = options->random || options->rays_random || options->thesis || options->summary ||
                  options->require_identical >= 0 || options->max_flips >= 0 || options->max_levels >= 0;

    if (!options->shadows && options->light)
        return mistake("--light", "needs --shadows");
    if (!options->shadows && options->best_of)
        return mistake("--best-of", "needs --shadows");
    if (!options->shadows && options->technique)
        return mistake("--technique", "needs --shadows");
    if (options->shadows && others)
        return mistake("--shadows", "goes with no option for arithmetics");
    if (options->shadows && options->scene_count == 0)
        return mistake("--shadows", "needs a SCENE");
    options->best_of = options->best_of ? options->best_of : 3;
    return 0;
}

int options_parse(struct options *options, int argc, char **argv)
{
    int option, result = 0;

    *options = (struct options){.seed = 1,
                                .threads = threads_processors(),
                                .require_identical = -1,
                                .max_flips = -1,
                                .max_levels = -1,
                                .best_of = 0};
    opterr = 0;
    while (result == 0 && (option = getopt_long(argc, argv, ":k:s:j:hV", long_options, NULL)) != -1)
        result = option == '?' || option == ':' ? reject(option, argv) : set(options, option, optarg);
    options->scenes = argv + optind;
    options->scene_count = argc - optind;
    for (int i = 0; i < options->scene_count && result == 0; i++)
        if (scene_format_of(options->scenes[i]) == SCENE_UNKNOWN)
            result = mistake(options->scenes[i], "not a scene: must end in .tia, .nff or .obj");
    if (result == 0)
        result = check_shadows(options);
    options->thesis |= options->random + options->rays_random + (unsigned)options->scene_count == 0 || options->keys;
    return result;
}
