#include "integration.h"

#include "common/image/series.h"
#include "common/parse.h"
#include "fail.h"
#include "surfaces.h"
#include <tia/debug.h>

static int load_exposure(const char *text, struct tia_integration *how)
{
    tia_q16 stops;

    if (!text)
        return EXIT_FINE;
    bool minus = *text == '-';
    if (!parse_seconds(text + minus, &stops) || stops > TIA_EXPOSURE_MAX)
        return wrong("--exposure", text, "not a number of stops (-24 to 24, like 1.5)");
    how->exposure = minus ? -stops : stops;
    return EXIT_FINE;
}

static int load_distance(const char *text, struct tia_scene *scene)
{
    if (text && (!parse_scaled(text, scene->scale_bits, &scene->integration.distance) || !scene->integration.distance))
        return fail(EXIT_USAGE, "--integrator ao=%.200s: not a distance (above 0, to %u, like 2.5)", text,
                    parse_longest(scene->scale_bits));
    return EXIT_FINE;
}

static bool is_sampled(const struct options *options)
{
    return options->scene.integration.integrator != TIA_WHITTED;
}

static int check_parts(const struct options *options)
{
    if (options->resume && !options->output)
        return fail(EXIT_USAGE, "--resume: is for files (-o FILE)");
    if (options->resume && series_has(options->output, options->resume))
        return fail(EXIT_USAGE, "--resume: needs a file of its own");
    if (!options->samples_range)
        return EXIT_FINE;
    if (!is_sampled(options) || !options->output)
        return fail(EXIT_USAGE, "--samples-range: is for files of --integrator ao and path");
    if (options->format != IMAGE_PART || options->spp)
        return fail(EXIT_USAGE, "--samples-range: needs a part file (-o FILE.tiapart), and no --spp");
    if (options->last_sample >= TIA_SPP_MAX)
        return fail(EXIT_USAGE, "--samples-range: a pixel has at most %u samples", (unsigned)TIA_SPP_MAX);
    if (options->frame_range || options->tile_rows || options->frames > 1 || options->checksum || options->dither ||
        options->rotate)
        return fail(EXIT_USAGE, "--samples-range: takes no --frames, --frame-range, --tile-rows, --checksum, --dither "
                                "or --rotate");
    return EXIT_FINE;
}

/* Returns the first given option that needs the samples of the whole picture; NULL: none is given. */
static const char *rounds_option(const struct options *options)
{
    return options->denoise      ? "denoise"
           : options->guide      ? "guide"
           : options->time_limit ? "time-limit"
           : options->error      ? "error"
                                 : NULL;
}

/* Checks --time-limit and --error, which need the samples of the whole picture in memory. */
static int check_limits(struct options *options)
{
    const char *option = options->time_limit ? "time-limit" : "error";
    unsigned width = options->width ? options->width : 640, height = options->height ? options->height : 480;

    if (options->resume)
        return fail(EXIT_USAGE, "--%s: not with --resume", option);
    if ((uint32_t)width * height > 1u << 24)
        return fail(EXIT_USAGE, "--%s: a picture of at most 16777216 pixels, not %ux%u", option, width, height);
    if (!options->spp && !options->samples_range)
        options->scene.integration.spp = TIA_SPP_MAX;
    return EXIT_FINE;
}

/* Checks --denoise, --guide, --time-limit and --error; after choose_depth. */
static int check_rounds(struct options *options)
{
    const char *option = rounds_option(options);

    if (!option)
        return EXIT_FINE;
    if (!is_sampled(options) || !options->output || !options->depth_bits)
        return fail(EXIT_USAGE, "--%s: is for .png, .ppm, .pfm and .exr files of --integrator ao and path", option);
    if (options->format == IMAGE_PART && (options->denoise || options->guide))
        return fail(EXIT_USAGE, "--%s: not with parts of samples", option);
    if (options->denoise && options->guide)
        return fail(EXIT_USAGE, "--guide: not with --denoise, which it shows the guides of");
    if (options->guide && !options->tone)
        options->scene.integration.tone = TIA_TONE_LINEAR;
    return options->time_limit || options->error ? check_limits(options) : EXIT_FINE;
}

