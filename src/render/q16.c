/* q16.c - the public functions that take no core: they use tia_core_q16. */
#include "renderer.h"

size_t tia_view_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    return tia_core_view_size(&tia_core_q16, scene, light_capacity);
}

int tia_view_init(struct tia_view **view, void *memory, size_t size, const struct tia_scene *scene,
                  uint32_t light_capacity, unsigned width, unsigned height, const struct tia_job *job)
{
    return tia_core_view_init(&tia_core_q16, view, memory, size, scene, light_capacity, width, height, job);
}

size_t tia_hits_size(const struct tia_scene *scene, struct tia_tile area)
{
    return tia_core_hits_size(&tia_core_q16, scene, area);
}

size_t tia_simd_size(const struct tia_simd *simd, const struct tia_scene *scene, uint32_t light_capacity,
                     unsigned workers)
{
    return tia_core_simd_size(&tia_core_q16, simd, scene, light_capacity, workers);
}

bool tia_draws_by_pixel(const struct tia_scene *scene)
{
    return tia_core_draws_by_pixel(&tia_core_q16, scene);
}
