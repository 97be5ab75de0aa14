/* seen.h - observations from a pixel's rays, and its false colour. */
#ifndef TOOLS_VIEWS_SEEN_H
#define TOOLS_VIEWS_SEEN_H

#include <tia/render.h>

#include "view.h"

struct seen {
    uint32_t rays, primaries; /* so far */
    bool direct;              /* shadow rays are those of what the first ray sees */
    struct tia_traced first;  /* the first primary ray */
    uint32_t lights;          /* bit n: light n arrives there; from 31 on in common */
};

void seen_ray(void *seen, const struct tia_traced *traced);

/* `scale`: the distance that has half of the palette. */
tia_rgb565 seen_colour(const struct seen *seen, enum view view, uint32_t tests, double scale);

/* The colour of light n, and of all in `lights`. */
tia_rgb565 seen_lights(uint32_t lights);

#endif
