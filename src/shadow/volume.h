/* volume.h - shadow volumes (Crow 1977): the space that a caster hides from a light. The number of volumes that hold a
 * visible point is found by counting their surfaces behind it (z-fail: Bilodeau and Songy 1999, Carmack 2000), or in
 * front of it, plus the eye's own count (z-pass: Heidmann 1991).
 *
 * Corners are rounded once; everything after is exact, see raster.h. So a volume's surface closes without a gap: each
 * edge of a cap is the edge of a side, in the same integers. A visible face is equal in depth to its own cap, which
 * counts as behind: it does not shadow itself, and needs no bias. */
#ifndef TIA_SHADOW_VOLUME_H
#define TIA_SHADOW_VOLUME_H

#include "flat/lights.h"
#include "scene/cancel.h"

/* On which side of a face's plane it is: 1 where the corners run counterclockwise seen from it, -1 behind, 0 in the
 * plane. */
int tia_flat_side(const struct tia_flat_scene *flat, const struct tia_flat_face *face, const tia_flat_light *light);

/* The same for the eye. */
int tia_flat_side_of_eye(const struct tia_flat_scene *flat, const struct tia_flat_face *face);

/* Whether the side of a face that is seen is turned to the light. */
bool tia_flat_is_turned(const struct tia_flat_scene *flat, uint32_t face, const tia_flat_light *light);

/* Whether the object cannot hide the light from any visible point: it is a plane, with the eye and the light on the
 * same side. */
bool tia_flat_hides_nothing(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                            const tia_flat_light *light);

/* Of a closed surface with the light and the eye outside, the faces turned to the light are enough, and only their
 * silhouette has sides: the way from a point that is seen to the light starts and ends outside, so it crosses as many
 * of these as of the others, however the surface is oriented and even if it crosses itself. Otherwise each face casts
 * for itself, which is right for any faces. */
bool tia_flat_has_silhouette(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                             const tia_flat_light *light);

/* How many volumes hold the eye, from which rays come, and how many hold the point at infinity to which they go: 0 in
 * perspective, where each ray goes to another. False when that lies exactly on the surface of a volume: then z-pass
 * and, in orthographic views, z-fail are undecided. Once cancelled, the counts are undefined. */
bool tia_shadow_count_eye(const struct tia_flat_scene *flat, const tia_flat_light *light, uint32_t *count,
                          struct cancel *cancel);
bool tia_shadow_count_far(const struct tia_flat_scene *flat, const tia_flat_light *light, uint32_t *count,
                          struct cancel *cancel);

/* Draws the visible faces into depth and faces of the target, which must be empty. TIA_STOPPED when the cancel is
 * stopped, as the next two. */
int tia_shadow_faces(struct tia_raster_target *target, const struct tia_flat_scene *flat, struct cancel *cancel);

/* With the faces drawn, adds to each pixel's count the number of volumes that hold its point, less the number of those
 * that hold the point at infinity. There are at most as many as faces, so 32 bits never wrap; a stencil buffer of 8
 * bits shows light where 256 volumes hold a point. */
int tia_shadow_zfail(struct tia_raster_target *target, const struct tia_flat_scene *flat, const tia_flat_light *light,
                     struct cancel *cancel);

/* The same, less the number of volumes that hold the eye. */
int tia_shadow_zpass(struct tia_raster_target *target, const struct tia_flat_scene *flat, const tia_flat_light *light,
                     struct cancel *cancel);

#endif
