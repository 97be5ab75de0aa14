/* bounds.h - boxes around objects, as the check and the builder of hierarchies need them. */
#ifndef TIA_SCENE_BOUNDS_H
#define TIA_SCENE_BOUNDS_H

#include "hull.h"

/* The object's box in the world, rounded outwards; `own` is the box of its mesh, for which NULL asks to find it.
 * False: it has none, being a plane or a mesh without faces. */
bool tia_bounds_in_world(const struct tia_scene *scene, uint32_t object, const struct tia_bounds *own,
                         struct bounds_wide *bounds);

/* As if the shape had no transform, a unit of 2^-16 larger on every side; around 0 when there is nothing of it. */
void tia_bounds_in_own_axes(const struct tia_scene *scene, const struct tia_shape *shape, struct bounds_wide *bounds);

/* A unit of 2^-16 larger on every side. False: Q16.16 does not hold it, and it is cut off. */
bool tia_bounds_with_margin(const struct bounds_wide *bounds, struct tia_bounds *out);

#endif
