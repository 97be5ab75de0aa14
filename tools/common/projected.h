/* projected.h - where a scene's points are in its picture. */
#ifndef TOOLS_COMMON_PROJECTED_H
#define TOOLS_COMMON_PROJECTED_H

#include <tia/scene.h>

/* Part of the segment from `a` to `b` before the camera, as pixel coordinates x, y of its ends; false: there is none.
 */
bool projected_segment(const struct tia_camera *camera, unsigned width, unsigned height, struct tia_vec3 a,
                       struct tia_vec3 b, double ends[2][2]);

#endif
