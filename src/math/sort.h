/* sort.h - sorting without allocation, in linear time. */
#ifndef TIA_MATH_SORT_H
#define TIA_MATH_SORT_H

#include <stdint.h>

/* Sorts ids by keys[id], ascending. Ids with equal keys keep their order: so consecutive sorts by several keys, the
 * least important first, sort by all of them. `room` has space for `count` ids. */
void tia_sort_ids(uint32_t *ids, uint32_t *room, uint32_t count, const uint32_t *keys);

#endif
