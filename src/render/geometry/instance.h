/* instance.h - shapes that are scaled, rotated and moved.
 *
 * An instance has a scale s, axes a, which are the directions of the shape's x, y and z in the world, and a position p.
 * In the shape's axes, a world point P is ((P - p).a_i) / s_i, and a direction D is (D.a_i) / s_i. Let k be the length
 * of the latter: a distance t in the world is k t in the shape's axes.
 *
 * A ray is first moved forward to the box around the shape. So no number in the shape's axes is larger than the shape,
 * however small the scale, and a ray that misses the box misses the shape. */
#ifndef TIA_RENDER_GEOMETRY_INSTANCE_H
#define TIA_RENDER_GEOMETRY_INSTANCE_H

#include "scene/object_bounds.h"
#include "shape.h"

struct instance {
    struct num_point position;
    struct num_dir axes[3];
    num_length scale[3];
    num_length min[3], max[3]; /* bounding box along the axes, in the world's units */
};

/* Prepares an instance; `bounds` are the shape's in its own axes. */
void instance_prepare(struct instance *instance, const struct tia_transform *transform,
                      const struct bounds_wide *bounds);

/* A ray in the shape's axes. */
struct instance_ray {
    struct ray ray;
    num_length start;       /* world t of the local origin; above NUM_LENGTH_MAX: the ray misses the box */
    struct num_scale scale; /* k */
};

void instance_transform_ray(const struct instance *instance, const struct ray *ray, struct instance_ray *placed);

/* Converts a distance in the world to one along the local ray. The result is below 0 if the distance ends before the
 * local origin, or if the ray misses the box. */
num_length instance_distance(const struct instance_ray *placed, num_length t);
/* Converts a distance along the local ray to one in the world. */
num_length instance_distance_back(const struct instance_ray *placed, num_length t);

/* Returns instance_distance(t) plus a margin for its rounding, so that an intersection within t in the world is within
 * this limit. */
num_length instance_limit(const struct instance_ray *placed, num_length t);

/* Converts a world point on the shape to the shape's axes. */
struct num_point instance_point(const struct instance *instance, struct num_point point);
/* Converts a normal to the world. */
struct num_dir instance_normal(const struct instance *instance, struct num_dir normal);

#endif
