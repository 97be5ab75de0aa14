/* shape.h - intersections of rays with objects. */
#ifndef TESTS_ORACLE_SHAPE_H
#define TESTS_ORACLE_SHAPE_H

#include "vec.h"

/* A ray's hit on a surface. Normals have length 1, and point to the surface's front. */
struct hit {
    double t;                 /* parameter of the point on the ray, whose direction may have any length */
    struct oracle_vec normal; /* the geometric normal */
    struct oracle_vec smooth; /* the interpolated normal, or the geometric one */
    double u, v;
    struct oracle_vec own; /* the point in the shape's axes, relative to the centre of a sphere; set by object_hit */
    uint32_t part;         /* part of the shape, as in tia_debug.path_hash */
    /* index into the scene's materials; in a shape's own hit, an offset from the shape's material */
    uint32_t material;
};

/* Intersections with one shape in its own axes. Each returns true and stores the nearest hit with t >= 0; or false if
 * there is none. */
bool shape_sphere(struct ray ray, struct oracle_vec centre, double radius, struct hit *hit);
bool shape_plane(struct ray ray, struct oracle_vec point, struct oracle_vec normal, struct hit *hit);
bool shape_disc(struct ray ray, struct oracle_vec centre, struct oracle_vec normal, double radius, struct hit *hit);
bool shape_cone(struct ray ray, struct oracle_vec base, struct oracle_vec top, double base_radius, double top_radius,
                bool capped, struct hit *hit); /* with equal radii, a cylinder */
bool shape_box(struct ray ray, struct oracle_vec min, struct oracle_vec max, struct hit *hit);
bool shape_torus(struct ray ray, struct oracle_vec centre, struct oracle_vec axis, double major, double minor,
                 struct hit *hit);
bool shape_rounded(struct ray ray, struct oracle_vec min, struct oracle_vec max, double radius, struct hit *hit);
bool shape_triangle(struct ray ray, const struct oracle_vec corner[3], struct hit *hit);
bool shape_mesh(struct ray ray, const struct tia_mesh *mesh, struct hit *hit);
bool shape_grid(struct ray ray, const struct tia_grid *grid, struct hit *hit);

/* Intersects a solid; hit->material is a material's index, no offset. */
bool shape_solid(const struct tia_scene *scene, const struct tia_solid *solid, struct ray ray, struct hit *hit);

/* Returns the number of groups of a mesh's faces that the ray meets before t. A group counts once. */
unsigned shape_mesh_groups(struct ray ray, const struct tia_mesh *mesh, double t);

/* Intersects a shape of the scene, placed by its transform, if it has one. */
bool shape_hit(const struct tia_scene *scene, const struct tia_shape *shape, struct ray ray, struct hit *hit);

/* Intersects object `index`; spheres come before shapes. Points at a distance of 65536 or more from the origin are not
 * met. */
bool object_hit(const struct tia_scene *scene, uint32_t index, struct ray ray, struct hit *hit);

/* Returns the number of groups of object `index` that the ray meets before `distance`; 1 for an object without groups.
 * The ray must meet the object. */
unsigned groups_hit(const struct tia_scene *scene, uint32_t index, struct ray ray, double distance);

/* Returns Rz Ry Rx (scale v) + position of a transform. */
struct oracle_vec transform_point(const struct tia_transform *transform, struct oracle_vec v);

/* Returns Rz Ry Rx v. */
struct oracle_vec transform_turn(const struct tia_transform *transform, struct oracle_vec v);

/* Returns the inverse rotation of v. */
struct oracle_vec transform_turn_back(const struct tia_transform *transform, struct oracle_vec v);

#endif
