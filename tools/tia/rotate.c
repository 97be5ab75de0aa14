#include "rotate.h"

struct rotation rotation_inverse(const struct rotation *rotation)
{
    struct rotation back = {(360 - rotation->degrees) % 360, rotation->width, rotation->height};
    if (rotation_swaps(rotation->degrees)) {
        back.width = rotation->height;
        back.height = rotation->width;
    }
    return back;
}

/* Returns the rotated tile. Pixel (x, y) moves to (height - 1 - y, x) for 90 degrees, (width - 1 - x, height - 1 - y)
 * for 180 and (y, width - 1 - x) for 270. */
struct tia_tile rotation_tile(const struct rotation *rotation, struct tia_tile tile)
{
    uint16_t from_right = (uint16_t)(rotation->width - tile.x - tile.width);
    uint16_t from_below = (uint16_t)(rotation->height - tile.y - tile.height);
    switch (rotation->degrees) {
    case 90:
        return (struct tia_tile){from_below, tile.x, tile.height, tile.width};
    case 180:
        return (struct tia_tile){from_right, from_below, tile.width, tile.height};
    case 270:
        return (struct tia_tile){tile.y, from_right, tile.height, tile.width};
    default:
        return tile;
    }
}

struct tia_surface rotation_surface(const struct rotation *rotation, const struct tia_surface *surface, unsigned width,
                                    unsigned height)
{
    ptrdiff_t last_x = (ptrdiff_t)(width - 1) * surface->step, last_y = (ptrdiff_t)(height - 1) * surface->pitch;
    char *pixels = (char *)surface->pixels;
    struct tia_surface out = *surface;
    switch (rotation->degrees) {
    case 90:
        pixels += last_x;
        out.step = surface->pitch;
        out.pitch = -surface->step;
        break;
    case 180:
        pixels += last_x + last_y;
        out.step = -surface->step;
        out.pitch = -surface->pitch;
        break;
    case 270:
        pixels += last_y;
        out.step = -surface->pitch;
        out.pitch = surface->step;
        break;
    default:
        break;
    }
    out.pixels = (tia_rgb565 *)(void *)pixels;
    return out;
}
