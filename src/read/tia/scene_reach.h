/* scene_reach.h - bounds of a .tia scene, found line by line, and the finest unit that they allow.
 *
 * The first pass bounds objects whose coordinates are in the scene's axes. An object placed by a transform, a group or
 * an animation lies around its position, within the radius of the largest object in its own axes, times the largest
 * scale: the object is still unknown, since names are not resolved yet.
 */
#ifndef TIA_READ_TIA_SCENE_REACH_H
#define TIA_READ_TIA_SCENE_REACH_H

#include "read/text/length.h"
#include <tia/motion.h>

struct tia_reach {
    struct tia_lengths lengths;
    struct tia_span places;             /* positions of placed objects */
    int64_t own;                        /* radius of the largest object, around the origin of its own axes */
    tia_q16 scale_least, scale_largest; /* range of the scales of placed objects */
    bool falls;                         /* objects fall: their positions are unbounded */
    int64_t height;                     /* largest height of an eye above a plane */
};

/* Begins a pass, see tia_lengths_begin. */
void tia_reach_begin(struct tia_reach *reach, int scale_bits, tia_q16 places);

/* ---- in the first pass: these extend the bounds ---- */

/* Adds a shape. Its transform counts if it places the shape (`placed`) or a track may move the shape (`moves`). */
void tia_reach_shape(struct tia_reach *reach, const struct tia_shape *shape, const struct tia_transform *transform,
                     bool placed, bool moves);
/* Adds a member of a solid, which is placed by its transform in the solid's own axes. */
void tia_reach_member(struct tia_reach *reach, const struct tia_shape *member, const struct tia_transform *transform);
/* Adds a vertex of a mesh. */
void tia_reach_vertex(struct tia_reach *reach, struct tia_vec3 vertex);
void tia_reach_grid(struct tia_reach *reach, const struct tia_grid *grid);
/* Adds a light that has a position. */
void tia_reach_light(struct tia_reach *reach, const struct tia_light *light);
/* Adds all eyes of the camera, its reference point and its window. */
void tia_reach_camera(struct tia_reach *reach, const struct tia_camera *camera);
/* Adds a track; `values` bounds the values of its keyframes. */
void tia_reach_keys(struct tia_reach *reach, const struct tia_track *track, struct tia_span values);
/* Adds the position of a group, or of a shape in a group: Q31.32. */
void tia_reach_group(struct tia_reach *reach, const int64_t position[3]);

/* ---- after the first pass ---- */

/* Adds a plane in a later pass, when all eyes are known. */
void tia_reach_plane(struct tia_reach *reach, const struct tia_plane *plane);

/* Returns the largest scale_bits with which the scene certainly fits, but at most 0 if no finer unit than the file's is
 * needed. */
int tia_reach_room(const struct tia_reach *reach);
/* Returns `most`, or less if an eye is high above a plane. */
int tia_reach_bits(const struct tia_reach *reach, int most);

#endif
