#include "options.h"

#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "arithmetic.h"
#include "common/threads.h"
#include "fail.h"
#include "parse.h"
#include "ports.h"

enum {
    OPT_FORMAT = 256, /* above every character */
    OPT_ARITHMETIC,
    OPT_DITHER,
    OPT_ROTATE,
    OPT_CONNECTOR,
    OPT_MODE,
    OPT_CHECKSUM,
    OPT_STATS,
    OPT_LIST
};

static const char shorts[] = ":d:o:s:k:i:n:j:hV";
static const struct option longs[] = {{"display", required_argument, NULL, 'd'},
                                      {"output", required_argument, NULL, 'o'},
                                      {"format", required_argument, NULL, OPT_FORMAT},
                                      {"size", required_argument, NULL, 's'},
                                      {"keys", required_argument, NULL, 'k'},
                                      {"input", required_argument, NULL, 'i'},
                                      {"frames", required_argument, NULL, 'n'},
                                      {"threads", required_argument, NULL, 'j'},
                                      {"arithmetic", required_argument, NULL, OPT_ARITHMETIC},
                                      {"dither", no_argument, NULL, OPT_DITHER},
                                      {"rotate", required_argument, NULL, OPT_ROTATE},
                                      {"connector", required_argument, NULL, OPT_CONNECTOR},
                                      {"mode", required_argument, NULL, OPT_MODE},
                                      {"checksum", no_argument, NULL, OPT_CHECKSUM},
                                      {"stats", no_argument, NULL, OPT_STATS},
                                      {"list-displays", no_argument, NULL, OPT_LIST},
                                      {"help", no_argument, NULL, 'h'},
                                      {"version", no_argument, NULL, 'V'},
                                      {NULL, 0, NULL, 0}};

static int wrong(const char *option, const char *value, const char *rule)
{
    return fail(EXIT_USAGE, "%s '%.200s': %s", option, value, rule);
}

static int take_size(struct options *options, const char *value)
{
    if (!parse_size(value, NULL, TIA_SIZE_MAX, &options->width, &options->height)) {
        return wrong("--size", value, "not a size (1x1 to 8192x8192, like 640x480)");
    }
    return EXIT_FINE;
}

static int take_format(struct options *options, const char *value)
{
    options->format = image_format_called(value);
    return options->format != IMAGE_UNKNOWN ? EXIT_FINE : wrong("--format", value, "not png, ppm, bmp or 565");
}

static int take_keys(struct options *options, const char *value)
{
    const char *bad;
    free(options->keys);
    options->keys = malloc((strlen(value) + 1) * sizeof *options->keys);
    if (options->keys == NULL) {
        return fail(EXIT_RUNNING, "memory: exhausted");
    }
    if (!parse_keys(value, options->scene, options->keys, &options->key_count, &bad)) {
        return wrong("--keys", bad, "no key that moves the light (a d s w <left> <right> <up> <down> <pgup> <pgdn>)");
    }
    return EXIT_FINE;
}

static int take_number(const char *option, const char *value, uint32_t max, uint32_t *number)
{
    if (!parse_number(value, NULL, 1, max, number)) {
        return fail(EXIT_USAGE, "%s '%.200s': not a number from 1 to %u", option, value, max);
    }
    return EXIT_FINE;
}

static int take_rotate(struct options *options, const char *value)
{
    if (!parse_number(value, NULL, 0, 270, &options->rotate) || options->rotate % 90 != 0) {
        return wrong("--rotate", value, "not 0, 90, 180 or 270");
    }
    return EXIT_FINE;
}

static int take_arithmetic(struct options *options, const char *value)
{
    options->core = arithmetic_called(value);
    if (options->core != NULL) {
        return EXIT_FINE;
    }
    return wrong("--arithmetic", value,
                 strcmp(value, "f64") == 0 ? "this build has q16 only (make F64=yes)" : "not q16 or f64");
}

/* Cuts "drm:/dev/dri/card1" into its name and device. */
static void take_device(char *value, const char **name, const char **device)
{
    char *colon = strchr(value, ':');
    *name = value;
    *device = colon != NULL && colon[1] != '\0' ? colon + 1 : NULL;
    if (colon != NULL) {
        *colon = '\0';
    }
}

static int take_connector(struct options *options, const char *value)
{
    if (strcmp(value, "help") == 0) {
        options->action = ACTION_MODES;
    }
    options->connector = value;
    return EXIT_FINE;
}

static int take_mode(struct options *options, const char *value)
{
    if (strcmp(value, "help") == 0) {
        options->action = ACTION_MODES;
    } else if (!parse_mode(value)) {
        return wrong("--mode", value, "not preferred, WxH or WxH@HERTZ (--mode help lists what there is)");
    }
    options->mode = value;
    return EXIT_FINE;
}

/* Options without a value. */
static int take_flag(struct options *options, int option)
{
    switch (option) {
    case OPT_DITHER:
        options->dither = true;
        break;
    case OPT_CHECKSUM:
        options->checksum = true;
        break;
    case OPT_STATS:
        options->stats = true;
        break;
    case OPT_LIST:
        options->action = ACTION_LIST;
        break;
    case 'h':
        options->action = ACTION_HELP;
        break;
    default:
        options->action = ACTION_VERSION;
        break;
    }
    return EXIT_FINE;
}

