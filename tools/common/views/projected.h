/* projected.h - projects points of a scene into its picture. */
#ifndef TOOLS_VIEWS_PROJECTED_H
#define TOOLS_VIEWS_PROJECTED_H

#include <tia/scene.h>

/* Stores in `ends` the pixel coordinates x, y of both ends of that part of the segment from `a` to `b` which is in
 * front of the camera. Returns false if no part is. */
bool projected_segment(const struct tia_camera *camera, unsigned width, unsigned height, struct tia_vec3 a,
                       struct tia_vec3 b, double ends[2][2]);

/* Returns the point moved parallel to the picture's plane, by `right` pixels to the right and `down` pixels down. A
 * pixel has its size at the point's distance. For a point outside the picture, half of the picture's width counts as
 * the point's distance. The result is clamped to the range of Q16.16. */
struct tia_vec3 projected_dragged(const struct tia_camera *camera, unsigned width, unsigned height,
                                  struct tia_vec3 point, double right, double down);

#endif
