/* volume.h - shadow volumes (Crow 1977): the space that a caster hides from a light. The number of volumes that contain
 * a visible point is found by counting their surfaces behind the point (z-fail: Bilodeau and Songy 1999, Carmack 2000),
 * or those in front of it, plus the number of volumes that contain the eye (z-pass: Heidmann 1991).
 *
 * Corners are rounded once; all that follows is exact, see raster.h. So a volume's surface closes without a gap: each
 * edge of a cap is the edge of a side, in the same integers. A visible face has the same depth as its own cap, which
 * counts as behind the face: no face shadows itself, and no bias is needed. */
#ifndef TIA_SHADOW_VOLUME_H
#define TIA_SHADOW_VOLUME_H

#include "volume_casters.h"

/* Counts the volumes that contain the eye, where rays start. False when the eye is exactly on the surface of a volume:
 * then z-pass is undecided. Once cancelled, the count is undefined. */
bool tia_shadow_count_eye(const struct tia_flat_scene *flat, struct tia_shadow_light light, uint32_t *count,
                          struct cancel *cancel);
/* Counts the volumes that contain the point at infinity where rays end: 0 in perspective, where each ray ends at a
 * different point. False when that point is exactly on the surface of a volume: then, in orthographic views, z-fail is
 * undecided. */
bool tia_shadow_count_far(const struct tia_flat_scene *flat, struct tia_shadow_light light, uint32_t *count,
                          struct cancel *cancel);

/* Draws the visible faces into the target's depth and faces, which must be empty. Returns TIA_OK, or TIA_STOPPED when
 * cancelled; so do the two functions below. */
int tia_shadow_faces(struct tia_raster_target *target, const struct tia_flat_scene *flat, struct cancel *cancel);

/* After tia_shadow_faces, adds to each pixel's count the number of volumes that contain its point, less the number of
 * volumes that contain the point at infinity. No point is in more volumes than there are faces, so 32 bits never wrap.
 * (A stencil buffer of 8 bits would show light where 256 volumes contain a point.) */
int tia_shadow_zfail(struct tia_raster_target *target, const struct tia_flat_scene *flat, struct tia_shadow_light light,
                     struct cancel *cancel);

/* Counts as tia_shadow_zfail does, but subtracts the number of volumes that contain the eye. */
int tia_shadow_zpass(struct tia_raster_target *target, const struct tia_flat_scene *flat, struct tia_shadow_light light,
                     struct cancel *cancel);

#endif
