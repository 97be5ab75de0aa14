/* cone.h - the cones of rays that leave a surface, see footprint.h. */
#ifndef TIA_RENDER_WHITTED_CONE_H
#define TIA_RENDER_WHITTED_CONE_H

#include "shade.h"

/* Sets the cones of the rays that leave the hit of `ray`. */
void cone_spread(const struct path *path, const struct ray *ray, const struct hit *hit, const struct shading *s,
                 struct bounces *next);

#endif
