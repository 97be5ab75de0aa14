/* bounds.h - boxes around objects, as the check and the builder of hierarchies need them. */
#ifndef TIA_SRC_BOUNDS_H
#define TIA_SRC_BOUNDS_H

#include <tia/bvh.h>

/* In the world, Q47.16: where an object is may be beyond Q16.16. */
struct bounds_wide {
    int64_t min[3], max[3];
};

/* Around all that is in it: nothing. */
#define BOUNDS_NOTHING                                                                                                 \
    (struct tia_bounds)                                                                                                \
    {                                                                                                                  \
        {INT32_MAX, INT32_MAX, INT32_MAX},                                                                             \
        {                                                                                                              \
            INT32_MIN, INT32_MIN, INT32_MIN                                                                            \
        }                                                                                                              \
    }

void tia_bounds_add(struct tia_bounds *bounds, const struct tia_bounds *more);

/* Exact, in the mesh's own axes. */
struct tia_bounds tia_bounds_of_face(const struct tia_mesh *mesh, uint32_t face);
struct tia_bounds tia_bounds_of_mesh(const struct tia_mesh *mesh);

/* A box in the world as it grows, of a shape that is given in its own axes. */
struct hull;
void tia_hull_add_point(struct hull *hull, struct tia_vec3 p);
void tia_hull_add_sphere(struct hull *hull, struct tia_vec3 centre, tia_q16 radius);
void tia_hull_add_box(struct hull *hull, const struct tia_bounds *box); /* which may be nothing */
/* The normal is of any length, its components at most 33 bits. */
void tia_hull_add_disc(struct hull *hull, struct tia_vec3 centre, tia_q16 radius, const int64_t normal[3]);
/* Discs at both ends of an axis. */
void tia_hull_add_ends(struct hull *hull, struct tia_vec3 base, struct tia_vec3 top, tia_q16 base_radius,
                       tia_q16 top_radius);

/* The object's box in the world, rounded outwards; `own` is the box of its mesh, for which NULL asks to find it.
 * False: it has none, being a plane or a mesh without faces. */
bool tia_bounds_in_world(const struct tia_scene *scene, uint32_t object, const struct tia_bounds *own,
                         struct bounds_wide *bounds);

/* As if the shape had no transform, a unit of 2^-16 larger on every side; around 0 when there is nothing of it. */
void tia_bounds_in_own_axes(const struct tia_scene *scene, const struct tia_shape *shape, struct bounds_wide *bounds);

/* A unit of 2^-16 larger on every side. False: Q16.16 does not hold it, and it is cut off. */
bool tia_bounds_with_margin(const struct bounds_wide *bounds, struct tia_bounds *out);

#endif
