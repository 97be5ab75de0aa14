/* hits.h - what each pixel of an area sees: structure of arrays, row by row. */
#ifndef TIA_HITS_H
#define TIA_HITS_H

#include "num/num.h"

struct tia_hits {
    struct tia_tile area;
    num_u *t;         /* the distance along v, with the exponent of the object's body */
    uint32_t *object; /* a body's index, or TIA_NO_OBJECT: then t is not defined */
};

static inline size_t hits_index(const struct tia_hits *hits, unsigned x, unsigned y)
{
    return (size_t)(y - hits->area.y) * hits->area.width + (x - hits->area.x);
}

#endif
