#include "parse_option.h"

#include <stddef.h>
#include <string.h>

#include "arithmetic.h"
#include "common/parse.h"
#include "common/thread_pool.h"
#include "fail.h"
#include "gaze.h"
#include "integration.h"
#include "lightfield.h"

static int set_size(struct options *options, char *value)
{
    if (!parse_size(value, NULL, TIA_SIZE_MAX, &options->width, &options->height))
        return wrong("--size", value, "not a size (1x1 to 8192x8192, like 640x480)");
    return EXIT_FINE;
}

static int set_format(struct options *options, char *value)
{
    options->format = image_format_called(value);
    return options->format != IMAGE_UNKNOWN ? EXIT_FINE
                                            : wrong("--format", value, "not png, ppm, bmp, 565, pfm, y4m or tiapart");
}

static int set_scene_format(struct options *options, char *value)
{
    options->scene_format = scene_format_called(value);
    return options->scene_format != SCENE_UNKNOWN ? EXIT_FINE : wrong("--scene-format", value, "not tia, nff or obj");
}

static int set_samples(struct options *options, char *value)
{
    if (!parse_number(value, NULL, 1, TIA_SAMPLES_MAX, &options->samples) ||
        (options->samples != 1 && options->samples != 4 && options->samples != 16))
        return wrong("--samples", value, "not 1, 4 or 16");
    return EXIT_FINE;
}

static int set_time(struct options *options, char *value)
{
    if (!parse_seconds(value, &options->time))
        return wrong("--time", value, "not a number of seconds (0 to 32767.999, like 1.25)");
    return EXIT_FINE;
}

static int set_rate(struct options *options, char *value)
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

static int set_depth(struct options *options, char *value)
{
    return set_number("--depth", value, TIA_DEPTH_MAX, &options->depth);
}

static int set_frames(struct options *options, char *value)
{
    return set_number("--frames", value, UINT32_MAX, &options->frames);
}

static int set_threads(struct options *options, char *value)
{
    return set_number("--threads", value, THREADS_MAX, &options->threads);
}

static int set_frame_range(struct options *options, char *value)
{
    return set_range("--frame-range", value, &options->frame_range, &options->first_frame, &options->last_frame);
}

static int set_tile_rows(struct options *options, char *value)
{
    return set_range("--tile-rows", value, &options->tile_rows, &options->first_row, &options->last_row);
}

static int set_samples_range(struct options *options, char *value)
{
    return set_range("--samples-range", value, &options->samples_range, &options->first_sample, &options->last_sample);
}

static int set_rotate(struct options *options, char *value)
{
    if (!parse_number(value, NULL, 0, 270, &options->rotate) || options->rotate % 90 != 0)
        return wrong("--rotate", value, "not 0, 90, 180 or 270");
    return EXIT_FINE;
}

static int set_arithmetic(struct options *options, char *value)
{
    options->core = arithmetic_called(value);
    if (options->core)
        return EXIT_FINE;
    return wrong("--arithmetic", value, arithmetic_missing(value));
}

/* Cuts "drm:/dev/dri/card1" into its name and device. */
static int cut_device(char *value, const char **name, const char **device)
{
    char *colon = strchr(value, ':');
    *name = value;
    *device = colon && colon[1] != '\0' ? colon + 1 : NULL;
    if (colon)
        *colon = '\0';
    return EXIT_FINE;
}

static int set_display(struct options *options, char *value)
{
    return cut_device(value, &options->display, &options->display_device);
}

static int set_input(struct options *options, char *value)
{
    return cut_device(value, &options->input, &options->input_device);
}

static int set_connector(struct options *options, char *value)
{
    if (strcmp(value, "help") == 0)
        options->action = ACTION_MODES;
    options->connector = value;
    return EXIT_FINE;
}

static int set_mode(struct options *options, char *value)
{
    if (strcmp(value, "help") == 0)
        options->action = ACTION_MODES;
    else if (!parse_mode(value))
        return wrong("--mode", value, "not preferred, WxH or WxH@HERTZ (--mode help lists what there is)");
    options->mode = value;
    return EXIT_FINE;
}

static int set_shadows(struct options *options, char *value)
{
    const char *name;

    for (unsigned i = 0; (name = tia_shadows_name(i)) != NULL; i++)
        if (!strcmp(name, value)) {
            options->shadows = i + 1;
            return EXIT_FINE;
        }
    return fail(EXIT_USAGE, "--shadows %.200s: not traced, rays, zpass, zfail, map, map-exact or zpass-plain", value);
}

static int set_map_size(struct options *options, char *value)
{
    uint32_t size;

    if (!parse_number(value, NULL, TIA_MAP_SIZE_MIN, TIA_MAP_SIZE_MAX, &size) || (size & (size - 1)))
        return wrong("--map-size", value, "not 64, 128, 256, 512, 1024, 2048 or 4096");
    options->map.size = (uint16_t)size;
    return EXIT_FINE;
}

