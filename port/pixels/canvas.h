/* canvas.h - a picture in ordinary memory, for displays that draw first and show afterwards. */
#ifndef PORT_CANVAS_H
#define PORT_CANVAS_H

#include <tia/port.h>

struct canvas {
    tia_rgb565 *pixels; /* row by row, without gaps */
    uint16_t width, height;
};

/* Resizes the canvas and clears it to black. After TIA_ERR_MEMORY the canvas is empty. */
int canvas_resize(struct canvas *canvas, uint16_t width, uint16_t height);

/* Gives the part of the canvas that `tile` covers. TIA_ERR_ARGUMENT when the tile is empty or not inside the canvas. */
int canvas_tile(const struct canvas *canvas, struct tia_tile tile, struct tia_surface *surface);

void canvas_free(struct canvas *canvas);

/* True if `tile` is not empty and inside a width x height picture. */
bool tile_inside(struct tia_tile tile, uint16_t width, uint16_t height);

#endif
