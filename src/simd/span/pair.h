/* pair.h - a light and a sphere, with the spheres that may be between them: constants for all rows of a frame. */
#ifndef TIA_SIMD_SPAN_PAIR_H
#define TIA_SIMD_SPAN_PAIR_H

#include "render/span/span.h"
#include "run.h"

/* A caster's constants: those of run.h in double precision. */
struct simd_caster {
    double aq, p0, size;  /* C.Q - B K; k's constant; |C| */
    double fixed;         /* bound of the error of k's constant */
    double radius, apart; /* R; |C - Q| */
    uint8_t sphere;
    bool clear, encloses; /* it transmits some light; the light is in it or on it */
};

/* A light's constants for one sphere. */
struct simd_lamp {
    bool plain;              /* there are more casters than are kept; see crowd.h */
    struct num_vec light, g; /* Q, Q - L */
    double k, qq, size;      /* K, Q.Q, |Q| */
    double reach, gap;       /* |G|; lower limit of ||G| - r|, the light's distance from the sphere */
    double per_r, swell;     /* 1/r; B = bias/r */
    double share;            /* bias/(r + bias) */
    double colour[3];        /* the product of both colours and of the shades' transmissions */
    int casts, shades;       /* shades: spheres around the light that block it at all points */
    struct simd_caster *cast;
};

/* Returns the bytes for a view's pairs; SIZE_MAX when there are too many. */
size_t tia_simd_pairs_size(const struct tia_scene *scene, uint32_t light_capacity);

/* Fills view->simd_memory for the view's lights. */
void tia_simd_prepare(struct tia_view *view);

/* Gives sphere j's constants as a caster for a lamp of sphere n. */
void tia_simd_caster(const struct tia_view *view, uint32_t n, uint32_t j, const struct simd_lamp *lamp,
                     struct simd_caster *cast);

/* True if sphere j is a shade of a lamp of sphere n. */
bool tia_simd_is_shade(const struct tia_view *view, uint32_t n, uint32_t j, const struct simd_lamp *lamp);

/* True if the light is in the caster or on it. */
bool tia_simd_encloses(const struct span_sphere *caster, struct num_vec light);

/* Converts a colour. */
static inline void simd_channels(const struct tia_rgb *colour, double out[3])
{
    out[0] = (double)colour->r * 0x1p-30;
    out[1] = (double)colour->g * 0x1p-30;
    out[2] = (double)colour->b * 0x1p-30;
}

/* True if all channels are 0. Products too small for doubles are 0 as well; their light changes no pixel. */
static inline bool simd_is_black(const double colour[3])
{
    return colour[0] == 0 && colour[1] == 0 && colour[2] == 0;
}

static inline const struct simd_lamp *simd_lamp_of(const struct tia_view *view, uint32_t sphere, uint32_t light)
{
    const struct simd_lamp *lamps = view->simd_memory;
    return &lamps[(size_t)sphere * view->light_capacity + light];
}

#endif
