/* legend.h - what the colours of a view mean, in the lower left corner of a picture. */
#ifndef TOOLS_VIEWS_LEGEND_H
#define TOOLS_VIEWS_LEGEND_H

#include <tia/render.h>

#include "view.h"

struct legend {
    enum view view;
    bool rays;                /* those of a pixel are drawn */
    unsigned width, height;   /* of the picture */
    double scale;             /* see seen_colour */
    uint32_t objects, lights; /* how many there are */
};

/* Draws what is in the tile. */
void legend_draw(const struct legend *legend, struct tia_tile tile, const struct tia_surface *surface);

/* The colour of a kind of ray; of a shadow ray that does not arrive: number TIA_RAY_SHADOW + 1; of a normal: + 2. */
tia_rgb565 legend_ray(unsigned kind);

#endif
