/* sort.c - radix sort, a byte of the keys at a time (Knuth, The Art of Computer Programming 3, 5.2.5). */
#include "sort.h"

static void sort_by_byte(const uint32_t *from, uint32_t *to, uint32_t count, const uint32_t *keys, unsigned shift)
{
    uint32_t place[256] = {0}, next = 0;

    for (uint32_t i = 0; i < count; i++)
        place[keys[from[i]] >> shift & 255]++;
    for (unsigned b = 0; b < 256; b++) {
        uint32_t here = place[b];
        place[b] = next;
        next += here;
    }
    for (uint32_t i = 0; i < count; i++)
        to[place[keys[from[i]] >> shift & 255]++] = from[i];
}

void tia_sort_ids(uint32_t *ids, uint32_t *room, uint32_t count, const uint32_t *keys)
{
    for (unsigned shift = 0; shift < 32; shift += 16) {
        sort_by_byte(ids, room, count, keys, shift);
        sort_by_byte(room, ids, count, keys, shift + 8);
    }
}
