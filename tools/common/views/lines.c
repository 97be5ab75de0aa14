#include "lines.h"

#include <math.h>

static void put(struct tia_tile tile, const struct tia_surface *surface, double x, double y, tia_rgb565 colour)
{
    if (x < tile.x || y < tile.y || x >= tile.x + tile.width || y >= tile.y + tile.height)
        return;
    char *row = (char *)surface->pixels + (ptrdiff_t)((int)y - tile.y) * surface->pitch;
    *(tia_rgb565 *)(void *)(row + (ptrdiff_t)((int)x - tile.x) * surface->step) = colour;
}

/* Clips the parameters first..last of a line to the coordinates low..high, with a margin of a pixel. Returns false if
 * none are left. */
static bool cut(double from, double to, double low, double high, double *first, double *last)
{
    double way = to - from;

    if (fabs(way) < 1e-9)
        return from >= low - 1 && from <= high + 1;
    double a = (low - 1 - from) / way, b = (high + 1 - from) / way;
    *first = fmax(*first, fmin(a, b));
    *last = fmin(*last, fmax(a, b));
    return *first <= *last;
}

/* Draws a line. Each step is a pixel, counted from the line's beginning, so that all tiles draw the same pixels. */
void line_draw(const struct line *line, struct tia_tile tile, const struct tia_surface *surface)
{
    double x = line->ends[0][0], y = line->ends[0][1], wide = line->ends[1][0] - x, high = line->ends[1][1] - y;
    double steps = fmax(fmax(fabs(wide), fabs(high)), 1), first = 0, last = 1;

    if (!cut(x, x + wide, tile.x, (double)tile.x + tile.width, &first, &last) ||
        !cut(y, y + high, tile.y, (double)tile.y + tile.height, &first, &last))
        return;
    for (double i = floor(first * steps); i <= last * steps; i++)
        put(tile, surface, floor(x + i / steps * wide + 0.5), floor(y + i / steps * high + 0.5), line->colour);
}
