/* placement.h - shapes that are scaled, rotated and moved.
 *
 * With the scale s, its smallest component m, the axes a (where the shape's x, y and z point) and the
 * position p, a world point P is ((P - p).a_i) / s_i in the shape's axes, taken as ((P - p).a_i)(m/s_i)/m:
 * then a direction's components do not grow, and a distance t in the world is t k/m there, k being the
 * length of what a direction of length 1 becomes.
 *
 * The ray is first moved along itself to where it comes near the shape; so nothing grows beyond what
 * tia_scene_check allows, however small the scale.
 */
#ifndef TIA_SHAPE_PLACEMENT_H
#define TIA_SHAPE_PLACEMENT_H

#include "shape.h"

struct placement {
    struct num_point position;
    struct num_dir axes[3];
    num_d ratio[3];          /* m/s_i */
    num_x least;             /* m */
    struct num_point centre; /* of a sphere around the shape, in the world */
    num_x radius;
};

void placement_prepare(struct placement *placement, const struct tia_transform *transform, struct tia_bounds bounds);

/* A ray in the shape's axes. */
struct placed_ray {
    struct ray ray;
    num_x start;  /* the world's t of the local 0 */
    num_d shrink; /* k */
};

void placement_ray(const struct placement *placement, const struct ray *ray, struct placed_ray *placed);

/* Distances from one to the other. */
num_x placement_distance(const struct placement *placement, const struct placed_ray *placed, num_x t);
num_x placement_distance_back(const struct placement *placement, const struct placed_ray *placed, num_x t);

/* A world point on the shape in the shape's axes, and a normal back in the world. */
struct num_point placement_point(const struct placement *placement, struct num_point point);
struct num_dir placement_normal(const struct placement *placement, struct num_dir normal);

#endif
