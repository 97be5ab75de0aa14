/* draw.c - draws a picture, or a film frame by frame, into a file. */
#include "draw.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "clock.h"
#include "common/image/series.h"
#include "fail.h"
#include "film_plan.h"
#include "film_scene.h"
#include "picture.h"
#include "ports.h"
#include "sample_picture.h"
#include "stats.h"
#include "surfaces.h"

struct drawing {
    const struct options *options;
    struct image_film film;
    struct film_scene film_scene;
    struct picture picture;
    struct finished finished;
    struct series series;
    struct image_surface *surfaces; /* of an .exr; to be freed by free() */
    uint64_t start_us;              /* time when the frame was begun */
    bool no_output;                 /* writing a line of --checksum failed */
    char why[PORT_WHY];
};

static struct stats stats; /* static, since it is too large for the stack */

static int end_frame(struct drawing *drawing, uint32_t frame)
{
    int status = tap_chooses(drawing->options->tap) ? TIA_OK : series_end(&drawing->series);
    uint64_t now = clock_now_us();
    if (status)
        return status;
    if (drawing->options->checksum)
        progress_erase(&drawing->picture.progress);
    if (drawing->options->checksum &&
        (printf("%" PRIu32 " %08" PRIx32 "\n", frame, drawing->picture.crc) < 0 || fflush(stdout) != 0)) {
        drawing->no_output = true;
        return TIA_ERR_DEVICE;
    }
    stats.frames++;
    stats_add(&stats.draw, now - drawing->start_us);
    drawing->start_us = now;
    return TIA_OK;
}

static int draw_frame(struct drawing *drawing, uint32_t frame)
{
    const struct image_film *film = &drawing->film;
    bool known = finished_has(&drawing->finished, frame, film->first_row, film->rows);
    int status = known ? TIA_OK : film_scene_update(&drawing->film_scene, frame);
    if (!status && !tap_chooses(drawing->options->tap))
        status = series_begin(&drawing->series, frame);
    if (status)
        return status;
    drawing->picture.view = drawing->film_scene.view;
    drawing->picture.image = drawing->series.image;
    drawing->picture.frame = frame;
    status = picture_draw(&drawing->picture);
    return !status ? end_frame(drawing, frame) : status;
}

static int draw_film(struct drawing *drawing)
{
    const struct image_film *film = &drawing->film;
    int status = TIA_OK;
    const struct row_tap *tap = drawing->options->tap;
    for (uint32_t i = 0; i < film->frames && !status; i++)
        if (tap_wants_any(tap, film->first_frame + i, film->first_row, film->rows))
            status = draw_frame(drawing, film->first_frame + i);
    if (tap_chooses(tap))
        return status;
    if (status) {
        series_discard(&drawing->series);
        return status;
    }
    return series_finish(&drawing->series);
}

static int draw_all(struct drawing *drawing)
{
    int status = picture_begin(&drawing->picture, drawing->options, &drawing->film);
    if (!status && drawing->options->format == IMAGE_EXR)
        status = surfaces_find(&drawing->surfaces, drawing->options, drawing->why);
    drawing->series.film.surfaces = drawing->surfaces;
    if (!status)
        status = film_scene_begin(&drawing->film_scene, drawing->options, drawing->why);
    if (!status && drawing->options->resume) {
        drawing->picture.finished = &drawing->finished;
        status = finished_open(&drawing->finished, drawing->options->resume, &drawing->film, drawing->why);
    }
    return !status ? draw_film(drawing) : status;
}

/* Prints the figures of --stats, as for a display. */
static int print_stats(const struct drawing *drawing)
{
    const struct tia_view *view = drawing->film_scene.view;
    stats.display = "file";
    stats.format = image_format_name(drawing->options->format);
    stats.width = drawing->picture.rotation.width;
    stats.height = drawing->picture.rotation.height;
    stats.scale_bits = drawing->options->scene.scale_bits;
    stats.simd = view ? tia_view_simd(view) : "plain"; /* no view: all rows were in the file of --resume */
    stats.threads = threads_count(drawing->picture.pool);
    return stats_print(&stats) == 0 ? EXIT_FINE : EXIT_RUNNING;
}

static int report(const struct drawing *drawing, int status)
{
    if (drawing->no_output)
        return fail_output();
    if (status) {
        return fail(status == TIA_ERR_RANGE ? EXIT_USAGE : EXIT_RUNNING, "%s",
                    drawing->why[0] != '\0' ? drawing->why : fail_reason(status));
    }
    return drawing->options->stats ? print_stats(drawing) : EXIT_FINE;
}

int draw(const struct options *options)
{
    struct drawing drawing = {.options = options, .start_us = clock_now_us()};
    int status = film_plan(options, &drawing.film);
    if (status != EXIT_FINE)
        return status;
    drawing.film.depth = options->depth_bits;
    drawing.series =
        (struct series){.name = options->output, .format = options->format, .film = drawing.film, .why = drawing.why};
    status = draw_all(&drawing);
    progress_erase(&drawing.picture.progress);
    int result = report(&drawing, status);
    picture_end(&drawing.picture);
    finished_close(&drawing.finished);
    film_scene_end(&drawing.film_scene);
    free(drawing.surfaces);
    return result;
}

int draw_file(const struct options *options)
{
    return options->depth_bits && options->scene.integration.integrator ? estimate(options) : draw(options);
}
