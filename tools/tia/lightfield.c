#include "lightfield.h"

#include <stdlib.h>
#include <string.h>

#include "common/image/series.h"
#include "fail.h"
#include "lenticular.h"
#include "option_codes.h"
#include "parse.h"
#include "quilt.h"

enum { PICTURES_MAX = 65536 };

/* ---- the command line alone ---- */

static int set_module_range(struct options *options, const char *value)
{
    const char *rest;

    options->light.module_range = options->frame_range = true;
    if (!parse_number(value, &rest, 0, PICTURES_MAX - 1, &options->first_frame) || *rest != '-' ||
        !parse_number(rest + 1, NULL, options->first_frame, PICTURES_MAX - 1, &options->last_frame))
        return wrong("--module-range", value, "not a range (FIRST-LAST, counted from 0)");
    return EXIT_FINE;
}

int light_parse(struct options *options, int option, const char *value)
{
    struct light_options *light = &options->light;

    switch (option) {
    case OPT_VIEWS:
        if (!parse_number(value, NULL, 1, PICTURES_MAX, &light->views))
            return wrong("--views", value, "not a number from 1 to 65536");
        return EXIT_FINE;
    case OPT_LENTICULAR:
        light->lenticular = true;
        return lenticular_parse(&light->field.lens, value);
    case OPT_CALIBRATION:
        light->calibration = value;
        return EXIT_FINE;
    case OPT_MODULES:
        light->modules = value;
        return EXIT_FINE;
    default:
        return set_module_range(options, value);
    }
}

/* The option that asks for a light field; NULL: none. */
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
    if (options->tile_rows || options->samples_range || options->resume || options->format == IMAGE_PFM)
        return fail(EXIT_USAGE, "--%s: draws whole pictures in RGB565", option);
    return EXIT_FINE;
}

int light_check(struct options *options)
{
    struct light_options *light = &options->light;
    struct tia_quilt quilt;
    uint32_t aspect;
    bool quilted = options->output && quilt_named(options->output, &quilt, &aspect);

    if (light->module_range && !light->modules)
        return fail(EXIT_USAGE, "--module-range: needs --modules");
    if ((light->modules != NULL) + (light->views != 0) + (light->calibration != NULL) + light->lenticular + quilted > 1)
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

/* "distance=0.5" */
static bool set_length(const char *field, const char *name, unsigned scale_bits, tia_q16 *length)
{
    size_t size = strlen(name);

    return strncmp(field, name, size) == 0 && field[size] == '=' &&
           parse_scaled(field + size + 1, scale_bits, length) && *length > 0;
}

/* As far from the screen as half the observer line is; so wide apart that all of the line gets all of the screen: each
 * end of it sees each edge of the screen before a module. */
static tia_q16 spacing_of(const struct tia_camera *camera, tia_q16 distance, uint32_t modules)
{
    double part = (double)distance / camera->window.near;
    double screen = ((double)camera->window.right - camera->window.left) / 2;
    double reach = screen + (screen + camera->line) * part;
    double spacing = 2 * reach / modules;

    return spacing < INT32_MAX ? (tia_q16)spacing + 1 : INT32_MAX;
}

static int check_places(const struct options *options, uint32_t modules)
{
    if ((int64_t)options->light.spacing * (modules - 1) / 2 > INT32_MAX)
        return wrong("--modules", options->light.modules, "farther from the screen's middle than 32768");
    return EXIT_FINE;
}

static int load_modules(struct options *options)
{
    struct light_options *light = &options->light;
    const struct tia_camera *camera = &options->scene.camera;
    tia_q16 *distance = &light->field.projector.distance;
    const char *text = light->modules, *rest;
    unsigned bits = options->scene.scale_bits;
    uint32_t modules;

    *distance = camera->window.near / 2 > 0 ? camera->window.near / 2 : 1;
    light->spacing = 0;
    if (!parse_number(text, &rest, 1, PICTURES_MAX, &modules) || (*rest != '\0' && *rest != ','))
        return wrong("--modules", text, "not a number from 1 to 65536 (32,distance=0.5,spacing=0.02)");
    char *copy = strdup(*rest ? rest + 1 : ""), *left = copy, *field;
    bool good = copy != NULL;
    while (good && *rest && (field = strsep(&left, ",")) != NULL)
        good = set_length(field, "distance", bits, distance) || set_length(field, "spacing", bits, &light->spacing);
    free(copy);
    if (!good)
        return wrong("--modules", text, "not distance=L or spacing=L, lengths above 0 (32,distance=0.5,spacing=0.02)");
    if (!light->spacing)
        light->spacing = spacing_of(camera, *distance, modules);
    light->field.kind = TIA_PROJECTOR;
    light->pictures = modules;
    return check_places(options, modules);
}

static int load_lens(struct options *options)
{
    struct light_options *light = &options->light;
    int status = light->calibration ? calibration_read(light, light->calibration) : EXIT_FINE;

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

void light_picture(struct tia_scene *scene, struct tia_light_field *field, const struct options *options,
                   uint32_t picture)
{
    const struct light_options *light = &options->light;
    const struct tia_camera line = scene->camera;
    int64_t twice = (2 * (int64_t)picture - (light->pictures - 1)) * light->spacing;

    if (light->views) {
        tia_light_field_camera(&scene->camera, &line, tia_light_field_place(&line, picture, light->views));
        return;
    }
    *field = light->field;
    field->projector.place = (tia_q16)((twice + 1) >> 1);
    scene->field = field;
}
