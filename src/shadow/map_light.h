/* map_light.h - the light that reaches a tile's pixels, found with a shadow map. */
#ifndef TIA_SHADOW_MAP_LIGHT_H
#define TIA_SHADOW_MAP_LIGHT_H

#include "map_look.h"

#define TIA_MAP_PIXEL_WORK 4 /* items of work for a pixel, see cancel.h: PCSS takes up to two hundred taps */

/* A tile, and the sample of a light whose map is `point.map`. */
struct tia_map_lighting {
    const struct tia_shadow_view *view;
    const struct tia_map_look *look;
    struct tia_world world; /* converts coordinates of the grid of the pixels' current sample */
    struct tia_shadow_tile *tile;
    struct cancel *cancel;
    unsigned sample, shares;
    int64_t radius; /* see tia_map_share */
    bool turned;    /* the point's face is turned to the light */
    struct tia_map_point point;
};

/* Stores the share of the light that reaches a pixel, which is at index `at` of the tile. */
static inline void tia_map_put_share(const struct tia_map_lighting *l, size_t at, unsigned share)
{
    l->tile->lit[at] |= (uint64_t)(share > 0) << l->sample;
    if (l->shares)
        ((tia_share *)l->tile->more)[at * l->shares + l->sample] = (tia_share)share;
}

/* Lights pixel (x, y). */
void tia_map_light_pixel(struct tia_map_lighting *l, int x, int y);

#endif
