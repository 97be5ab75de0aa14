/* near.h - a quick conservative test of a segment against a box: false hits are possible, false misses are not. */
#ifndef TIA_RADIO_NEAR_H
#define TIA_RADIO_NEAR_H

#include "face_planes.h"

struct near {
    int64_t low[3], high[3];    /* box around both ends, enlarged by 4 units, since the sides of rotated boxes are
                                 * slightly off their planes */
    int64_t middle[3], half[3]; /* a + b and b - a, in units of 2^10 */
};

/* Prepares the tests of the segment from a to b; their coordinates are below 2^35 in size. */
static inline void near_begin(struct near *s, const int64_t a[3], const int64_t b[3])
{
    for (int k = 0; k < 3; k++) {
        s->low[k] = (a[k] < b[k] ? a[k] : b[k]) - 4;
        s->high[k] = (a[k] < b[k] ? b[k] : a[k]) + 4;
        s->middle[k] = (a[k] + b[k]) >> 10;
        s->half[k] = (b[k] - a[k]) >> 10;
    }
}

static inline int64_t near_size(int64_t a)
{
    return a < 0 ? -a : a;
}

/* True if the segment is near the box: no separating axis exists among the box's axes and their cross products with the
 * segment. In units of 2^10, numbers are below 2^28, and products below 2^58. All lengths are rounded up. */
static inline bool near_box(const struct near *s, const struct tia_bounds *box)
{
    int64_t c[3], e[3];

    for (int k = 0; k < 3; k++) {
        int64_t low = radio_axis(&box->min, k), high = radio_axis(&box->max, k);
        if (high < s->low[k] || low > s->high[k])
            return false;
        c[k] = ((low + high) >> 10) - s->middle[k]; /* twice the distance between the middles */
        e[k] = ((high - low) >> 10) + 6;
    }
    for (int k = 0; k < 3; k++) {
        int u = (k + 1) % 3, v = (k + 2) % 3;
        int64_t apart = near_size(c[u] * s->half[v] - c[v] * s->half[u]);
        int64_t reach = e[u] * (near_size(s->half[v]) + 2) + e[v] * (near_size(s->half[u]) + 2);
        if (apart > reach + 2 * (near_size(c[u]) + near_size(c[v])))
            return false;
    }
    return true;
}

#endif
