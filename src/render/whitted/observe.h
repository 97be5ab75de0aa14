/* observe.h - tells an observer of rays, see struct tia_observer. */
#ifndef TIA_RENDER_WHITTED_OBSERVE_H
#define TIA_RENDER_WHITTED_OBSERVE_H

#include "shade.h"

/* A ray that meets a light, nothing, or the surface `s`, otherwise NULL. */
void observe_ray(const struct path *path, enum tia_ray kind, const struct ray *ray, const struct hit *hit,
                 const struct shading *s);

/* The shadow ray to a sample of a light. */
void observe_shadow(const struct path *path, const struct shading *s, const struct ray_light *light,
                    const struct ray_sample *sample, bool arrives);

#endif
