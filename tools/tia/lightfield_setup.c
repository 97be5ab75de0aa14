#include "lightfield_setup.h"

#include <stdlib.h>
#include <string.h>

#include "common/image/series.h"
#include "common/lenticular.h"
#include "common/modules.h"
#include "common/quilt.h"
#include "fail.h"

/* ---- the command line alone ---- */

/* Copies the panel's lens to the options. If `status` is an error, prints its message; returns the exit status. */
static int take_lens(struct light_options *light, const struct lenticular *panel, int status)
{
    if (status)
        return fail(status == TIA_ERR_RANGE ? EXIT_USAGE : EXIT_RUNNING, "%s", panel->why);
    light->field.lens = panel->lens;
    light->width = panel->width;
    light->height = panel->height;
    return EXIT_FINE;
}

static int parse_lens(struct light_options *light)
{
    struct lenticular panel;

    return take_lens(light, &panel, lenticular_parse(&panel, light->lenticular));
}

static int read_lens(struct light_options *light)
{
    struct lenticular panel;

    return take_lens(light, &panel, calibration_read(&panel, light->calibration));
}

/* Returns the first given option for a light field; NULL: none is given. */
static const char *option_of(const struct light_options *light)
{
    return light->modules       ? "modules"
           : light->views       ? "views"
           : light->calibration ? "calibration"
           : light->lenticular  ? "lenticular"
                                : NULL;
}

static int check_pictures(const struct options *options)
{
    const char *option = options->light.modules ? "modules" : "views";

    if (!options->output || !series_is_pattern(options->output))
        return fail(EXIT_USAGE, "--%s: needs a picture each (-o NAME%%03d.png)", option);
    if (options->frames || options->rate_given)
        return fail(EXIT_USAGE, "--%s: not with --frames or --fps: its pictures are of one time", option);
    if (options->tile_rows || options->samples_range || options->resume || image_format_has(options->format, 32))
        return fail(EXIT_USAGE, "--%s: draws whole pictures in RGB565", option);
    return EXIT_FINE;
}

int light_check(struct options *options)
{
    struct light_options *light = &options->light;
    struct tia_quilt quilt;
    uint32_t aspect;
    bool quilted = options->output && quilt_named(options->output, &quilt, &aspect);
    int fields = (light->modules != NULL) + (light->views != 0) + (light->calibration != NULL) +
                 (light->lenticular != NULL) + quilted;

    int status = light->lenticular ? parse_lens(light) : EXIT_FINE;
    if (status != EXIT_FINE)
        return status;
    options->frame_range = options->frame_range || light->module_range;
    if (light->module_range && !light->modules)
        return fail(EXIT_USAGE, "--module-range: needs --modules");
    if (fields > 1)
        return fail(EXIT_USAGE, "--%s: not with %s", option_of(light), quilted ? "a quilt" : "another light field");
    return light->modules || light->views ? check_pictures(options) : EXIT_FINE;
}

/* ---- the scene ---- */

static int load_quilt(struct options *options, uint32_t aspect)
{
    const struct tia_window *w = &options->scene.camera.window;
    uint64_t wide = (uint64_t)((int64_t)w->right - w->left) * 1000, high = (uint64_t)((int64_t)w->top - w->bottom);

    options->light.field.kind = TIA_QUILT;
    if (!options->width)
        quilt_size(&options->light.field.quilt, aspect, &options->width, &options->height);
    if (wide * 100 < high * aspect * 99 || wide * 100 > high * aspect * 101)
        note("%.200s: the scene's screen has the aspect ratio %.3f", options->output,
             (double)wide / (double)high / 1000);
    return EXIT_FINE;
}

static int load_modules(struct options *options)
{
    struct light_options *light = &options->light;
    struct modules modules;
    const char *why = modules_parse(&modules, light->modules, &options->scene);

    if (why)
        return wrong("--modules", light->modules, why);
    light->field.kind = TIA_PROJECTOR;
    light->field.projector.distance = modules.distance;
    light->spacing = modules.spacing;
    light->pictures = modules.count;
    return EXIT_FINE;
}

static int load_lens(struct options *options)
{
    struct light_options *light = &options->light;
    int status = light->calibration ? read_lens(light) : EXIT_FINE;

    light->field.kind = TIA_LENTICULAR;
    if (status == EXIT_FINE && light->calibration && options->output && !options->width) {
        options->width = light->width;
        options->height = light->height;
    }
    return status;
}

void light_attach(struct options *options)
{
    const struct tia_light_field *field = options->light.has_field ? &options->light.field : NULL;

    options->scene.field = options->plain_scene.field = field;
}

int light_load(struct options *options)
{
    struct light_options *light = &options->light;
    const char *option = option_of(light);
    uint32_t aspect;
    bool quilted = !option && options->output && quilt_named(options->output, &light->field.quilt, &aspect);

    light->has_field = false;
    light->pictures = light->views;
    if (!option && !quilted)
        return EXIT_FINE;
    if (!options->scene.camera.line)
        return fail(EXIT_USAGE, "%s%.200s: needs a scene with an observer line (camera lightfield)", option ? "--" : "",
                    option ? option : options->output);
    if (options->scene.shadows && !light->views)
        return fail(EXIT_USAGE, "--shadows %s: not in pictures for many eyes (--shadows traced)",
                    tia_shadows_name(options->scene.shadows));
    if (options->denoise && !light->views)
        return fail(EXIT_USAGE, "--denoise: not in pictures for many eyes");
    light->has_field = !light->views;
    int status = light->modules ? load_modules(options)
                 : quilted      ? load_quilt(options, aspect)
                 : light->views ? EXIT_FINE
                                : load_lens(options);
    light_attach(options);
    return status;
}
