/* whitted.h - the colour that comes along a ray, after Whitted, "An improved illumination model for shaded
 * display" (1980); the formulas are in tia/material.h. */
#ifndef TIA_RAY_WHITTED_H
#define TIA_RAY_WHITTED_H

#include "render/trace/trace.h"

#define PATH_BLOCKERS 8

/* Rays from the eye, one after the other. */
struct path {
    const struct ray_view *view;
    unsigned class; /* of the pixel, see light.h */
    bool hashed;
    uint32_t hash;                   /* of the path, see tia_options.path_hash */
    uint32_t blocker[PATH_BLOCKERS]; /* what stood before each of the first lights last */
};

#define PATH_HASH UINT32_C(2166136261)

/* The colour along `ray`, which meets `hit`, a light perhaps; not clamped. */
void path_colour(struct path *path, const struct ray *ray, const struct hit *hit, num_length colour[3]);

#endif
