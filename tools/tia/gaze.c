#include "gaze.h"

#include "common/image/series.h"
#include "common/parse.h"
#include "fail.h"
#include "option_codes.h"

/* The viewing angle of a monitor of 24 inches, 53 cm wide, from 57 cm away. */
#define VIEW_ANGLE TIA_Q16(50)

enum { ACUITY_BITS = 8 }; /* w0 and m are Q8.24 */

static int set_gaze(struct options *options, const char *value)
{
    const char *rest;
    uint32_t x, y;

    if (!parse_number(value, &rest, 0, UINT16_MAX, &x) || *rest != ',' ||
        !parse_number(rest + 1, NULL, 0, UINT16_MAX, &y))
        return wrong("--gaze", value, "not a pixel (X,Y from 0,0 at the upper left)");
    options->gazes = true;
    options->gaze.x = (uint16_t)x;
    options->gaze.y = (uint16_t)y;
    return EXIT_FINE;
}

static int set_angle(struct options *options, const char *value)
{
    options->gaze_option = "view-angle";
    if (!parse_seconds(value, &options->gaze.view_angle) || options->gaze.view_angle < TIA_FOV_MIN ||
        options->gaze.view_angle > TIA_FOV_MAX)
        return wrong("--view-angle", value, "not an angle (1 to 170 degrees)");
    return EXIT_FINE;
}

static int set_acuity(const char *option, const char *value, uint32_t *number)
{
    tia_q16 scaled;

    if (!parse_scaled(value, ACUITY_BITS, &scaled))
        return wrong(option, value, "not a number from 0 to 127 (like 0.0275)");
    *number = (uint32_t)scaled;
    return EXIT_FINE;
}

int gaze_parse(struct options *options, int option, char *value)
{
    switch (option) {
    case OPT_GAZE:
        return set_gaze(options, value);
    case OPT_VIEW_ANGLE:
        return set_angle(options, value);
    case OPT_W0:
        options->gaze_option = "w0";
        return set_acuity("--w0", value, &options->gaze.w0);
    case OPT_M:
        options->gaze_option = "m";
        return set_acuity("--m", value, &options->gaze.m);
    default:
        options->gaze_option = "smooth";
        options->gaze.smooth = true;
        return EXIT_FINE;
    }
}

/* A file is a picture of the display's bits, since it is drawn as for one. */
static int check_file(const struct options *options)
{
    bool film = image_format_films(options->format) || options->format == IMAGE_PFM ||
                series_is_pattern(options->output) || options->depth_bits;

    if (options->resume)
        return fail(EXIT_USAGE, "--resume: not with --gaze, which draws at once");
    return film ? fail(EXIT_USAGE, "--gaze: a file is one picture (.png, .ppm, .bmp or .565), drawn at once")
                : EXIT_FINE;
}

int gaze_check(struct options *options)
{
    unsigned width = options->width ? options->width : 640, height = options->height ? options->height : 480;
    const struct tia_gaze *gaze = &options->gaze;

    if (!options->gazes)
        return options->gaze_option ? fail(EXIT_USAGE, "--%s: needs --gaze X,Y", options->gaze_option) : EXIT_FINE;
    if ((options->output || options->width) && (gaze->x >= width || gaze->y >= height))
        return fail(EXIT_USAGE, "--gaze %u,%u: outside the picture, %ux%u", gaze->x, gaze->y, width, height);
    return options->output ? check_file(options) : EXIT_FINE;
}

struct tia_gaze gaze_of(const struct options *options)
{
    struct tia_gaze gaze = options->gaze;

    gaze.view_angle = !options->gazes ? 0 : gaze.view_angle ? gaze.view_angle : VIEW_ANGLE;
    return gaze;
}
