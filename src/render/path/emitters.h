/* emitters.h - sampling of emitters: the scene's lights and its emitting spheres.
 *
 * Densities are per solid angle, times pi: so the density of Lambert's law is the cosine. */
#ifndef TIA_RENDER_PATH_EMITTERS_H
#define TIA_RENDER_PATH_EMITTERS_H

#include "num/num_estimate.h"
#include "render/trace/trace.h"

enum emitter_kind { EMITTER_POINT, EMITTER_PLANE, EMITTER_SPHERE };

struct emitter {
    enum emitter_kind kind;        /* points have no surface; they include directional and spot lights */
    const struct ray_light *light; /* NULL: a sphere of the scene */
    num_length radiance[3];        /* for a point, the light's emission, see tia/light.h */
    struct num_point centre;       /* centre of a sphere */
    num_length radius;
    struct num_density area; /* area of a plane */
};

struct emitters {
    struct emitter *first;
    uint32_t count, spheres;   /* numbers of all emitters, and of emitting spheres, which are the last ones */
    struct num_density one_of; /* 1/count */
};

/* A sample of an emitter, seen from a point. */
struct emitter_sample {
    struct num_dir to;
    num_length distance; /* length of the shadow ray, which ends `bias` in front of a surface */
    num_length radiance[3];
    struct num_density density; /* 0 for a point */
};

/* Returns the size in bytes of the emitters of `light_capacity` lights and of the scene's spheres. */
uint64_t emitters_size(const struct tia_scene *scene, uint32_t light_capacity);
int emitters_prepare(struct emitters *emitters, const struct ray_view *view, void *memory);
void emitters_set(struct emitters *emitters, const struct ray_view *view);

/* Samples an emitter from the point `from`, whose normal is `facing`. Returns false if the sample gives no light. The
 * shadow ray ends `bias` in front of the emitter's surface. */
bool emitter_sample(const struct emitter *emitter, struct num_point from, struct num_dir facing, num_length bias,
                    const uint32_t u[2], struct emitter_sample *sample);

/* Returns the density with which emitter_sample, from the point `from`, chooses the surface point in the direction `to`
 * at `distance`; for a sphere, the density is the same for all its visible points. */
struct num_density emitter_density(const struct emitter *emitter, struct num_point from, struct num_dir to,
                                   num_length distance);

/* Initialises the emitter of a light with a surface. */
void emitter_of_light(const struct ray_light *light, const struct tia_light *given, struct emitter *emitter);
/* Initialises the emitter of one of the scene's spheres. */
void emitter_of_sphere(const struct tia_scene *scene, uint32_t sphere, struct emitter *emitter);

/* Computes the emission times 2^bits. */
void emitter_radiance(const struct tia_rgb *emission, uint8_t bits, num_length radiance[3]);

#endif
