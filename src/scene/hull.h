/* hull.h - boxes, and how they grow around what a shape is made of. */
#ifndef TIA_SCENE_HULL_H
#define TIA_SCENE_HULL_H

#include <tia/bvh.h>

#include "cancel.h"

/* In the world, Q47.16: a transform may move an object out of the range of Q16.16. */
struct bounds_wide {
    int64_t min[3], max[3];
};

/* An empty box, to which things are added. */
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
struct tia_bounds tia_bounds_of_mesh(const struct tia_mesh *mesh, struct cancel *cancel); /* stopped: any box */

/* The rows of R S and the position. */
struct frame {
    int64_t rows[3][3];
    int64_t position[3];
};

/* A box in the world as it grows, Q31.32, of a shape that is given in its own axes. */
struct hull {
    const struct frame *frame;
    int64_t min[3], max[3];
};

/* NULL: no transform. */
void tia_frame_prepare(struct frame *frame, const struct tia_transform *transform);

/* Where a shape's point lies in the world, along axis k: Q31.32; and one that is Q31.32 itself. */
int64_t tia_frame_place(const struct frame *frame, int k, struct tia_vec3 p);
int64_t tia_frame_place_finely(const struct frame *frame, int k, const int64_t p[3]);

void tia_hull_add_point(struct hull *hull, struct tia_vec3 p);
void tia_hull_add_sphere(struct hull *hull, struct tia_vec3 centre, tia_q16 radius);
void tia_hull_add_box(struct hull *hull, const struct tia_bounds *box); /* which may be empty */
/* The normal may have any length, its components up to 33 bits. */
void tia_hull_add_disc(struct hull *hull, struct tia_vec3 centre, tia_q16 radius, const int64_t normal[3]);
/* Discs at both ends of an axis. */
void tia_hull_add_ends(struct hull *hull, struct tia_vec3 base, struct tia_vec3 top, tia_q16 base_radius,
                       tia_q16 top_radius);

#endif
