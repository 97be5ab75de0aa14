/* red_picture.h - a channel of a small picture of a scene. */
#ifndef TESTS_RED_PICTURE_H
#define TESTS_RED_PICTURE_H

#include "arch/frames_canvas.h"
#include "check.h"

/* Draws a scene; `red` receives each pixel's red, 0..1. */
static inline void red_picture(const struct tia_core *core, const struct tia_scene *scene, unsigned width,
                               unsigned height, double *red)
{
    size_t pixels = (size_t)width * height;
    uint16_t *colours = malloc(3 * pixels * sizeof *colours);
    struct frames_canvas canvas = {.core = core};

    if (!colours || !frames_open(&canvas, scene, width, height))
        abort();
    const struct tia_surface surface = {.pixels = canvas.pixels, .step = 2, .pitch = (ptrdiff_t)width * 2};
    const struct tia_options options = {.colours = colours};
    CHECK_EQ(tia_view_trace(canvas.view, canvas.hits, canvas.area), TIA_OK);
    CHECK_EQ(tia_view_light(canvas.view, canvas.hits, canvas.area, &surface, &options), TIA_OK);
    for (size_t i = 0; i < pixels; i++)
        red[i] = colours[3 * i] / 65535.0;
    frames_close(&canvas);
    free(colours);
}

#endif
