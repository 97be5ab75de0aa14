/* legend.h - the legend of a view's colours, in the lower left corner of a picture. */
#ifndef TOOLS_VIEWS_LEGEND_H
#define TOOLS_VIEWS_LEGEND_H

#include <tia/render.h>

#include "view_kind.h"

struct legend {
    enum view view;
    bool rays;                /* rays of a pixel are drawn */
    unsigned width, height;   /* size of the picture */
    double scale;             /* scale for seen_colour */
    uint32_t objects, lights; /* numbers of objects and lights */
};

/* Draws the part of the legend that is in the tile. */
void legend_draw(const struct legend *legend, struct tia_tile tile, const struct tia_surface *surface);

/* Returns the colour of a kind of ray; TIA_RAY_SHADOW + 1 is a shadow ray that does not reach its light, TIA_RAY_SHADOW
 * + 2 a normal. */
tia_rgb565 legend_ray(unsigned kind);

#endif
