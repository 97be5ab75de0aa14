#include "parse_option.h"

#include <string.h>

#include "arithmetic.h"
#include "common/parse.h"
#include "common/thread_pool.h"
#include "fail.h"
#include "gaze.h"
#include "integration.h"
#include "lightfield.h"

static int set_size(struct options *options, const char *value)
{
    if (!parse_size(value, NULL, TIA_SIZE_MAX, &options->width, &options->height))
        return wrong("--size", value, "not a size (1x1 to 8192x8192, like 640x480)");
    return EXIT_FINE;
}

static int set_format(struct options *options, const char *value)
{
    options->format = image_format_called(value);
    return options->format != IMAGE_UNKNOWN ? EXIT_FINE
                                            : wrong("--format", value, "not png, ppm, bmp, 565, pfm, y4m or tiapart");
}

static int set_scene_format(struct options *options, const char *value)
{
    options->scene_format = scene_format_called(value);
    return options->scene_format != SCENE_UNKNOWN ? EXIT_FINE : wrong("--scene-format", value, "not tia, nff or obj");
}

static int set_samples(struct options *options, const char *value)
{
    if (!parse_number(value, NULL, 1, TIA_SAMPLES_MAX, &options->samples) ||
        (options->samples != 1 && options->samples != 4 && options->samples != 16))
        return wrong("--samples", value, "not 1, 4 or 16");
    return EXIT_FINE;
}

static int set_time(struct options *options, const char *value)
{
    if (!parse_seconds(value, &options->time))
        return wrong("--time", value, "not a number of seconds (0 to 32767.999, like 1.25)");
    return EXIT_FINE;
}

static int set_rate(struct options *options, const char *value)
{
    options->rate_given = true;
    if (!parse_rate(value, options->rate))
        return wrong("--fps", value, "not a rate (1 to 1000000 frames, like 25 or 30000/1001)");
    return EXIT_FINE;
}

/* "A-B" with 0 <= A <= B. */
static int set_range(const char *option, const char *value, bool *given, uint32_t *first, uint32_t *last)
{
    const char *rest;
    *given = true;
    if (!parse_number(value, &rest, 0, UINT32_MAX - 1, first) || *rest != '-' ||
        !parse_number(rest + 1, NULL, *first, UINT32_MAX - 1, last))
        return wrong(option, value, "not a range (FIRST-LAST, counted from 0)");
    return EXIT_FINE;
}

static int set_number(const char *option, const char *value, uint32_t max, uint32_t *number)
{
    if (!parse_number(value, NULL, 1, max, number))
        return fail(EXIT_USAGE, "%s '%.200s': not a number from 1 to %u", option, value, max);
    return EXIT_FINE;
}

static int set_rotate(struct options *options, const char *value)
{
    if (!parse_number(value, NULL, 0, 270, &options->rotate) || options->rotate % 90 != 0)
        return wrong("--rotate", value, "not 0, 90, 180 or 270");
    return EXIT_FINE;
}

static int set_arithmetic(struct options *options, const char *value)
{
    options->core = arithmetic_called(value);
    if (options->core)
        return EXIT_FINE;
    return wrong("--arithmetic", value,
                 strcmp(value, "f64") == 0 ? "this build has q16 only (make F64=yes)" : "not q16 or f64");
}

/* Cuts "drm:/dev/dri/card1" into its name and device. */
static void set_device(char *value, const char **name, const char **device)
{
    char *colon = strchr(value, ':');
    *name = value;
    *device = colon && colon[1] != '\0' ? colon + 1 : NULL;
    if (colon)
        *colon = '\0';
}

static int set_connector(struct options *options, const char *value)
{
    if (strcmp(value, "help") == 0)
        options->action = ACTION_MODES;
    options->connector = value;
    return EXIT_FINE;
}

static int set_mode(struct options *options, const char *value)
{
    if (strcmp(value, "help") == 0)
        options->action = ACTION_MODES;
    else if (!parse_mode(value))
        return wrong("--mode", value, "not preferred, WxH or WxH@HERTZ (--mode help lists what there is)");
    options->mode = value;
    return EXIT_FINE;
}

/* Options without a value. */
static int set_flag(struct options *options, int option)
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
    case OPT_STATS_OVERLAY:
        options->stats_overlay = true;
        break;
    case OPT_PROGRESS:
        options->progress = true;
        break;
    case OPT_STRICT:
        options->strict = true;
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

static int set_shadows(struct options *options, const char *value)
{
    const char *name;

    for (unsigned i = 0; (name = tia_shadows_name(i)) != NULL; i++)
        if (!strcmp(name, value)) {
            options->shadows = i + 1;
            return EXIT_FINE;
        }
    return fail(EXIT_USAGE, "--shadows %.200s: not traced, rays, zpass, zfail, map, map-exact or zpass-plain", value);
}

static int set_map_size(struct options *options, const char *value)
{
    uint32_t size;

    if (!parse_number(value, NULL, TIA_MAP_SIZE_MIN, TIA_MAP_SIZE_MAX, &size) || (size & (size - 1)))
        return wrong("--map-size", value, "not 64, 128, 256, 512, 1024, 2048 or 4096");
    options->map.size = (uint16_t)size;
    return EXIT_FINE;
}

