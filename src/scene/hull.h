/* hull.h - bounding boxes of shapes, extended part by part. */
#ifndef TIA_SCENE_HULL_H
#define TIA_SCENE_HULL_H

#include <tia/bvh.h>

#include "cancel.h"

/* A box in the world. Q47.16, since a transform may move objects out of the range of Q16.16. */
struct bounds_wide {
    int64_t min[3], max[3];
};

/* An empty box, to be enlarged. */
#define BOUNDS_NOTHING                                                                                                 \
    (struct tia_bounds)                                                                                                \
    {                                                                                                                  \
        {INT32_MAX, INT32_MAX, INT32_MAX},                                                                             \
        {                                                                                                              \
            INT32_MIN, INT32_MIN, INT32_MIN                                                                            \
        }                                                                                                              \
    }

void tia_bounds_add(struct tia_bounds *bounds, const struct tia_bounds *more);

/* Returns the box of a face, exact, in the mesh's own axes. */
struct tia_bounds tia_bounds_of_face(const struct tia_mesh *mesh, uint32_t face);
/* Returns the box of a mesh, exact, in its own axes; undefined once cancelled. */
struct tia_bounds tia_bounds_of_mesh(const struct tia_mesh *mesh, struct cancel *cancel);

/* The rows of R S (rotation and scale), Q11.52, and the position of a shape, Q31.32. */
struct frame {
    int64_t rows[3][3];
    int64_t position[3];
};

/* A box in the world, Q31.32, which grows around a shape that is given in its own axes. */
struct hull {
    const struct frame *frame;
    int64_t min[3], max[3];
};

/* Prepares a frame; a NULL transform is the identity. */
void tia_frame_prepare(struct frame *frame, const struct tia_transform *transform);

/* Returns the coordinate along the world's axis k, Q31.32, of a point in the shape's axes. */
int64_t tia_frame_place(const struct frame *frame, int k, struct tia_vec3 p);
/* Does the same for a point in Q31.32. */
int64_t tia_frame_place_finely(const struct frame *frame, int k, const int64_t p[3]);

void tia_hull_add_point(struct hull *hull, struct tia_vec3 p);
void tia_hull_add_sphere(struct hull *hull, struct tia_vec3 centre, tia_q16 radius);
void tia_hull_add_box(struct hull *hull, const struct tia_bounds *box); /* the box may be empty */
/* Adds a disc. The normal may have any length; components have at most 33 bits. */
void tia_hull_add_disc(struct hull *hull, struct tia_vec3 centre, tia_q16 radius, const int64_t normal[3]);
/* Adds a torus: all points within `tube` of the edge of such a disc. */
void tia_hull_add_ring(struct hull *hull, struct tia_vec3 centre, tia_q16 radius, tia_q16 tube,
                       const int64_t normal[3]);
/* Adds discs at both ends of an axis. */
void tia_hull_add_ends(struct hull *hull, struct tia_vec3 base, struct tia_vec3 top, tia_q16 base_radius,
                       tia_q16 top_radius);

#endif
