/* axes.h - the axes of a camera, in integers: u, v and n of camera.h. */
#ifndef TIA_SCENE_AXES_H
#define TIA_SCENE_AXES_H

#include <tia/camera.h>

/* Writes c = a x b; all are Q1.62. */
void tia_axes_cross(const int64_t a[3], const int64_t b[3], int64_t c[3]);

/* Writes the rows u, v and n, Q1.62, of a camera that tia_scene_check accepts. `back` is the vector from the reference
 * point to the eye, in any unit; its coordinates are below 2^60 in size. */
void tia_camera_axes(int64_t axes[3][3], const struct tia_camera *camera, const int64_t back[3]);

#endif
