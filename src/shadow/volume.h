/* volume.h - shadow volumes (Crow 1977): the space that a caster hides from a light. The number of volumes that contain
 * a visible point is found by counting their surfaces behind it (z-fail: Bilodeau and Songy 1999, Carmack 2000), or in
 * front of it, plus the eye's own count (z-pass: Heidmann 1991).
 *
 * Corners are rounded once; everything after is exact, see raster.h. So a volume's surface closes without a gap: each
 * edge of a cap is the edge of a side, in the same integers. A visible face is equal in depth to its own cap, which
 * counts as behind: it does not shadow itself, and needs no bias. */
#ifndef TIA_SHADOW_VOLUME_H
#define TIA_SHADOW_VOLUME_H

#include "flat/light_vertices.h"
#include "scene/cancel.h"

/* Returns the side of a face's plane on which the light is: 1 where the corners run counterclockwise seen from it, -1
 * behind, 0 in the plane. */
int tia_flat_side(const struct tia_flat_scene *flat, const struct tia_flat_face *face, const tia_flat_light *light);

/* Returns the side of a face's plane on which the eye is, as tia_flat_side does. */
int tia_flat_side_of_eye(const struct tia_flat_scene *flat, const struct tia_flat_face *face);

/* True if the visible side of a face is turned to the light. */
bool tia_flat_is_turned(const struct tia_flat_scene *flat, uint32_t face, const tia_flat_light *light);

/* True if the object cannot hide the light from any visible point: it is a plane, with the eye and the light on the
 * same side. */
bool tia_flat_hides_nothing(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                            const tia_flat_light *light);

/* True if the silhouette suffices. Of a closed surface with the light and the eye outside, the faces turned to the
 * light are enough, and only their silhouette has sides: the segment from a visible point to the light starts and ends
 * outside, so it crosses as many of these as of the others, however the surface is oriented and even if it crosses
 * itself. Otherwise each face casts for itself, which is right for any faces. */
bool tia_flat_has_silhouette(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                             const tia_flat_light *light);

/* Counts the volumes that contain the eye, from which rays come. False when it lies exactly on the surface of a volume:
 * then z-pass is undecided. Once cancelled, the count is undefined. */
bool tia_shadow_count_eye(const struct tia_flat_scene *flat, const tia_flat_light *light, uint32_t *count,
                          struct cancel *cancel);
/* Counts the volumes that contain the point at infinity to which rays go: 0 in perspective, where each ray goes to a
 * different point. False when it lies exactly on the surface of a volume: then, in orthographic views, z-fail is
 * undecided. */
bool tia_shadow_count_far(const struct tia_flat_scene *flat, const tia_flat_light *light, uint32_t *count,
                          struct cancel *cancel);

/* Draws the visible faces into depth and faces of the target, which must be empty. TIA_STOPPED when cancelled, also
 * from the two functions below. */
int tia_shadow_faces(struct tia_raster_target *target, const struct tia_flat_scene *flat, struct cancel *cancel);

/* With the faces drawn, adds to each pixel's count the number of volumes that contain its point, less the number of
 * those that contain the point at infinity. There are at most as many as faces, so 32 bits never wrap; a stencil buffer
 * of 8 bits shows light where 256 volumes contain a point. */
int tia_shadow_zfail(struct tia_raster_target *target, const struct tia_flat_scene *flat, const tia_flat_light *light,
                     struct cancel *cancel);

/* Counts as tia_shadow_zfail does, but subtracts the number of volumes that contain the eye. */
int tia_shadow_zpass(struct tia_raster_target *target, const struct tia_flat_scene *flat, const tia_flat_light *light,
                     struct cancel *cancel);

#endif
