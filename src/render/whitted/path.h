/* path.h - what the rays of one pixel share. */
#ifndef TIA_RENDER_WHITTED_PATH_H
#define TIA_RENDER_WHITTED_PATH_H

#include "render/trace/trace.h"

#define PATH_BLOCKERS 8
#define PATH_REACHED 64

/* What light comes to a point. Number n is set in `bits` when some arrives, and then shares[n] 2^-15 of it, or all when
 * shares is NULL. */
struct arrivals {
    uint64_t bits;
    const uint16_t *shares;
};

/* First hits of pixels that are found without rays. */
struct first_hits {
    /* Along the ray of a sample of pixel (x, y). Sample i of light n has number first_bit[n] + i, or first_bit[n] if
     * `whole`. False: what arrives there is not known. */
    bool (*find)(const struct first_hits *hits, int x, int y, int sample, const struct ray *ray, struct hit *hit,
                 struct arrivals *lit);
    const uint8_t *first_bit;
    bool whole;
    /* NULL, or whether light that arrives by its number also passes what no number tells of, 0 <= t <= distance along
     * the shadow ray. `blocker` as of ray_transmittance. */
    bool (*passes)(const struct first_hits *hits, const struct ray *shadow, num_length distance, uint32_t *blocker);
};

/* Rays from the eye, one after the other. */
struct path {
    const struct ray_view *view;
    const struct first_hits *first; /* NULL: they are traced */
    bool traces;                    /* they are, and the hits with them */
    struct arrivals lit;            /* while `known` */
    bool known;
    uint32_t seed;         /* of a pixel's sample, for rays of ambient lights */
    unsigned class;        /* of the pixel, see light.h */
    uint64_t reached;      /* see tia_options.lit */
    unsigned next_reached; /* the next sample's number there; PATH_REACHED: it has none */
#ifdef TIA_WATCHED
    struct tia_observer *observer; /* NULL: none */
#endif
    bool hashed;
    uint32_t hash;                   /* of the path, see tia_options.path_hash */
    uint32_t blocker[PATH_BLOCKERS]; /* what last stood before each of the first lights */
    unsigned rays;                   /* since the caller was asked whether to stop */
    bool stopped;
};

#define PATH_PATIENCE 16 /* rays: the question may cost a look at a clock, or at a keyboard */

/* Counts a ray; true once the caller wants to stop: the colour does not matter any longer. */
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