/* Chooses floats for a .pfm, which only samples have, or an .exr; `plain`: other options need RGB565. */
static int choose_floats(struct options *options, bool plain)
{
    bool exr = options->format == IMAGE_EXR, sampled = is_sampled(options);
    unsigned width = options->width ? options->width : 640, height = options->height ? options->height : 480;

    if ((!sampled && !exr) || plain || options->colour_given)
        return fail(EXIT_USAGE, "%.200s: floats are %s, without --colour, --checksum, --dither and --rotate",
                    options->output, exr ? "one picture" : "what --integrator ao and path draw");
    if (exr && !sampled && (options->resume || options->views.view || options->views.draws_rays))
        return fail(EXIT_USAGE, "%.200s: not with --resume, --view and --draw-rays, which take 565 of whitted",
                    options->output);
    if (exr && options->record)
        return fail(EXIT_USAGE, "--record: not of an .exr (use .pfm, or .png with --colour 16)");
    if (exr && (uint32_t)width * height > SURFACES_MOST)
        return fail(EXIT_USAGE, "%.200s: a picture of at most %u pixels, not %ux%u", options->output, SURFACES_MOST,
                    width, height);
    options->simd = sampled ? options->simd : NULL;
    options->depth_bits = 32;
    return EXIT_FINE;
}

/* Chooses the bits of a channel. By default, pictures of samples have 8 bits where the format has them, but RGB565 if
 * an option needs that. */
static int choose_depth(struct options *options)
{
    bool sampled = is_sampled(options);
    bool series = options->output && series_is_pattern(options->output);
    bool plain = options->checksum || options->dither || options->rotate || options->light.pictures || series;

    if (options->depth_bits && !sampled && !options->output)
        return fail(EXIT_USAGE, "--colour: displays have 565 (-o FILE)");
    if (options->depth_bits && !sampled && (options->resume || options->views.view || options->views.draws_rays))
        return fail(EXIT_USAGE, "--colour: --resume, --view and --draw-rays take 565 of whitted");
    if (options->depth_bits && !sampled)
        options->simd = NULL; /* vector units draw only RGB565 */
    if (options->colour_given && options->depth_bits && plain)
        return fail(EXIT_USAGE, "--colour: films, --checksum, --dither, --rotate, --views and --modules take 565");
    if (options->output && image_format_has(options->format, 32))
        return choose_floats(options, plain);
    if (options->samples_range)
        options->depth_bits = 32;
    if (options->samples_range)
        return EXIT_FINE;
    if (!options->colour_given && sampled && !plain && image_format_has(options->format, 8))
        options->depth_bits = 8;
    if (options->output && !image_format_has(options->format, options->depth_bits))
        return fail(EXIT_USAGE, "--colour: .%s files have 565 (use .png or .ppm)", image_format_name(options->format));
    return EXIT_FINE;
}

static bool shines(const struct tia_rgb *colour)
{
    return colour->r || colour->g || colour->b;
}

/* Warns if no light, material or background emits light, so that the picture is black. */
static void warn_of_darkness(const struct tia_scene *scene)
{
    bool bright = shines(&scene->background) || scene->binding_count > 0;

    for (uint32_t i = 0; i < scene->material_count && !bright; i++)
        bright = shines(&scene->materials[i].emission) || shines(&scene->materials[i].facing);
    for (uint32_t i = 0; i < scene->light_count && !bright; i++)
        bright = tia_light_has(scene->lights[i].kind, TIA_LIGHT_PATHS) && shines(&scene->lights[i].emission);
    if (!bright)
        note("--integrator path: nothing shines in this scene: it will be black");
}

int integration_load(struct options *options)
{
    struct tia_integration *how = &options->scene.integration;

    if (options->integrator.number) {
        how->integrator = (enum tia_integrator)(options->integrator.number - 1);
        how->distance = 0;
    }
    how->spp = options->spp ? options->spp : how->spp;
    how->tone = options->tone ? (enum tia_tone)options->tone : how->tone;
    if (how->integrator == TIA_WHITTED && (options->spp || options->tone || options->exposure))
        return fail(EXIT_USAGE, "--%s: whitted has none (--integrator ao or path)",
                    options->spp    ? "spp"
                    : options->tone ? "tone"
                                    : "exposure");
    int status = load_exposure(options->exposure, how);
    status = status ? status : load_distance(options->integrator.distance, &options->scene);
    if (!status && how->integrator == TIA_PATHS)
        warn_of_darkness(&options->scene);
    status = status ? status : check_parts(options);
    status = status ? status : choose_depth(options);
    return status ? status : check_rounds(options);
}
