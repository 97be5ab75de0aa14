/* orbit.h - camera movement: around the point that it looks at, along its own axes, nearer. In integers, so that the
 * same keys lead to the same position on every machine. tia_scene_check may refuse the resulting camera: then keep the
 * old one.
 */
#ifndef TIA_ORBIT_H
#define TIA_ORBIT_H

#include <tia/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Gives a camera that looks along -z a reference point on its line of sight: as far away as the object in front of it
 * that is least off that line; 10 where there is none. Other cameras stay as they are. The scene is one that
 * tia_scene_check accepts. */
void tia_camera_aim(struct tia_camera *camera, const struct tia_scene *scene);

/* Turns the eye around the reference point: by `right` degrees about the up vector, then by `up` degrees towards it,
 * each in -180..180. It stops 3 degrees before the axis through the reference point along the up vector. Does nothing
 * with other angles, without an up vector, and where the points are 32768 or more apart. */
void tia_camera_orbit(struct tia_camera *camera, tia_q16 right, tia_q16 up);

/* Moves the eye and the reference point along the camera's axes, to the right, up and ahead: in 32nds of their
 * distance, which is less than 32768. A move out of range does nothing. */
void tia_camera_walk(struct tia_camera *camera, int right, int up, int ahead);

/* Narrows the view to 7/8, or widens it to 8/7: the field of view within TIA_FOV_MIN and 120 degrees, or the window. */
void tia_camera_zoom(struct tia_camera *camera, bool in);

#ifdef __cplusplus
}
#endif

#endif
