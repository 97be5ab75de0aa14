/* orbit.h - moves a camera around its reference point and along its axes, and zooms; in integers, so that the same keys
 * lead to the same position on every machine. tia_scene_check may refuse the resulting camera: then restore the old
 * one.
 */
#ifndef TIA_ORBIT_H
#define TIA_ORBIT_H

#include <tia/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Prepares a camera without an up vector, which looks along -z, for the functions below. Its up vector becomes +y, and
 * its reference point is set on the line of sight: as far away as the object in front of the camera that is least off
 * that line, or at the distance 10 if there is none. Other cameras stay as they are. The scene is one that
 * tia_scene_check accepts. */
void tia_camera_aim(struct tia_camera *camera, const struct tia_scene *scene);

/* Turns the eye around the reference point: by `right` degrees about the up vector, then by `up` degrees towards that
 * vector, each in -180..180. The second turn is left out if it would end within 3 degrees of the axis through the
 * reference point along the up vector. Does nothing with other angles, without an up vector, and when eye and reference
 * point are 32768 or more apart. */
void tia_camera_orbit(struct tia_camera *camera, tia_q16 right, tia_q16 up);

/* Moves the eye and the reference point along the camera's axes, to the right, up and ahead, in 32nds of the distance
 * between them. Does nothing when that distance is 32768 or more, or when a coordinate would leave Q16.16. */
void tia_camera_walk(struct tia_camera *camera, int right, int up, int ahead);

/* Multiplies the field of view or, in other projections, the window by 7/8 if `in`, else by 8/7. The field of view
 * stays as it is if it would be below TIA_FOV_MIN or would grow beyond 120 degrees. */
void tia_camera_zoom(struct tia_camera *camera, bool in);

#ifdef __cplusplus
}
#endif

#endif
