/* no_bvh.c - stands in for src/bvh in programs that have no room for it. */
#include <tia/bvh.h>

size_t tia_bvh_size(const struct tia_scene *scene)
{
    (void)scene;
    return 0;
}

int tia_bvh_build(const struct tia_bvh **bvh, void *memory, size_t size, size_t *used, const struct tia_scene *scene)
{
    (void)bvh;
    (void)memory;
    (void)size;
    (void)used;
    (void)scene;
    return TIA_ERR_UNSUPPORTED;
}
