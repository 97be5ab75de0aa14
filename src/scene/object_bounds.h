/* object_bounds.h - boxes around objects, for the check of scenes and for building hierarchies. */
#ifndef TIA_SCENE_OBJECT_BOUNDS_H
#define TIA_SCENE_OBJECT_BOUNDS_H

#include "hull.h"

/* Writes the object's box in the world, rounded outwards. `own` is the box of the object's mesh in its own axes; if it
 * is NULL, the box is computed. Returns false for a plane and for a mesh without faces: they have no box. */
bool tia_bounds_in_world(const struct tia_scene *scene, uint32_t object, const struct tia_bounds *own,
                         struct bounds_wide *bounds);

/* Writes the shape's box in its own axes, without its transform, enlarged by 2^-16 on every side. A mesh without faces
 * gets a box around 0. `own` is as for tia_bounds_in_world. */
void tia_bounds_in_own_axes(const struct tia_scene *scene, const struct tia_shape *shape, const struct tia_bounds *own,
                            struct bounds_wide *bounds);

/* Enlarges a box by 2^-16 on every side. If it does not fit in Q16.16, clamps it and returns false. */
bool tia_bounds_with_margin(const struct bounds_wide *bounds, struct tia_bounds *out);

#endif
