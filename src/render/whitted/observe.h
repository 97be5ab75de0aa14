/* observe.h - reports rays to an observer, see struct tia_observer. Builds without observers report nothing. */
#ifndef TIA_RENDER_WHITTED_OBSERVE_H
#define TIA_RENDER_WHITTED_OBSERVE_H

#include "ray_tree.h"

static inline bool path_is_watched(const struct path *path)
{
#ifdef TIA_WATCHED
    return path->observer != NULL;
#else
    (void)path;
    return false;
#endif
}

static inline void observe_begin(struct path *path, const struct tia_options *options)
{
#ifdef TIA_WATCHED
    path->observer = options_debug(options).observer;
#else
    (void)path;
    (void)options;
#endif
}

/* Makes the ray count its tests in the observer's counter. */
static inline void observe_count(const struct path *path, struct ray *ray)
{
#ifdef TIA_WATCHED
    ray_watch(ray, path->observer ? &path->observer->tests : NULL);
#else
    (void)path;
    (void)ray;
#endif
}

/* Reports a ray; `normal` is that of the surface that the ray meets, NULL if it meets a light or nothing. */
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
