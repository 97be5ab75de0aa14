/* no_embree.c - for builds without Embree. */
#include "embree.h"

const bool embree_is_there = false;
const char *const embree_ways[EMBREE_WAYS];

struct embree *embree_open(const struct tia_scene *scene)
{
    (void)scene;
    return NULL;
}

void embree_close(struct embree *embree)
{
    (void)embree;
}

bool embree_draw(const struct embree *embree, enum embree_way way, uint16_t width, uint16_t height, tia_rgb565 *pixels)
{
    (void)embree;
    (void)way;
    (void)width;
    (void)height;
    (void)pixels;
    return false;
}
