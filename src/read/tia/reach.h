/* reach.h - how far a .tia scene reaches, as far as its lines say one by one, and the unit that this leaves room for.
 *
 * The first pass covers what has a place of its own. What is placed by a transform, a group or an animation lies around
 * that place, no farther than the largest thing in its own axes times the largest scale: names are not known yet.
 */
#ifndef TIA_READ_TIA_REACH_H
#define TIA_READ_TIA_REACH_H

#include "read/text/length.h"
#include <tia/motion.h>

struct tia_reach {
    struct tia_lengths lengths;
    struct tia_span places;             /* of what is placed */
    int64_t own;                        /* the radius around 0 of the largest thing in its own axes */
    tia_q16 scale_least, scale_largest; /* of anything placed */
    bool falls;                         /* something does: nobody knows where to */
    int64_t height;                     /* of an eye above a plane, at most */
};

/* See tia_lengths_begin. */
void tia_reach_begin(struct tia_reach *reach, int scale_bits, tia_q16 places);

/* In the first pass: a shape, with its transform if it is placed or may move; a mesh's vertex or a grid; ... */
void tia_reach_shape(struct tia_reach *reach, const struct tia_shape *shape, const struct tia_transform *transform,
                     bool placed, bool moves);
void tia_reach_vertex(struct tia_reach *reach, struct tia_vec3 vertex);
void tia_reach_grid(struct tia_reach *reach, const struct tia_grid *grid);
void tia_reach_light(struct tia_reach *reach, const struct tia_light *light);
void tia_reach_camera(struct tia_reach *reach, const struct tia_camera *camera);
void tia_reach_keys(struct tia_reach *reach, const struct tia_track *track, struct tia_span values);
void tia_reach_group(struct tia_reach *reach, const int64_t position[3]);

/* In a later pass, when all eyes are known. */
void tia_reach_plane(struct tia_reach *reach, const struct tia_plane *plane);

/* The most scale_bits that there surely is room for, 0 where no more are needed; and `most` or fewer, where an eye is
 * high above a plane. */
int tia_reach_room(const struct tia_reach *reach);
int tia_reach_bits(const struct tia_reach *reach, int most);

#endif
