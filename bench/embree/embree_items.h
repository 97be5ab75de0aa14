/* embree_items.h - the items of a struct float_world in Embree 3, to trace single rays. */
#ifndef BENCH_EMBREE_EMBREE_ITEMS_H
#define BENCH_EMBREE_EMBREE_ITEMS_H

#include "float_world.h"

struct embree_items;

/* Opens the items of a world, which must outlive the result. Returns NULL if the program was built without Embree, or
 * if memory is short. */
struct embree_items *embree_items_open(const struct float_world *world);
void embree_items_close(struct embree_items *items);

/* As float_world_meet, by rtcIntersect1, or rtcOccluded1 with `any`; `items` is a struct embree_items. For rtcOccluded1
 * the item found is any of the world, and hit->t is left. */
void embree_items_meet(const void *items, const struct float_ray *ray, bool any, struct float_hit *hit);

/* Sets the modes of floating point that Embree requires, and returns those before; or sets these again. */
unsigned embree_modes_begin(void);
void embree_modes_end(unsigned before);

#endif
