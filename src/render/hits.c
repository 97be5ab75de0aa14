#include "hits.h"

#include "math/align.h"

#define HEADER ALIGN(sizeof(struct tia_hits))

size_t tia_hits_size(struct tia_tile area)
{
    uint64_t size = HEADER + (uint64_t)((uint32_t)area.width * area.height) * (sizeof(num_u) + sizeof(uint32_t));

    return size < SIZE_MAX ? (size_t)size : SIZE_MAX;
}

int tia_hits_init(struct tia_hits **hits, void *memory, size_t size, struct tia_tile area)
{
    struct tia_hits *h = memory;

    if (!area.width || !area.height)
        return TIA_ERR_ARGUMENT;
    if (size < tia_hits_size(area))
        return TIA_ERR_MEMORY;
    h->area = area;
    h->t = (num_u *)((char *)memory + HEADER);
    h->object = (uint32_t *)(h->t + (size_t)area.width * area.height);
    *hits = h;
    return TIA_OK;
}

uint32_t tia_hits_object(const struct tia_hits *hits, unsigned x, unsigned y)
{
    return hits->object[hits_index(hits, x, y)];
}
