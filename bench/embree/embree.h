/* embree.h - the scenes of the Standard Procedural Databases drawn by Embree 3, for comparison: rtcIntersect1 and
 * rtcOccluded1 in float, one ray at a time, and Whitted's shading around them, also in float. The rays are tia's: its
 * camera, its bias, its depth, and its limit for faint rays. */
#ifndef BENCH_EMBREE_EMBREE_H
#define BENCH_EMBREE_EMBREE_H

#include <tia/tia.h>

struct embree;

/* False if this was built without Embree: then embree_open always returns NULL. */
extern const bool embree_is_there;

/* Opens a scene, which must outlive the result. NULL when the scene has shapes, lights or textures that are not
 * supported here, or memory is short. */
struct embree *embree_open(const struct tia_scene *scene);
void embree_close(struct embree *embree);

void embree_draw(const struct embree *embree, uint16_t width, uint16_t height, tia_rgb565 *pixels);

#endif
