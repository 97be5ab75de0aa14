/* embree.h - draws scenes of the Standard Procedural Databases with Embree 3, for comparison. Rays are traced one at a
 * time by rtcIntersect1 and rtcOccluded1, and shaded by Whitted's method, all in float. Camera, bias, depth and the
 * limit for faint rays are those of tia. */
#ifndef BENCH_EMBREE_EMBREE_H
#define BENCH_EMBREE_EMBREE_H

#include <tia/tia.h>

struct embree;

/* False if the program was built without Embree: then embree_open always returns NULL. */
extern const bool embree_is_there;

/* Opens a scene, which must outlive the result. Returns NULL if the scene has shapes, lights or textures that are not
 * supported here, or if memory is short. */
struct embree *embree_open(const struct tia_scene *scene);
void embree_close(struct embree *embree);

void embree_draw(const struct embree *embree, uint16_t width, uint16_t height, tia_rgb565 *pixels);

#endif
