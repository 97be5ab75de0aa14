/* observe.h - tells an observer of rays, see struct tia_observer. */
#ifndef TIA_RENDER_WHITTED_OBSERVE_H
#define TIA_RENDER_WHITTED_OBSERVE_H

#include "path.h"

/* `normal` is that of the surface that the ray meets; NULL: it meets a light or nothing. */
void observe_ray(const struct path *path, enum tia_ray kind, const struct ray *ray, const struct hit *hit,
                 const struct num_dir *normal);

/* A shadow ray from a point of an object to a sample of a light. */
struct observed_shadow {
    uint32_t object;
    struct num_point from;
    struct num_dir normal;
    const struct ray_light *light;
    const struct ray_sample *sample;
    bool arrives;
};

void observe_shadow(const struct path *path, const struct observed_shadow *shadow);

#endif
