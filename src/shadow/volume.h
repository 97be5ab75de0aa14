/* volume.h - shadow volumes (Crow 1977): the space that a caster hides from a light. The number of volumes that contain
 * a visible point is found by counting their surfaces behind the point (z-fail: Bilodeau and Songy 1999, Carmack 2000),
 * or those in front of it, plus the number of volumes that contain the eye (z-pass: Heidmann 1991).
 *
 * Corners are rounded once; all that follows is exact, see raster.h. So a volume's surface closes without a gap: each
 * edge of a cap is the edge of a side, in the same integers. A visible face has the same depth as its own cap, which
 * counts as behind the face: no face shadows itself, and no bias is needed. */
#ifndef TIA_SHADOW_VOLUME_H
#define TIA_SHADOW_VOLUME_H

#include "flat/light_vertices.h"
#include "scene/cancel.h"

/* Returns the side of a face's plane on which the light is: 1 where the corners run counterclockwise seen from the
 * light, -1 on the opposite side, 0 in the plane. */
int tia_flat_side(const struct tia_flat_scene *flat, const struct tia_flat_face *face, const tia_flat_light *light);

/* Returns the side of a face's plane on which the eye is, as tia_flat_side does. */
int tia_flat_side_of_eye(const struct tia_flat_scene *flat, const struct tia_flat_face *face);

/* True if the visible side of a face is turned to the light. */
bool tia_flat_is_turned(const struct tia_flat_scene *flat, uint32_t face, const tia_flat_light *light);

/* True if the object cannot hide the light from any visible point: it is a plane, with the eye and the light on the
 * same side. */
bool tia_flat_hides_nothing(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                            const tia_flat_light *light);

/* True if the object's silhouette suffices. If the light and the eye are outside a closed surface, only the faces
 * turned to the light need to cast volumes, with sides only at their silhouette. The reason: the segment from a visible
 * point to the light starts and ends outside, so it crosses as many faces turned to the light as others, even if the
 * surface crosses itself, and however it is oriented. Otherwise each face casts a volume of its own, which is correct
 * for any faces. */
bool tia_flat_has_silhouette(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                             const tia_flat_light *light);

/* Counts the volumes that contain the eye, where rays start. False when the eye is exactly on the surface of a volume:
 * then z-pass is undecided. Once cancelled, the count is undefined. */
bool tia_shadow_count_eye(const struct tia_flat_scene *flat, const tia_flat_light *light, uint32_t *count,
                          struct cancel *cancel);
/* Counts the volumes that contain the point at infinity where rays end: 0 in perspective, where each ray ends at a
 * different point. False when that point is exactly on the surface of a volume: then, in orthographic views, z-fail is
 * undecided. */
bool tia_shadow_count_far(const struct tia_flat_scene *flat, const tia_flat_light *light, uint32_t *count,
                          struct cancel *cancel);

/* Draws the visible faces into the target's depth and faces, which must be empty. Returns TIA_OK, or TIA_STOPPED when
 * cancelled; so do the two functions below. */
int tia_shadow_faces(struct tia_raster_target *target, const struct tia_flat_scene *flat, struct cancel *cancel);

/* After tia_shadow_faces, adds to each pixel's count the number of volumes that contain its point, less the number of
 * volumes that contain the point at infinity. No point is in more volumes than there are faces, so 32 bits never wrap.
 * (A stencil buffer of 8 bits would show light where 256 volumes contain a point.) */
int tia_shadow_zfail(struct tia_raster_target *target, const struct tia_flat_scene *flat, const tia_flat_light *light,
                     struct cancel *cancel);

/* Counts as tia_shadow_zfail does, but subtracts the number of volumes that contain the eye. */
int tia_shadow_zpass(struct tia_raster_target *target, const struct tia_flat_scene *flat, const tia_flat_light *light,
                     struct cancel *cancel);

#endif
