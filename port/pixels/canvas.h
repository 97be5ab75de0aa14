/* canvas.h - a picture in ordinary memory, for displays that draw first and show afterwards. */
#ifndef PORT_CANVAS_H
#define PORT_CANVAS_H

#include <tia/port.h>

struct canvas {
    tia_rgb565 *pixels; /* row by row without gaps */
    uint16_t width, height;
};

/* Makes the canvas width x height and black. TIA_ERR_MEMORY leaves an empty one. */
int canvas_resize(struct canvas *canvas, uint16_t width, uint16_t height);

/* The part of the canvas that `tile` covers. TIA_ERR_ARGUMENT when it covers none or leaves it. */
int canvas_tile(const struct canvas *canvas, struct tia_tile tile, struct tia_surface *surface);

void canvas_free(struct canvas *canvas);

/* Is `tile` a part of a width x height picture, and not empty? */
bool tile_inside(struct tia_tile tile, uint16_t width, uint16_t height);

#endif
