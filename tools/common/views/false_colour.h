/* false_colour.h - records the rays of a pixel, and converts the record to a false colour. */
#ifndef TOOLS_VIEWS_FALSE_COLOUR_H
#define TOOLS_VIEWS_FALSE_COLOUR_H

#include <tia/debug.h>
#include <tia/render.h>

#include "view_kind.h"

struct seen {
    uint32_t rays, primaries; /* counts so far */
    bool direct;              /* the next shadow rays are those of the first ray's hit */
    struct tia_traced first;  /* the first primary ray */
    uint32_t lights;          /* bit n: light n reaches the first ray's hit; bit 31 stands for all lights from number
                                 31 */
};

void seen_ray(void *seen, const struct tia_traced *traced);

/* Returns the false colour of a pixel. `tests` is the number of intersection tests of the pixel's rays; `scale` is the
 * distance, in the scene's unit, that gets the colour in the middle of the palette. */
tia_rgb565 seen_colour(const struct seen *seen, enum view view, uint32_t tests, double scale);

/* Returns the colour of a set of lights. */
tia_rgb565 seen_lights(uint32_t lights);

#endif
