/* ray_tree.h - state shared by the rays of one pixel. */
#ifndef TIA_RENDER_WHITTED_RAY_TREE_H
#define TIA_RENDER_WHITTED_RAY_TREE_H

#include "render/trace/trace.h"

#define PATH_BLOCKERS 8
#define PATH_REACHED 64

/* The samples of lights that reach a point. Bit n of `bits` is set if light of sample n arrives. shares[n] is the part
 * that arrives, in units of 2^-15; if `shares` is NULL, all of it arrives. */
struct arrivals {
    uint64_t bits;
    const uint16_t *shares;
};

/* Primary hits that are found without rays. */
struct first_hits {
    /* Finds the hit of a sample's ray through pixel (x, y), and sets *lit to the light that arrives at the hit. Returns
     * false if the light is unknown. Sample i of light n has the number first_bit[n] + i in *lit, or first_bit[n] if
     * `whole`. */
    bool (*find)(const struct first_hits *hits, int x, int y, int sample, const struct ray *ray, struct hit *hit,
                 struct arrivals *lit);
    const uint8_t *first_bit;
    bool whole;
    /* True if light that arrives according to `lit` also passes the objects that `lit` ignores, at 0 <= t <= distance
     * along the shadow ray. `blocker` is as in ray_transmittance. `passes` is NULL if no objects are ignored. */
    bool (*passes)(const struct first_hits *hits, const struct ray *shadow, num_length distance, uint32_t *blocker);
};

/* The part of space that a ray stands for: `width` across at its origin, and as much more at each unit of length, see
 * footprint.h. */
struct cone {
    num_length width, spread;
};

/* The tree of rays of a sample, and the state shared by consecutive samples. */
struct path {
    const struct ray_view *view;
    const struct first_hits *first; /* NULL: primary rays are traced */
    bool traces;                    /* objects met by primary rays are stored in the hits */
    struct arrivals lit;            /* light of the primary hit; valid while `known` */
    bool known;
    /* Where textures are filtered: the pixel and the sample of a camera ray; `pixel` is NULL for other rays, which have
     * a cone. */
    const struct light_pixel *pixel;
    int sample;
    struct cone cone;
    uint32_t seed;         /* seed of a pixel's sample, for rays of ambient lights */
    unsigned class;        /* class of the pixel, see ray_light.h */
    uint64_t reached;      /* bits for tia_debug.lit */
    unsigned next_reached; /* number in `reached` of the next sample of a light; PATH_REACHED: none */
#ifdef TIA_WATCHED
    struct tia_observer *observer; /* NULL: none */
#endif
    bool hashed;
    uint32_t hash;                   /* hash of the path, see tia_debug.path_hash */
    uint32_t blocker[PATH_BLOCKERS]; /* last blocker of each light, by its number modulo PATH_BLOCKERS */
    unsigned rays;                   /* number of rays since the last call of `stop` */
    bool stopped;
};

#define PATH_PATIENCE 16 /* number of rays between two calls of `stop`, which may read a clock or a keyboard */

/* Counts a ray. Returns true once `stop` has returned true; the colour is then unused. */
static inline bool path_stops(struct path *path)
{
    if (!path->stopped && ++path->rays >= PATH_PATIENCE) {
        path->rays = 0;
        path->stopped = view_stops(path->view->view);
    }
    return path->stopped;
}

#define PATH_HASH UINT32_C(2166136261)

#endif
