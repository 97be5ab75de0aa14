#include "film_plan.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "common/checksum.h"
#include "common/image/series.h"
#include "eye_setup.h"
#include "fail.h"

enum { DEFAULT_WIDTH = 640, DEFAULT_HEIGHT = 480 };

tia_q16 film_time(const struct options *options, uint32_t frame)
{
    return options->light.pictures ? options->time : tia_viewer_frame_time(options->time, frame, options->rate);
}

struct rotation film_rotation(const struct options *options)
{
    return (struct rotation){options->rotate, options->width ? options->width : DEFAULT_WIDTH,
                             options->height ? options->height : DEFAULT_HEIGHT};
}

/* Returns the number of views, of modules, or of frames, as the options say; without them, the number of frames that
 * begin before the last keyframe, or 1. */
static uint32_t count_frames(const struct options *options)
{
    int64_t left = (int64_t)tia_scene_duration(&options->scene) - options->time;
    if (options->light.pictures != 0)
        return options->light.pictures;
    if (options->frames != 0)
        return options->frames;
    if (left <= 0)
        return 1;
    uint64_t whole = (uint64_t)options->rate[1] * 65536;
    uint64_t count = ((uint64_t)left * options->rate[0] + whole - 1) / whole;
    return count < UINT32_MAX ? (uint32_t)count : UINT32_MAX;
}

static int identify_field(char *text, size_t size, const struct light_options *light)
{
    const struct tia_light_field *f = &light->field;

    return snprintf(text, size, " %d %u %u %" PRId64 " %" PRId64 " %" PRId64 " %d %d %d %d %d", (int)f->kind,
                    f->quilt.columns, f->quilt.rows, f->lens.pitch, f->lens.rise, f->lens.centre,
                    (int)f->lens.subpixels, f->lens.flipped, f->lens.inverted, (int)f->projector.distance,
                    (int)light->spacing);
}

static int identify_camera(char *text, size_t size, const struct tia_camera *c)
{
    return snprintf(text, size, " %d %d %d %d %d %d %d %d %d %d %d %d %d", (int)c->eye.x, (int)c->eye.y, (int)c->eye.z,
                    (int)c->reference.x, (int)c->reference.y, (int)c->reference.z, (int)c->up.x, (int)c->up.y,
                    (int)c->up.z, (int)c->fov, (int)c->projection, (int)c->window.bottom, (int)c->window.top);
}

/* Returns a CRC of all data on which the pixels depend, except the size. The CRC is the same in all parts of a film. */
static uint32_t identify(const struct options *options)
{
    const struct tia_integration *how = &options->scene.integration;
    char text[640];
    const char *keys = options->key_text ? options->key_text : "";
    int length = snprintf(
        text, sizeof text, "%s %d %u %u %u %u %u %u %d %u %d %d %u/%u", options->core->name, options->dither,
        (unsigned)options->rotate, (unsigned)options->samples, (unsigned)options->depth, (unsigned)options->shadows,
        options->map.size, (unsigned)options->map.bias, (int)options->map.amount, (unsigned)options->map.filter,
        (int)options->scene.tessellated, (int)options->time, (unsigned)options->rate[0], (unsigned)options->rate[1]);
    if (how->integrator != TIA_WHITTED)
        length += snprintf(text + length, sizeof text - (size_t)length, " %u %d", (unsigned)how->integrator,
                           (int)how->distance);
    if (how->integrator != TIA_WHITTED && !options->samples_range && !(options->resume && options->depth_bits))
        length += snprintf(text + length, sizeof text - (size_t)length, " %u %u %d", (unsigned)how->spp,
                           (unsigned)how->tone, (int)how->exposure);
    if (options->eye.fit || eye_change(options))
        length += identify_camera(text + length, sizeof text - (size_t)length, &options->scene.camera);
    if (options->scene.field)
        length += identify_field(text + length, sizeof text - (size_t)length, &options->light);
    if (options->views.view || options->views.draws_rays)
        length += snprintf(text + length, sizeof text - (size_t)length, " %u %d %u %u", (unsigned)options->views.view,
                           options->views.draws_rays, (unsigned)options->views.x, (unsigned)options->views.y);
    return checksum_bytes(checksum_bytes(options->file.crc, text, (size_t)length), keys, strlen(keys));
}

static int plan_frames(const struct options *options, struct image_film *film)
{
    bool is_film = image_format_films(options->format) || series_is_pattern(options->output);
    film->all_frames = is_film ? count_frames(options) : 1;
    film->frames = film->all_frames;
    if (!is_film && options->frames > 1) {
        return fail(EXIT_USAGE, "%.200s: one picture for %u frames (name it .y4m, or with %%04d in its name)",
                    options->output, (unsigned)options->frames);
    }
    if (options->frame_range) {
        if (options->last_frame >= film->all_frames) {
            const char *what = options->light.module_range ? "module" : "frame";
            return fail(EXIT_USAGE, "--%s-range %u-%u: the last %s is %u", what, (unsigned)options->first_frame,
                        (unsigned)options->last_frame, what, (unsigned)film->all_frames - 1);
        }
        film->first_frame = options->first_frame;
        film->frames = options->last_frame - options->first_frame + 1;
    }
    return EXIT_FINE;
}

int film_plan(const struct options *options, struct image_film *film)
{
    struct rotation rotation = film_rotation(options);
    struct rotation back = rotation_inverse(&rotation);
    *film = (struct image_film){.width = back.width,
                                .height = back.height,
                                .rows = back.height,
                                .rate = {options->rate[0], options->rate[1]},
                                .crc = identify(options)};
    if (options->tile_rows) {
        if (options->last_row >= film->height) {
            return fail(EXIT_USAGE, "--tile-rows %u-%u: the picture ends with row %u", (unsigned)options->first_row,
                        (unsigned)options->last_row, film->height - 1);
        }
        film->first_row = options->first_row;
        film->rows = options->last_row - options->first_row + 1;
    }
    return plan_frames(options, film);
}
