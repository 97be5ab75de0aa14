/* no_embree.c - for builds without Embree. */
#include "embree.h"
#include "embree_items.h"

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

struct embree_items *embree_items_open(const struct float_world *world)
{
    (void)world;
    return NULL;
}

void embree_items_close(struct embree_items *items)
{
    (void)items;
}

void embree_items_meet(const void *items, const struct float_ray *ray, bool any, struct float_hit *hit)
{
    (void)items;
    (void)ray;
    (void)any;
    (void)hit;
}

unsigned embree_modes_begin(void)
{
    return 0;
}

void embree_modes_end(unsigned before)
{
    (void)before;
}