/* "none", or a bias and its amount: "slope=1.5". */
static int set_bias(struct options *options, const char *value)
{
    size_t length = strcspn(value, "=");
    const char *name;

    for (unsigned i = TIA_BIAS_NONE; (name = tia_bias_name(i)) != NULL; i++) {
        if (strncmp(name, value, length) != 0 || name[length] != '\0')
            continue;
        options->map.bias = (enum tia_bias)i;
        options->map.amount = 0;
        if (i == TIA_BIAS_NONE ? !value[length]
                               : value[length] && parse_seconds(value + length + 1, &options->map.amount))
            return EXIT_FINE;
    }
    return wrong("--bias", value, "not none, or constant, slope, normal or plane with an amount (slope=1.5)");
}

static int set_filter(struct options *options, const char *value)
{
    const char *name;

    for (unsigned i = TIA_FILTER_NONE; (name = tia_filter_name(i)) != NULL; i++)
        if (!strcmp(name, value)) {
            options->map.filter = (enum tia_filter)i;
            return EXIT_FINE;
        }
    return wrong("--filter", value, "not none, bilinear, 3x3, 5x5, 7x7, poisson or pcss");
}

/* Those of shadows. */
static int set_of_shadows(struct options *options, int option, const char *value)
{
    switch (option) {
    case OPT_MAP_SIZE:
        return set_map_size(options, value);
    case OPT_BIAS:
        return set_bias(options, value);
    case OPT_FILTER:
        return set_filter(options, value);
    case OPT_TESSELLATED:
        options->tessellated = value;
        return EXIT_FINE;
    default:
        return set_shadows(options, value);
    }
}

static int set_view(struct options *options, const char *value)
{
    const char *name;

    for (unsigned i = 0; (name = view_name(i)) != NULL; i++)
        if (!strcmp(name, value)) {
            options->views.view = (enum view)i;
            return EXIT_FINE;
        }
    return wrong("--view", value, "not colour, depth, normal, object, cost, light or path");
}

/* "X,Y" */
static int set_draw_rays(struct options *options, const char *value)
{
    const char *rest;
    uint32_t x, y;

    if (!parse_number(value, &rest, 0, TIA_SIZE_MAX - 1, &x) || *rest != ',' ||
        !parse_number(rest + 1, NULL, 0, TIA_SIZE_MAX - 1, &y))
        return wrong("--draw-rays", value, "not a pixel (X,Y from 0,0 at the upper left)");
    options->views.draws_rays = true;
    options->views.x = (uint16_t)x;
    options->views.y = (uint16_t)y;
    return EXIT_FINE;
}

int parse_option(struct options *options, int option, char *value)
{
    switch (option) {
    case 'd':
        set_device(value, &options->display, &options->display_device);
        return EXIT_FINE;
    case 'i':
        set_device(value, &options->input, &options->input_device);
        return EXIT_FINE;
    case 'o':
        options->output = value;
        return EXIT_FINE;
    case OPT_FORMAT:
        return set_format(options, value);
    case OPT_SCENE_FORMAT:
        return set_scene_format(options, value);
    case 's':
        return set_size(options, value);
    case OPT_SAMPLES:
        return set_samples(options, value);
    case OPT_DEPTH:
        return set_number("--depth", value, TIA_DEPTH_MAX, &options->depth);
    case OPT_SHADOWS:
    case OPT_MAP_SIZE:
    case OPT_BIAS:
    case OPT_FILTER:
    case OPT_TESSELLATED:
        return set_of_shadows(options, option, value);
    case OPT_INTEGRATOR:
    case OPT_SPP:
    case OPT_RESUME:
    case OPT_DENOISE:
    case OPT_GUIDE:
    case OPT_TIME_LIMIT:
    case OPT_ERROR:
    case OPT_TONE:
    case OPT_EXPOSURE:
    case OPT_COLOUR:
        return integration_parse(options, option, value);
    case 'k':
        options->key_text = value;
        return EXIT_FINE;
    case 'n':
        return set_number("--frames", value, UINT32_MAX, &options->frames);
    case OPT_TIME:
        return set_time(options, value);
    case OPT_FPS:
        return set_rate(options, value);
    case OPT_FRAME_RANGE:
        return set_range("--frame-range", value, &options->frame_range, &options->first_frame, &options->last_frame);
    case OPT_TILE_ROWS:
        return set_range("--tile-rows", value, &options->tile_rows, &options->first_row, &options->last_row);
    case OPT_SAMPLES_RANGE:
        return set_range("--samples-range", value, &options->samples_range, &options->first_sample,
                         &options->last_sample);
    case 'j':
        return set_number("--threads", value, THREADS_MAX, &options->threads);
    case OPT_ARITHMETIC:
        return set_arithmetic(options, value);
    case OPT_VIEW:
        return set_view(options, value);
    case OPT_DRAW_RAYS:
        return set_draw_rays(options, value);
    case OPT_GAZE:
    case OPT_VIEW_ANGLE:
    case OPT_W0:
    case OPT_M:
    case OPT_SMOOTH:
        return gaze_parse(options, option, value);
    case OPT_ROTATE:
        return set_rotate(options, value);
    case OPT_CONNECTOR:
        return set_connector(options, value);
    case OPT_MODE:
        return set_mode(options, value);
    default:
        return value ? light_parse(options, option, value) : set_flag(options, option);
    }
}
