#include "convert.h"

#include <ctype.h>
#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "common/message.h"
#include "common/scene/scene.h"
#include "common/signals.h"
#include "ports.h"

#define LIGHTS_MOST 65535

enum { NAME = 256, SCENE_FORMAT, STRICT, MEMORY, LIGHTS };

static const struct option long_options[] = {{"output", required_argument, NULL, 'o'},
                                             {"scene-format", required_argument, NULL, SCENE_FORMAT},
                                             {"help", no_argument, NULL, 'h'},
                                             {"version", no_argument, NULL, 'V'},
                                             {"strict", no_argument, NULL, STRICT},
                                             {"name", required_argument, NULL, NAME},
                                             {"memory", required_argument, NULL, MEMORY},
                                             {"size", required_argument, NULL, 's'},
                                             {"lights", required_argument, NULL, LIGHTS},
                                             {0}};
/* From which of them on they are for commands that have --name, and what it goes with. */
#define COMMON_OPTIONS 5

static int fail(const struct converter *converter, int status, const char *what, const char *why)
{
    return message_why(converter->tool, status, what, why);
}

static bool is_identifier(const char *text)
{
    static const char keywords[] =
        " auto break case char const continue default do double else enum extern float for goto if inline int long "
        "register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while ";
    char word[68];
    size_t length = strlen(text);

    for (size_t i = 0; i < length; i++)
        if (!isalpha((unsigned char)text[i]) && text[i] != '_' && (i == 0 || !isdigit((unsigned char)text[i])))
            return false;
    if (length == 0 || length >= 64)
        return false;
    word[0] = ' ';
    memcpy(word + 1, text, length);
    memcpy(word + 1 + length, " ", 2);
    return !strstr(keywords, word);
}

/* A number in 1..most, up to `end`. */
static bool read_number(const char **text, char end, uint32_t most, uint32_t *value)
{
    const char *at = *text;

    for (*value = 0; isdigit((unsigned char)*at) && *value <= most; at++)
        *value = *value * 10 + (uint32_t)(*at - '0');
    *text = at + 1;
    return *at == end && *value > 0 && *value <= most;
}

static bool add_tile(struct request *request, const char *text)
{
    uint32_t width, height;
    bool is_size = read_number(&text, 'x', TIA_SIZE_MAX, &width) && read_number(&text, '\0', TIA_SIZE_MAX, &height);

    if (!is_size || request->tile_count == CONVERT_TILES)
        return false;
    request->tiles[request->tile_count][0] = (uint16_t)width;
    request->tiles[request->tile_count++][1] = (uint16_t)height;
    return true;
}

/* Sets --memory or an option that goes with it. */
static int set_memory(const struct converter *converter, struct request *request, int option, const char *text)
{
    switch (option) {
    case MEMORY:
        request->memory = text;
        return 0;
    case LIGHTS:
        return read_number(&text, '\0', LIGHTS_MOST, &request->lights)
                   ? 0
                   : fail(converter, 2, "--lights", "must be a number in 1..65535");
    default:
        return add_tile(request, text)
                   ? 0
                   : fail(converter, 2, "--size", "must be WIDTHxHEIGHT, each 1..8192, at most 16 times");
    }
}

/* 0: continue; 1: done; 2: usage error. */
static int set(const struct converter *converter, struct request *request, int option, const char *text)
{
    switch (option) {
    case 'o':
        request->output = text;
        return 0;
    case SCENE_FORMAT:
        request->format = scene_format_called(text);
        return request->format != SCENE_UNKNOWN ? 0 : fail(converter, 2, "--scene-format", "must be tia, nff or obj");
    case NAME:
        request->symbol = text;
        return is_identifier(text) ? 0 : fail(converter, 2, "--name", "must be a name in C, of less than 64 letters");
    case STRICT:
        request->strict = true;
        return 0;
    case MEMORY:
    case LIGHTS:
    case 's':
        return set_memory(converter, request, option, text);
    case 'h':
        (void)fputs(converter->usage, stdout);
        return 1;
    default:
        (void)printf("%s " TIA_VERSION "\n", converter->tool);
        return 1;
    }
}

/* Replaces getopt_long's own messages, which start with argv[0]: that may be a path. */
static int reject(const struct converter *converter, int option, char **argv)
{
    return fail(converter, 2, argv[optind - 1],
                option == ':' ? "needs a value (see --help)" : "unknown option (see --help)");
}

static int parse(const struct converter *converter, struct request *request, int argc, char **argv)
{
    const struct option *known = long_options;
    struct option options[sizeof long_options / sizeof *long_options];
    int option, result = 0;

    memcpy(options, known, sizeof options);
    if (!converter->symbol)
        options[COMMON_OPTIONS] = (struct option){0};
    opterr = 0;
    while (result == 0 &&
           (option = getopt_long(argc, argv, converter->write_memory ? ":o:hVs:" : ":o:hV", options, NULL)) != -1)
        result =
            option == '?' || option == ':' ? reject(converter, option, argv) : set(converter, request, option, optarg);
    if (result != 0)
        return result;
    if (optind == argc)
        return fail(converter, 2, "SCENE", "no scene is named (see --help)");
    request->scene = argv[optind];
    if (optind + 1 < argc)
        return fail(converter, 2, argv[optind + 1], "unexpected argument (see --help)");
    return request->output || request->memory ? 0 : fail(converter, 2, "--output", "no file is named (see --help)");
}

static void name_source(struct request *request)
{
    const char *slash = strrchr(request->scene, '/');

    (void)snprintf(request->source, sizeof request->source, "%s",
                   strcmp(request->scene, "-") == 0 ? "a scene from standard input"
                   : slash                          ? slash + 1
                                                    : request->scene);
    for (char *at = request->source; *at != '\0'; at++)
        if (!isalnum((unsigned char)*at) && !strchr(" .-_", *at))
            *at = '_';
}

static void warn(const struct converter *converter, const struct scene_file *file)
{
    char line[SCENE_WHY];

    for (unsigned at = 0; scene_warning(file, &at, line);)
        (void)fail(converter, 0, line, "");
}

static int open_scene(const struct converter *converter, struct request *request, struct scene_file *file)
{
    if (request->format == SCENE_UNKNOWN)
        request->format = scene_format_of(request->scene);
    if (request->format == SCENE_UNKNOWN)
        return fail(converter, 2, request->scene, "its name does not tell its format (use --scene-format)");
    int status = scene_open(file, request->scene, request->format, request->strict);
    if (!status) {
        warn(converter, file);
        return 0;
    }
    return fail(converter, status == TIA_ERR_RANGE ? 2 : 1, file->why, "");
}

int convert(const struct converter *converter, int argc, char **argv)
{
    struct request request = {.format = SCENE_UNKNOWN, .symbol = converter->symbol};
    static struct scene_file file;
    char why[PORT_WHY] = "out of memory";
    int result = parse(converter, &request, argc, argv);

    if (result != 0)
        return result == 1 ? 0 : result;
    signals_prepare();
    name_source(&request);
    result = open_scene(converter, &request, &file);
    if (result != 0)
        return result;
    if ((request.output && converter->write(&request, &file.scene, why)) ||
        (request.memory && converter->write_memory(&request, &file.scene, why)))
        result = fail(converter, 1, why, "");
    scene_close(&file);
    return result;
}
