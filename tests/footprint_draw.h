/* footprint_draw.h - pictures of scenes with filtered textures. */
#ifndef TIA_TESTS_FOOTPRINT_DRAW_H
#define TIA_TESTS_FOOTPRINT_DRAW_H

#include "check.h"
#include "reading.h"
#include "red_picture.h"

#define WIDTH 64
#define HEIGHT 48
#define PIXELS (WIDTH * HEIGHT)

/* Draws a scene; `red` receives each pixel's red, 0..1. `replacement` is NULL, or replaces the first texture. */
static inline void draw_red(const struct tia_core *core, const char *text, const struct tia_texture *replacement,
                            double red[PIXELS])
{
    struct tia_texture other;
    struct reading r;

    read_string(&r, TIA_FORMAT_TIA, text);
    CHECK_MSG(r.status == TIA_OK, "%u: %s", (unsigned)r.reader.error.line, r.reader.error.text);
    if (replacement) {
        other = *replacement;
        other.footprint = r.scene.textures[0].footprint;
        r.scene.textures = &other;
    }
    if (r.status)
        abort();
    red_picture(core, &r.scene, WIDTH, HEIGHT, red);
    read_end(&r);
}

#endif
