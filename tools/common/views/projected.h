/* projected.h - where a scene's points are in its picture. */
#ifndef TOOLS_VIEWS_PROJECTED_H
#define TOOLS_VIEWS_PROJECTED_H

#include <tia/scene.h>

/* Part of the segment from `a` to `b` before the camera, as pixel coordinates x, y of its ends; false: there is none.
 */
bool projected_segment(const struct tia_camera *camera, unsigned width, unsigned height, struct tia_vec3 a,
                       struct tia_vec3 b, double ends[2][2]);

/* The point moved parallel to the picture by so many pixels to the right and down: as it is seen where it stands, or by
 * its distance for half of the picture's width, where it is not in the picture. Clamped to the range of Q16.16. */
struct tia_vec3 projected_dragged(const struct tia_camera *camera, unsigned width, unsigned height,
                                  struct tia_vec3 point, double right, double down);

#endif
