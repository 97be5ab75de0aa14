/* orbit.h - moving a camera: around what it looks at, along its own axes, nearer. In integers, so that the same keys
 * lead to the same place on every machine. What comes out may be refused by tia_scene_check: then do not take it.
 */
#ifndef TIA_ORBIT_H
#define TIA_ORBIT_H

#include <tia/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Makes a camera that looks along -z look at a point: as far away as the object, of those before it, that is the least
 * off its line of sight; 10 where there is none. Others stay as they are. */
void tia_camera_aim(struct tia_camera *camera, const struct tia_scene *scene);

/* Turns the eye around the reference point: by `right` degrees about the up vector, then by `up` degrees towards it,
 * each in -180..180; not nearer than 3 degrees to the line through the reference point along it, where it stays. Both
 * points less than 32768 apart. */
void tia_camera_orbit(struct tia_camera *camera, tia_q16 right, tia_q16 up);

/* Moves the eye and the reference point along the camera's axes, to the right, up and ahead: by these 32nds of their
 * distance. What would leave the range stays. */
void tia_camera_walk(struct tia_camera *camera, int right, int up, int ahead);

/* Narrows the view to 7/8, or widens it to 8/7: the field of view within TIA_FOV_MIN and 120 degrees, or the window. */
void tia_camera_zoom(struct tia_camera *camera, bool in);

#ifdef __cplusplus
}
#endif

#endif
