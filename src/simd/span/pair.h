/* pair.h - a light and a sphere, with the spheres that may be between them: constants for all rows of a frame. */
#ifndef TIA_SIMD_SPAN_PAIR_H
#define TIA_SIMD_SPAN_PAIR_H

#include "render/span/span.h"
#include "render/span/span_light.h"
#include "render/span/span_shadow.h"
#include "run.h"

/* A caster's constants: those of run.h in double precision, and those from which bounds.c bounds the integer code's
 * errors. */
struct simd_caster {
    uint32_t sphere;
    struct num_vec sum;   /* C + Q */
    double aq, p0, size;  /* C.Q - B K; k's constant; |C| */
    double ua, uk;        /* the last bits of A.w and k */
    double fixed;         /* bound of the part of k that the bias adds */
    double radius, apart; /* R; |C - Q| */
    double through[3];
    bool clear;
};

struct simd_lamp {
    bool plain;              /* the runs of this sphere are left to plain C */
    struct num_vec light, g; /* Q, Q - L */
    double k, qq, size;      /* K, Q.Q, |Q| */
    double gap;              /* lower limit of ||G| - r|, the light's distance from the sphere */
    double per_r, swell;     /* 1/r; B = bias/r */
    double ud, up, us;       /* the last bits of |w|^2, |P|^2 and r N.w */
    double colour[3];
    int casts;
    struct simd_caster cast[SIMD_CASTS];
};

/* Returns the bytes for a view's pairs; SIZE_MAX when there are too many. */
size_t tia_simd_pairs_size(const struct tia_scene *scene, uint32_t light_capacity);

/* Fills view->simd_memory for the view's lights. */
void tia_simd_prepare(struct tia_view *view);

static inline const struct simd_lamp *simd_lamp_of(const struct tia_view *view, uint32_t sphere, uint32_t light)
{
    const struct simd_lamp *lamps = view->simd_memory;
    return &lamps[(size_t)sphere * view->light_capacity + light];
}

#endif
