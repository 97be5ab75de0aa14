/* canvas.c - a picture in ordinary memory. */
#include "canvas.h"

#include <stdlib.h>

#include "pages.h"

int canvas_resize(struct canvas *canvas, uint16_t width, uint16_t height)
{
    canvas_free(canvas);
    canvas->pixels = pages_alloc_cleared((size_t)width * height * sizeof *canvas->pixels);
    if (!canvas->pixels)
        return TIA_ERR_MEMORY;
    canvas->width = width;
    canvas->height = height;
    return TIA_OK;
}

int canvas_tile(const struct canvas *canvas, struct tia_tile tile, struct tia_surface *surface)
{
    if (!tile_inside(tile, canvas->width, canvas->height))
        return TIA_ERR_ARGUMENT;
    *surface = (struct tia_surface){.pixels = canvas->pixels + (size_t)tile.y * canvas->width + tile.x,
                                    .step = (ptrdiff_t)sizeof *canvas->pixels,
                                    .pitch = (ptrdiff_t)(canvas->width * sizeof *canvas->pixels)};
    return TIA_OK;
}

void canvas_free(struct canvas *canvas)
{
    free(canvas->pixels);
    *canvas = (struct canvas){0};
}

bool tile_inside(struct tia_tile tile, uint16_t width, uint16_t height)
{
    return tile.width > 0 && tile.height > 0 && tile.x < width && tile.y < height && tile.width <= width - tile.x &&
           tile.height <= height - tile.y;
}
