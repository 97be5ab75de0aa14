/* triangle.h - triangles and faces of meshes, as one ray meets many of them. */
#ifndef TIA_RENDER_GEOMETRY_TRIANGLE_H
#define TIA_RENDER_GEOMETRY_TRIANGLE_H

#include "shape.h"

/* A ray, ready for triangles: `main` is the axis of its direction's largest component, 0, 1 or 2. */
struct triangle_ray {
    struct num_point origin;
    int main;
    num_unit along;    /* the direction's component there */
    num_unit slant[2]; /* those of the two axes that follow, over it */
};

/* The corners of a triangle, wherever they are kept. */
struct triangle_corners {
    struct tia_vec3 at[3];
};

void triangle_ray_prepare(struct triangle_ray *start, const struct ray *ray);

/* The t of the intersection, 0 <= t <= limit. Of triangles that share corners a ray through the corner or the edge
 * between two meets at least one, and those with their corners on one line are not met. */
bool triangle_intersect(const struct triangle_ray *ray, const struct triangle_corners *corners, num_length limit,
                        num_length *t);

/* (B - A) x (C - A) normalised; false, and 0, when the corners are on one line. */
bool triangle_normal(const struct triangle_corners *corners, struct num_dir *normal);

/* The barycentric coordinates of a point on a triangle with that normal, none below 0 but for a unit. */
void triangle_barycentric(const struct triangle_corners *corners, struct num_dir normal, struct num_point point,
                          num_unit parts[3]);

#endif
