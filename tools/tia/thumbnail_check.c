#include "thumbnail_check.h"

#include <string.h>

#include "fail.h"

/* Returns the first given option that makes no sense for a thumbnail; NULL: none is given. */
static const char *foreign_option(const struct options *options)
{
    const struct {
        bool given;
        const char *name;
    } foreign[] = {{options->width, "size"},
                   {options->resume, "resume"},
                   {options->record, "record"},
                   {options->samples_range, "samples-range"},
                   {options->error, "error"},
                   {options->denoise, "denoise"},
                   {options->guide, "guide"},
                   {options->colour_given, "colour"},
                   {options->frames, "frames"},
                   {options->frame_range, "frame-range"},
                   {options->tile_rows, "tile-rows"},
                   {options->dither, "dither"},
                   {options->rotate, "rotate"},
                   {options->checksum, "checksum"},
                   {options->stats, "stats"},
                   {options->progress, "progress"},
                   {options->views.view, "view"},
                   {options->views.draws_rays, "draw-rays"},
                   {options->light.views, "views"},
                   {options->light.lenticular, "lenticular"},
                   {options->light.calibration, "calibration"},
                   {options->light.modules, "modules"},
                   {options->gazes, "gaze"}};

    for (size_t i = 0; i < sizeof foreign / sizeof *foreign; i++)
        if (foreign[i].given)
            return foreign[i].name;
    return NULL;
}

/* A model is fitted into a square. A scene keeps its camera, and the shape of the picture that tia draws by default. */
static void set_picture(struct options *options)
{
    bool scene = options->scene_format == TIA_FORMAT_TIA || options->scene_format == TIA_FORMAT_NFF;

    options->eye.fit = options->eye.fit || !scene;
    options->width = (uint16_t)options->thumbnail;
    options->height = (uint16_t)(options->eye.fit ? options->thumbnail : options->thumbnail * 3 / 4);
}

int thumbnail_check(struct options *options)
{
    const char *foreign = options->thumbnail ? foreign_option(options) : NULL;

    if (!options->thumbnail)
        return EXIT_FINE;
    if (foreign)
        return fail(EXIT_USAGE, "--%s: not with --thumbnail", foreign);
    if (!options->output || !image_format_has(options->format, 8))
        return fail(EXIT_USAGE, "--thumbnail: needs a .png or .ppm file (-o FILE)");
    if (!options->scene_path || strcmp(options->scene_path, "-") == 0)
        return fail(EXIT_USAGE, "--thumbnail: needs a SCENE that is a file");
    set_picture(options);
    return EXIT_FINE;
}
