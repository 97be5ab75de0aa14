/* embree.h - draws scenes of the Standard Procedural Databases with Embree 3, for comparison. Points are shaded by
 * Whitted's method, all in float. Camera, bias, depth and the limit for faint rays are those of tia. */
#ifndef BENCH_EMBREE_EMBREE_H
#define BENCH_EMBREE_EMBREE_H

#include <tia/tia.h>

struct embree;

/* Ways to trace rays. All but the first trace the rays of a tile that have the same depth at once. */
enum embree_way {
    EMBREE_SINGLE, /* one after the other, by rtcIntersect1 and rtcOccluded1 */
    EMBREE_PACKETS_8,
    EMBREE_PACKETS_16,
    EMBREE_FIRST_8, /* the eye's rays and their shadow rays in packets, the others singly */
    EMBREE_FIRST_16,
    EMBREE_STREAMS, /* by rtcIntersect1M and rtcOccluded1M */
    EMBREE_WAYS
};

extern const char *const embree_ways[EMBREE_WAYS]; /* their names */

/* False if the program was built without Embree: then embree_open always returns NULL. */
extern const bool embree_is_there;

/* Opens a scene, which must outlive the result. Returns NULL if the scene has shapes, lights or textures that are not
 * supported here, or if memory is short. */
struct embree *embree_open(const struct tia_scene *scene);
void embree_close(struct embree *embree);

/* Returns false if a tile has too many rays. One picture of a scene is drawn at a time. */
bool embree_draw(const struct embree *embree, enum embree_way way, uint16_t width, uint16_t height, tia_rgb565 *pixels);

#endif
