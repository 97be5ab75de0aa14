/* object_bounds.h - boxes around objects, for the check of scenes and for building hierarchies. */
#ifndef TIA_SCENE_OBJECT_BOUNDS_H
#define TIA_SCENE_OBJECT_BOUNDS_H

#include "hull.h"

/* Gives the object's box in the world, rounded outwards; `own` is the box of the object's mesh, or NULL to have it
 * computed. False for a plane or a mesh without faces, which has no box. */
bool tia_bounds_in_world(const struct tia_scene *scene, uint32_t object, const struct tia_bounds *own,
                         struct bounds_wide *bounds);

/* Gives the box in the shape's own axes, without its transform, enlarged by a unit of 2^-16 on every side; around 0 for
 * a mesh without faces. `own` as for tia_bounds_in_world. */
void tia_bounds_in_own_axes(const struct tia_scene *scene, const struct tia_shape *shape, const struct tia_bounds *own,
                            struct bounds_wide *bounds);

/* Enlarges a box by a unit of 2^-16 on every side. False: it does not fit Q16.16 and was clamped. */
bool tia_bounds_with_margin(const struct bounds_wide *bounds, struct tia_bounds *out);

#endif
