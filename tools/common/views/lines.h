/* lines.h - straight lines on a picture, tile by tile. */
#ifndef TOOLS_VIEWS_LINES_H
#define TOOLS_VIEWS_LINES_H

#include <tia/render.h>

struct line {
    double ends[2][2]; /* pixel coordinates x, y; a pixel's centre has integer coordinates */
    tia_rgb565 colour;
};

/* Draws the part of the line that is in the tile; all tiles show the same line. */
void line_draw(const struct line *line, struct tia_tile tile, const struct tia_surface *surface);

#endif
