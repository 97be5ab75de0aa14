/* surfaces.h - depth, normal and object of each pixel of a picture, for OpenEXR files. */
#ifndef TOOLS_TIA_SURFACES_H
#define TOOLS_TIA_SURFACES_H

#include "options.h"

/* Most pixels of a picture in OpenEXR: its surfaces, 20 bytes a pixel, are in memory. */
#define SURFACES_MOST (1u << 24)

/* Finds what the ray through the middle of each pixel meets first, by the rays of tia_core_watched, which shade it,
 * too. *surfaces gets an array to be freed by free(), row by row from the top; NULL, after a note, if this program or
 * the chosen arithmetic has no such rays. Returns TIA_OK, or a negative status, for TIA_ERR_RANGE with the reason in
 * `why`, [PORT_WHY]. */
int surfaces_find(struct image_surface **surfaces, const struct options *options, char *why);

#endif
