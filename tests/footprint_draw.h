/* footprint_draw.h - pictures of scenes with filtered textures. */
#ifndef TIA_TESTS_FOOTPRINT_DRAW_H
#define TIA_TESTS_FOOTPRINT_DRAW_H

#include "arch/frames_canvas.h"
#include "check.h"
#include "reading.h"

#define WIDTH 64
#define HEIGHT 48
#define PIXELS (WIDTH * HEIGHT)

/* Draws a scene; `red` receives each pixel's red, 0..1. `replacement` is NULL, or replaces the first texture. */
static inline void draw_red(const struct tia_core *core, const char *text, const struct tia_texture *replacement,
                            double red[PIXELS])
{
    static uint16_t colours[3 * PIXELS];
    struct frames_canvas canvas = {.core = core};
    struct tia_texture other;
    struct reading r;

    read_string(&r, TIA_FORMAT_TIA, text);
    CHECK_MSG(r.status == TIA_OK, "%u: %s", (unsigned)r.reader.error.line, r.reader.error.text);
    if (replacement) {
        other = *replacement;
        other.footprint = r.scene.textures[0].footprint;
        r.scene.textures = &other;
    }
    if (r.status || !frames_open(&canvas, &r.scene, WIDTH, HEIGHT))
        abort();
    const struct tia_surface surface = {.pixels = canvas.pixels, .step = 2, .pitch = WIDTH * 2};
    const struct tia_options options = {.colours = colours};
    CHECK_EQ(tia_view_trace(canvas.view, canvas.hits, canvas.area), TIA_OK);
    CHECK_EQ(tia_view_light(canvas.view, canvas.hits, canvas.area, &surface, &options), TIA_OK);
    frames_close(&canvas);
    read_end(&r);
    for (int i = 0; i < PIXELS; i++)
        red[i] = colours[3 * i] / 65535.0;
}

#endif
