/* embree_waves.h - pictures by waves: all rays of a tile that have the same depth are traced at once, then their shadow
 * rays, then the rays that they send on. */
#ifndef BENCH_EMBREE_EMBREE_WAVES_H
#define BENCH_EMBREE_EMBREE_WAVES_H

#include "embree_world.h"

struct eye_rays;

/* Returns false if a tile has too many rays. */
bool embree_draw_waves(const struct embree *e, enum embree_way way, const struct eye_rays *eye, tia_rgb565 *pixels);

#endif
