/* shade.h - shading of a point on a surface: the light from the point, and the rays spawned there. */
#ifndef TIA_RENDER_WHITTED_SHADE_H
#define TIA_RENDER_WHITTED_SHADE_H

#include "ray_tree.h"
#include "render/trace/shading.h"

/* Prepares the shading of a ray's hit, and adds the hit to the path's hash. */
void shade_prepare(struct path *path, const struct ray *ray, const struct hit *hit, struct shading *s);

/* Adds to `colour` the light that the surface itself sends along V (emission, facing ratio and light reflected from
 * lights), times its opacity and the throughput. */
void shade_light(struct path *path, const struct shading *s, const num_length throughput[3], num_length colour[3]);

/* The reflected and the refracted ray with their kr and kt, and the undeflected ray behind a surface whose opacity is
 * below 1. A ray whose factors are all 0 is not set. */
struct bounces {
    struct ray reflected, refracted, past;
    num_length reflects[3], refracts[3], passes[3];
    struct media media;      /* media of `refracted` and of `past` */
    bool straight;           /* the refracted ray is undeflected, and stands for `past` as well */
    struct boundary between; /* what `refracted` crosses; not set without refraction and opacity */
    /* In views that are filtered: the cones' width and, by enum tia_ray - TIA_RAY_REFLECTED, their spreads. */
    num_length width, spread[3];
};

/* Sets the bounces; `media` are those of the incoming ray. */
void shade_bounce(const struct ray_view *view, const struct shading *s, const struct media *media,
                  struct bounces *bounces);

void path_hash_word(struct path *path, uint32_t word);

#endif
