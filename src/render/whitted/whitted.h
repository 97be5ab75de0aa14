/* whitted.h - the colour that comes along a ray, after Whitted, "An improved illumination model for shaded
 * display" (1980); the formulas are in tia/material.h. */
#ifndef TIA_RENDER_WHITTED_WHITTED_H
#define TIA_RENDER_WHITTED_WHITTED_H

#include "path.h"

/* The colour along `ray`, which meets `hit`, perhaps a light; not clamped. */
void path_colour(struct path *path, const struct ray *ray, const struct hit *hit, num_length colour[3]);

#endif
