/* estimate.h - pixels as means of an integrator's samples; see tia/integrator.h. */
#ifndef TIA_RENDER_ESTIMATE_ESTIMATE_H
#define TIA_RENDER_ESTIMATE_ESTIMATE_H

#include "num/num_estimate.h"
#include "render/trace/shading.h"
#include "samples/sobol.h"

#define ESTIMATE_KNOWN 16 /* most rays of a sample whose hits are known */

/* The hits of a sample's first rays, as SIMD kernels have found them: ray number i meets `object`, or `light`, or
 * neither. Bit i of `shadows_known` is set if the result of the shadow ray from that hit is known, too, and bit i of
 * `lights_reached` if that ray reaches its light. */
struct estimate_known {
    struct {
        uint32_t object, light; /* TIA_NO_OBJECT: none */
    } hit[ESTIMATE_KNOWN];
    uint32_t count, shadows_known, lights_reached;
};

/* A sample, and the state shared by consecutive samples. */
struct estimate {
    const struct ray_view *view;
    const struct estimate_known *known; /* NULL: nothing is known */
    uint32_t met;                       /* number of the sample's rays so far, without shadow rays */
    num_length bias;                    /* offset of rays from surfaces */
    struct sampler sampler;
    uint32_t layers;         /* number of random choices made for opacity textures */
    uint32_t hash;           /* hash of the hits of all rays of the pixel's samples */
    uint32_t blocker;        /* object that blocked the last shadow ray, or TIA_NO_OBJECT */
    struct tia_guide *guide; /* the pixel's guide; NULL: not requested, or already filled in by the sample */
    unsigned rays;           /* number of rays since the last call of `stop` */
    bool stopped;
};

/* The quad of random numbers for the position in the pixel (two numbers) and for the first direction (two). */
#define ESTIMATE_FIRST_QUAD 0

/* Computes the radiance along a sample's first ray. */
typedef void estimate_radiance(struct estimate *e, const struct ray *ray, num_length rgb[3]);

/* Implements `sample` of struct renderer. */
void estimate_sample_tile(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                          const struct tia_gathered *gathered, estimate_radiance *radiance);
/* Adds sample number `index` of pixel (x, y), of which `known` is known. */
void estimate_resume(const struct tia_view *view, int x, int y, uint32_t index, const struct estimate_known *known,
                     const struct tia_gathered *pixel, estimate_radiance *radiance);
/* Implements `light` of struct renderer. */
void estimate_light_tile(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                         const struct tia_options *options, estimate_radiance *radiance);

/* Writes a row's pixels from sums of `count` samples. */
void estimate_show(const struct tia_view *view, struct tia_tile row, const struct tia_sum *sums, uint32_t count,
                   const struct tia_surface *surface, bool dither);

/* Counts a ray. Returns true once `stop` has returned true. */
bool estimate_stops(struct estimate *e);

/* Finds the surface at which the ray ends. At a surface with an opacity texture, the ray passes at random, and its
 * origin moves behind the surface. Returns false if no surface is met, but perhaps a light of the kinds `lights`, see
 * ray_intersect_lights_of; or if stopped. */
bool estimate_meet(struct estimate *e, struct ray *ray, unsigned lights, struct hit *hit, struct shading *s);

/* True if it is known whether the shadow ray from the last hit reaches its light; *seen is set to that. */
static inline bool estimate_recalls(const struct estimate *e, bool *seen)
{
    uint32_t last = e->met - 1;

    *seen = e->known && last < ESTIMATE_KNOWN && (e->known->lights_reached >> last & 1);
    return e->known && last < ESTIMATE_KNOWN && (e->known->shadows_known >> last & 1);
}

/* Adds the sample's first visible surface to e->guide, and sets e->guide to NULL; does nothing if it is NULL. If there
 * is no surface, `normal` is NULL, and `depth` is unused. */
void estimate_guide(struct estimate *e, const num_length albedo[3], const struct num_dir *normal, num_length depth);

/* Implements `enclosing`, see struct tia_estimator. */
uint32_t estimate_enclosing(const struct tia_view *view, uint32_t light);

/* Adds the square of a sample's luminance, which is at most 2^14, to *squares, which is in units of 2^-32; rgb is in
 * units of 2^-24. The sum saturates, so that it does not depend on the order of the samples. */
static inline void estimate_add_square(const int64_t rgb[3], uint64_t *squares)
{
    uint64_t luminance = (uint64_t)(rgb[0] + 2 * rgb[1] + rgb[2]) / 4;
    uint64_t added = luminance >> 32 ? (luminance >> 8) * (luminance >> 8) : luminance * luminance >> 16;

    *squares += added <= UINT64_MAX - *squares ? added : UINT64_MAX - *squares;
}

/* Adds a word to the hash, see tia_debug.path_hash. */
static inline void estimate_note(struct estimate *e, uint32_t word)
{
    for (int i = 0; i < 4; i++)
        e->hash = (e->hash ^ (word >> (8 * i) & 0xff)) * UINT32_C(16777619);
}

#endif
