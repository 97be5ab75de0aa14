/* shape.h - where rays meet things. */
#ifndef TESTS_ORACLE_SHAPE_H
#define TESTS_ORACLE_SHAPE_H

#include "vec.h"

/* Where a ray meets a surface. The normals are of length 1 and on the surface's own side. */
struct hit {
    double t;                 /* the ray at t: its direction may have any length */
    struct oracle_vec normal; /* geometric */
    struct oracle_vec smooth; /* interpolated, or the same */
    double u, v;
    uint32_t part;     /* of the shape, as tia_options.path_hash has it */
    uint32_t material; /* an index into the scene's; from a shape alone, what to add to the shape's own */
};

/* One shape as it is before its transform; true and the nearest hit not before t = 0. */
bool shape_sphere(struct ray ray, struct oracle_vec centre, double radius, struct hit *hit);
bool shape_plane(struct ray ray, struct oracle_vec point, struct oracle_vec normal, struct hit *hit);
bool shape_disc(struct ray ray, struct oracle_vec centre, struct oracle_vec normal, double radius, struct hit *hit);
bool shape_cone(struct ray ray, struct oracle_vec base, struct oracle_vec top, double base_radius, double top_radius,
                bool capped, struct hit *hit); /* equal radii: a cylinder */
bool shape_box(struct ray ray, struct oracle_vec min, struct oracle_vec max, struct hit *hit);
bool shape_triangle(struct ray ray, const struct oracle_vec corner[3], struct hit *hit);
bool shape_mesh(struct ray ray, const struct tia_mesh *mesh, struct hit *hit);
bool shape_grid(struct ray ray, const struct tia_grid *grid, struct hit *hit);

/* How many groups of a mesh's faces are met before t. */
unsigned shape_mesh_groups(struct ray ray, const struct tia_mesh *mesh, double t);

/* A shape of the scene where its transform puts it. */
bool shape_hit(const struct tia_scene *scene, const struct tia_shape *shape, struct ray ray, struct hit *hit);

/* Object `index`: the spheres, then the shapes. A point 65536 or more away from 0 is not met. */
bool object_hit(const struct tia_scene *scene, uint32_t index, struct ray ray, struct hit *hit);

/* How many of the groups of object `index`, which the ray meets, it meets before `distance`: of what has no groups
 * 1. */
unsigned groups_hit(const struct tia_scene *scene, uint32_t index, struct ray ray, double distance);

/* Rz Ry Rx (scale v) + position of a transform, and without the position the inverse of R and its use. */
struct oracle_vec transform_point(const struct tia_transform *transform, struct oracle_vec v);
struct oracle_vec transform_turn(const struct tia_transform *transform, struct oracle_vec v);
struct oracle_vec transform_turn_back(const struct tia_transform *transform, struct oracle_vec v);

#endif
