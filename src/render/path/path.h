/* path.h - the path integrator's prepared data, for the SIMD kernels that replace it. */
#ifndef TIA_RENDER_PATH_PATH_H
#define TIA_RENDER_PATH_PATH_H

#include "emitters.h"
#include "render/estimate/estimate.h"

/* Prepared data, stored behind the struct ray_view. */
struct path_view {
    struct emitters emitters;
};

const struct path_view *path_view_of(const struct tia_view *view);

/* Implements estimate_radiance. */
void path_radiance(struct estimate *e, const struct ray *first, num_length rgb[3]);

/* First bounce after which paths may end by roulette; bounces count from 0. */
#define PATH_ROULETTE 3

/* Sets of kinds of lights, with a bit for each kind. The first two macros are their terms. */
#define PATH_SURFACE(KIND, name, what, traits)                                                                         \
    | (TIA_LIGHT_AREA & (traits) && TIA_LIGHT_PATHS & (traits) ? 1u << KIND : 0)
#define PATH_SEEN_KIND(KIND, name, what, traits) | (TIA_LIGHT_SURFACE & (traits) ? 1u << KIND : 0)
#define PATH_SURFACES (0 TIA_LIGHTS(PATH_SURFACE)) /* surfaces that paths meet */
#define PATH_SEEN (0 TIA_LIGHTS(PATH_SEEN_KIND))   /* visible to the eye or in mirrors */

/* The two quads of random numbers of a bounce. Quad 0: a point of a light, and a direction, except for the first
 * bounce, whose direction is in ESTIMATE_FIRST_QUAD. Quad 1: the choices, see enum path_choice. */
#define PATH_QUAD(bounce, which) (ESTIMATE_FIRST_QUAD + 1 + 2 * (bounce) + (which))

/* The choices at a bounce: of a lobe, of a light, roulette, reflection by glass. Each has this dimension of quad 1. */
enum path_choice { CHOICE_LOBE, CHOICE_LIGHT, CHOICE_SURVIVAL, CHOICE_REFLECTION };

#endif
