/* sort.h - sorting without memory of its own, in time that grows only with the count. */
#ifndef TIA_MATH_SORT_H
#define TIA_MATH_SORT_H

#include <stdint.h>

/* Sorts ids by keys[id], rising; ids with equal keys keep their order, so that sorting by several keys, the least
 * important first, sorts by all of them. `room` has place for `count` ids. */
void tia_sort_ids(uint32_t *ids, uint32_t *room, uint32_t count, const uint32_t *keys);

#endif