/* "none", or a bias and its amount: "slope=1.5". */
static int set_bias(struct options *options, char *value)
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

static int set_filter(struct options *options, char *value)
{
    const char *name;

    for (unsigned i = TIA_FILTER_NONE; (name = tia_filter_name(i)) != NULL; i++)
        if (!strcmp(name, value)) {
            options->map.filter = (enum tia_filter)i;
            return EXIT_FINE;
        }
    return wrong("--filter", value, "not none, bilinear, 3x3, 5x5, 7x7, poisson or pcss");
}

static int set_view(struct options *options, char *value)
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
static int set_draw_rays(struct options *options, char *value)
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

/* What an option does: one of these. Offsets are in struct options, whose first member is none of them. The last row is
 * for the letter that is left. */
struct row {
    int option;
    int (*set)(struct options *options, char *value);
    int (*parse)(struct options *options, int option, char *value);
    size_t text, flag;  /* the member that becomes the value; the one that becomes true */
    enum action action; /* what to do instead of showing a scene */
};

#define TEXT(member) .text = offsetof(struct options, member)
#define FLAG(member) .flag = offsetof(struct options, member)

static const struct row rows[] = {
    {'d', .set = set_display},
    {'i', .set = set_input},
    {'o', TEXT(output)},
    {OPT_FORMAT, .set = set_format},
    {OPT_SCENE_FORMAT, .set = set_scene_format},
    {'s', .set = set_size},
    {OPT_SAMPLES, .set = set_samples},
    {OPT_DEPTH, .set = set_depth},
    {OPT_SHADOWS, .set = set_shadows},
    {OPT_MAP_SIZE, .set = set_map_size},
    {OPT_BIAS, .set = set_bias},
    {OPT_FILTER, .set = set_filter},
    {OPT_TESSELLATED, TEXT(tessellated)},
    {OPT_INTEGRATOR, .parse = integration_parse},
    {OPT_SPP, .parse = integration_parse},
    {OPT_RESUME, .parse = integration_parse},
    {OPT_DENOISE, .parse = integration_parse},
    {OPT_GUIDE, .parse = integration_parse},
    {OPT_TIME_LIMIT, .parse = integration_parse},
    {OPT_ERROR, .parse = integration_parse},
    {OPT_TONE, .parse = integration_parse},
    {OPT_EXPOSURE, .parse = integration_parse},
    {OPT_COLOUR, .parse = integration_parse},
    {OPT_GAZE, .parse = gaze_parse},
    {OPT_VIEW_ANGLE, .parse = gaze_parse},
    {OPT_W0, .parse = gaze_parse},
    {OPT_M, .parse = gaze_parse},
    {OPT_SMOOTH, .parse = gaze_parse},
    {OPT_VIEWS, .parse = light_parse},
    {OPT_LENTICULAR, .parse = light_parse},
    {OPT_CALIBRATION, .parse = light_parse},
    {OPT_MODULES, .parse = light_parse},
    {OPT_MODULE_RANGE, .parse = light_parse},
    {'k', TEXT(key_text)},
    {'n', .set = set_frames},
    {OPT_TIME, .set = set_time},
    {OPT_FPS, .set = set_rate},
    {OPT_FRAME_RANGE, .set = set_frame_range},
    {OPT_TILE_ROWS, .set = set_tile_rows},
    {OPT_SAMPLES_RANGE, .set = set_samples_range},
    {'j', .set = set_threads},
    {OPT_ARITHMETIC, .set = set_arithmetic},
    {OPT_VIEW, .set = set_view},
    {OPT_DRAW_RAYS, .set = set_draw_rays},
    {OPT_ROTATE, .set = set_rotate},
    {OPT_CONNECTOR, .set = set_connector},
    {OPT_MODE, .set = set_mode},
    {OPT_DITHER, FLAG(dither)},
    {OPT_CHECKSUM, FLAG(checksum)},
    {OPT_STATS, FLAG(stats)},
    {OPT_STATS_OVERLAY, FLAG(stats_overlay)},
    {OPT_PROGRESS, FLAG(progress)},
    {OPT_STRICT, FLAG(strict)},
    {OPT_LIST, .action = ACTION_LIST},
    {'h', .action = ACTION_HELP},
    {0, .action = ACTION_VERSION},
};

int parse_option(struct options *options, int option, char *value)
{
    const struct row *row = rows;

    while (row->option && row->option != option)
        row++;
    if (row->set)
        return row->set(options, value);
    if (row->parse)
        return row->parse(options, option, value);
    if (row->text)
        *(const char **)(void *)((char *)options + row->text) = value;
    else if (row->flag)
        *(bool *)(void *)((char *)options + row->flag) = true;
    else
        options->action = row->action;
    return EXIT_FINE;
}
