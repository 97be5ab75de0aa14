/* bound_cache.h - a run's bounds, reused for runs of the next rows. */
#ifndef TIA_SIMD_SPAN_BOUND_CACHE_H
#define TIA_SIMD_SPAN_BOUND_CACHE_H

#include "prepare.h"

/* The bounds of a run with more limits than this are not cached. A limit is a value that bounds depend on, negated
 * where a smaller value is worse. */
#define SIMD_LIMITS 16

struct simd_bound_cache {
    bool known;
    uint32_t sphere;
    int limits;
    double limit[SIMD_LIMITS];
    struct simd_depth depth;
    double near31, near63;
    struct simd_bounds light[SIMD_LIGHTS];
    struct simd_cast_bounds cast[SIMD_LIMITS / 2];
};

/* Gives the bounds for floats; false when they are too large. `cache` may be NULL. It gives the bounds of an earlier
 * run if none of that run's widened limits is smaller. */
bool tia_simd_fine_bounds(struct simd_fine *fine, struct simd_bound_cache *cache);

/* The same in parts, for lights that are added one by one, without a cache: the depth; the lights of `fine`, whose
 * colours' errors are added to `off`; the levels for these errors. Each returns false when bounds are too large. */
bool tia_simd_fine_depth(struct simd_fine *fine);
bool tia_simd_fine_lights(struct simd_fine *fine, double off[3]);
bool tia_simd_fine_levels(struct simd_fine *fine, const double off[3]);

/* Number of caches: one for each half of the picture, for four spheres. */
#define SIMD_CACHES 8

static inline struct simd_bound_cache *simd_cache_of(struct simd_bound_cache *caches, const struct simd_fine *fine)
{
    unsigned right = fine->place.middle > fine->view->width / 2;

    return &caches[(2 * fine->sphere + right) % SIMD_CACHES];
}

#endif
