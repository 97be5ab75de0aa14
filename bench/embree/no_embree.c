/* no_embree.c - for builds without Embree. */
#include "embree.h"

const bool embree_is_there = false;

struct embree *embree_open(const struct tia_scene *scene)
{
    (void)scene;
    return NULL;
}

void embree_close(struct embree *embree)
{
    (void)embree;
}

void embree_draw(const struct embree *embree, uint16_t width, uint16_t height, tia_rgb565 *pixels)
{
    (void)embree;
    (void)width;
    (void)height;
    (void)pixels;
}
