#include "gaze_options.h"

#include "common/image/series.h"
#include "fail.h"

/* The viewing angle of a monitor of 24 inches, 53 cm wide, from 57 cm away. */
#define VIEW_ANGLE TIA_Q16(50)

/* Returns the first given option that needs a gaze; NULL: none is given. */
static const char *option_of(const struct options *options)
{
    return options->gaze.view_angle ? "view-angle"
           : options->w0_given      ? "w0"
           : options->m_given       ? "m"
           : options->gaze.smooth   ? "smooth"
                                    : NULL;
}

/* Checks the options for a file. With a gaze, it is a single RGB565 picture, drawn at once as on a display. */
static int check_file(const struct options *options)
{
    bool film = image_format_films(options->format) || image_format_has(options->format, 32) ||
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
    const char *option = option_of(options);

    if (!options->gazes)
        return option ? fail(EXIT_USAGE, "--%s: needs --gaze X,Y", option) : EXIT_FINE;
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
