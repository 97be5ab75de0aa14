/* triangle.h - intersections of one ray with many triangles, such as the faces of a mesh. */
#ifndef TIA_RENDER_GEOMETRY_TRIANGLE_H
#define TIA_RENDER_GEOMETRY_TRIANGLE_H

#include "shape.h"

/* A ray prepared for triangles: `main` is the axis of its direction's largest component, 0, 1 or 2. */
struct triangle_ray {
    num_length origin[3]; /* origin along the main axis and the two axes after it */
    int main;
    num_divisor along; /* the direction's component along the main axis */
    num_unit slope[2]; /* the direction's components along the next two axes, divided by `along` */
};

/* A copy of a triangle's corners. */
struct triangle_corners {
    struct tia_vec3 at[3];
};

void triangle_ray_prepare(struct triangle_ray *start, const struct ray *ray);

/* Gives the t of the intersection; false if there is none with 0 <= t <= limit. A ray through an edge or corner that
 * triangles share meets at least one of them. A degenerate triangle, whose corners are on one line, is never met. */
bool triangle_intersect(const struct triangle_ray *ray, const struct triangle_corners *corners, num_length limit,
                        num_length *t);

/* Gives (B - A) x (C - A), normalised. If the corners are on one line, returns false, and the normal is 0. */
bool triangle_normal(const struct triangle_corners *corners, struct num_dir *normal);

/* Gives the barycentric coordinates of a point on a triangle with the normal `normal`; none is below 0 by more than a
 * unit. */
void triangle_barycentric(const struct triangle_corners *corners, struct num_dir normal, struct num_point point,
                          num_unit parts[3]);

/* Gives the change of the second and third barycentric coordinate along a vector in the plane of a triangle, within
 * +-2^12; 0 if its corners are on one line. No component of the vector is above 1. */
void triangle_change(const struct triangle_corners *corners, struct num_dir normal, struct num_point vector,
                     num_length parts[2]);

/* Give the change of a triangle's or mesh's surface coordinates along such a vector, in the plane of the element,
 * within +-2^16: that of u and v beyond its edges, too. */
void triangle_uv_change(const struct shape *shape, uint32_t element, struct num_point vector, num_length uv[2]);
void mesh_uv_change(const struct shape *shape, uint32_t element, struct num_point vector, num_length uv[2]);

#endif