static int take(struct options *options, int option, char *value)
{
    switch (option) {
    case 'd':
        take_device(value, &options->display, &options->display_device);
        return EXIT_FINE;
    case 'i':
        take_device(value, &options->input, &options->input_device);
        return EXIT_FINE;
    case 'o':
        options->output = value;
        return EXIT_FINE;
    case OPT_FORMAT:
        return take_format(options, value);
    case 's':
        return take_size(options, value);
    case 'k':
        return take_keys(options, value);
    case 'n':
        return take_number("--frames", value, UINT32_MAX, &options->frames);
    case 'j':
        return take_number("--threads", value, THREADS_MAX, &options->threads);
    case OPT_ARITHMETIC:
        return take_arithmetic(options, value);
    case OPT_ROTATE:
        return take_rotate(options, value);
    case OPT_CONNECTOR:
        return take_connector(options, value);
    case OPT_MODE:
        return take_mode(options, value);
    default:
        return take_flag(options, option);
    }
}

/* What getopt_long refused: ':' a value is missing, '?' anything else. */
static int refuse(int what, char **argv)
{
    char letter[3] = {'-', (char)optopt, '\0'};
    bool is_short = optopt > 0 && optopt < 256 && strncmp(argv[optind - 1], "--", 2) != 0;
    const char *name = is_short ? letter : argv[optind - 1];
    if (what == ':') {
        return fail(EXIT_USAGE, "%.200s: a value is missing (tia -h shows which)", name);
    }
    if (!is_short && optopt != 0) {
        return fail(EXIT_USAGE, "%.200s: takes no value", name);
    }
    return fail(EXIT_USAGE, "%.200s: unknown option (tia -h lists them)", name);
}

static bool is_one_of(const char *name, const char *const *names)
{
    while (*names != NULL && strcmp(name, *names) != 0) {
        names++;
    }
    return *names != NULL;
}

/* A name that only another build has is no wrong usage: that is found out later. */
static int check_names(const struct options *options)
{
    static const char *const displays[] = {"auto", "drm", "fbdev", "terminal", "none", NULL};
    static const char *const inputs[] = {"auto", "evdev", "tty", "none", NULL};
    bool display = is_one_of(options->display, displays), input = is_one_of(options->input, inputs);
    for (const struct port_display *port = port_displays; port->name != NULL; port++) {
        display = display || strcmp(port->name, options->display) == 0;
    }
    for (const struct port_input *port = port_inputs; port->name != NULL; port++) {
        input = input || strcmp(port->name, options->input) == 0;
    }
    if (!display) {
        return wrong("--display", options->display, "no such display (auto, drm, fbdev, terminal or none)");
    }
    if (!input) {
        return wrong("--input", options->input, "no such input (auto, evdev, tty or none)");
    }
    if (options->display_device != NULL && strcmp(options->display, "auto") == 0) {
        return wrong("--display", options->display_device, "auto takes no device (name the display)");
    }
    if (options->input_device != NULL && strcmp(options->input, "auto") == 0) {
        return wrong("--input", options->input_device, "auto takes no device (name the input)");
    }
    return EXIT_FINE;
}

/* The file's format and what goes with a file. */
static int check_output(struct options *options)
{
    if (options->output == NULL) {
        return options->format == IMAGE_UNKNOWN ? EXIT_FINE : fail(EXIT_USAGE, "--format: needs --output FILE");
    }
    if (strcmp(options->display, "auto") != 0 || strcmp(options->input, "auto") != 0 || options->connector != NULL ||
        options->mode != NULL) {
        return fail(EXIT_USAGE, "--output: goes to a file, without --display, --input, --connector or --mode");
    }
    bool is_standard = strcmp(options->output, "-") == 0;
    if (is_standard && options->checksum) {
        return fail(EXIT_USAGE, "--checksum: standard output already gets the picture (-o FILE)");
    }
    if (options->format == IMAGE_UNKNOWN && !is_standard) {
        options->format = image_format_of(options->output);
    }
    if (options->format == IMAGE_UNKNOWN) {
        return fail(EXIT_USAGE, "%.200s: unknown picture format (name it .png, .ppm, .bmp or .565, or use --format)",
                    is_standard ? "standard output" : options->output);
    }
    if (!image_format_built(options->format)) {
        return fail(EXIT_USAGE, "%.200s: this build writes no .%s (use .ppm)", options->output,
                    image_format_name(options->format));
    }
    if (options->action == ACTION_SHOW) {
        options->action = ACTION_DRAW;
    }
    return EXIT_FINE;
}

/* Sockets and modes are DRM's alone. */
static int check_drm(struct options *options)
{
    if (options->connector == NULL && options->mode == NULL) {
        return EXIT_FINE;
    }
    if (strcmp(options->display, "auto") == 0) {
        options->display = "drm";
    }
    if (strcmp(options->display, "drm") != 0) {
        return fail(EXIT_USAGE, "--%s: only the drm display has it (-d drm)",
                    options->connector != NULL ? "connector" : "mode");
    }
    return EXIT_FINE;
}

static int check(struct options *options)
{
    int result = check_names(options);
    if (result == EXIT_FINE) {
        result = check_output(options);
    }
    return result == EXIT_FINE ? check_drm(options) : result;
}

int options_parse(struct options *options, int argc, char **argv)
{
    *options = (struct options){.scene = &tia_thesis_scene,
                                .core = &tia_core_q16,
                                .display = "auto",
                                .input = "auto",
                                .threads = threads_processors()};
    opterr = 0;
    for (int option; (option = getopt_long(argc, argv, shorts, longs, NULL)) != -1;) {
        int result = option == ':' || option == '?' ? refuse(option, argv) : take(options, option, optarg);
        if (result != EXIT_FINE || options->action == ACTION_HELP || options->action == ACTION_VERSION) {
            return result;
        }
    }
    if (optind < argc) {
        return fail(EXIT_USAGE, "%.200s: scene files are not supported yet", argv[optind]);
    }
    return check(options);
}

void options_free(struct options *options)
{
    free(options->keys);
    options->keys = NULL;
}
