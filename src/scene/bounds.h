/* bounds.h - boxes around objects, for the check of scenes and for building hierarchies. */
#ifndef TIA_SCENE_BOUNDS_H
#define TIA_SCENE_BOUNDS_H

#include "hull.h"

/* The object's box in the world, rounded outwards; `own` is the box of its mesh, or NULL: it is computed.
 * False: there is none, around a plane or a mesh without faces. */
bool tia_bounds_in_world(const struct tia_scene *scene, uint32_t object, const struct tia_bounds *own,
                         struct bounds_wide *bounds);

/* As if the shape had no transform, a unit of 2^-16 larger on every side; around 0 for a mesh without faces. */
void tia_bounds_in_own_axes(const struct tia_scene *scene, const struct tia_shape *shape, const struct tia_bounds *own,
                            struct bounds_wide *bounds);

/* A unit of 2^-16 larger on every side. False: it is out of range for Q16.16 and was clamped. */
bool tia_bounds_with_margin(const struct bounds_wide *bounds, struct tia_bounds *out);

#endif
