/* solid.h - the expression of a solid, see struct tia_solid. */
#ifndef TIA_SCENE_SOLID_H
#define TIA_SCENE_SOLID_H

#include "shapes/description.h"

/* True if a point is in the solid: bit i of `inside` is set if the point is in member i. */
bool tia_solid_holds(const struct tia_solid *solid, uint32_t inside);

/* Returns the solid's box in its own axes; a side at INT32_MIN or INT32_MAX is unbounded. An empty solid has a box of
 * no size on some axis. */
struct tia_bounds tia_solid_box(const struct tia_scene *scene, const struct tia_solid *solid);

/* Returns the description of a member's kind; NULL for a shape that cannot be a member. */
const struct shape_description *tia_solid_member_kind(const struct tia_shape *shape);

/* Writes the box of a member in the solid's axes, rounded outwards. Returns false for a plane, which has none. */
bool tia_solid_member_box(const struct tia_scene *scene, const struct tia_shape *member, struct bounds_wide *box);

/* True if no side of a box is unbounded. */
bool tia_solid_is_bounded(const struct tia_bounds *box);

#endif
