/* steps.h - the pixels of a ball under one light as steps of one quantity.
 *
 * For one light at Q on a ball L, r, seen from outside, with G = Q - L, u = G.P and f = c - L.Q,
 *
 *     r N.w = f + u,   |w|^2 = p - 2 (f + u),   p = |G|^2 - r^2,   w = Q - P.
 *
 * So the cosine N.w/|w| grows with u, and a channel reaches a level where it is lambda, at
 *
 *     u = r lambda |w| - f,   |w| = p / (r lambda + sqrt(r^2 lambda^2 + p)).
 *
 * These u are the steps of the ball's colour; a table has them in ascending order. At a pixel P = t v, t = c/(b + S)
 * with b = L.v, S = sqrt(D) and D = b^2 - c v.v, so that u = c g/(b + S), g = G.v. As b + S is positive,
 *
 *     u >= c W   if and only if   g - W b >= W S,
 *
 * which compares A = g - W b, a linear function along a row, with W S by their squares: no root, no quotient, no t.
 * A pixel is decided in words of 32 bits; in doubt, in 64 bits; and then by span_shade.h. All bounds are derived in
 * steps_proved.h. */
#ifndef TIA_RENDER_SPAN_STEPS_STEPS_H
#define TIA_RENDER_SPAN_STEPS_STEPS_H

#include "render/span/span_light.h"

#include <tia/scene.h>

#define COLOUR_STEPS 125 /* 31 levels of red, 63 of green, 31 of blue */
#define STEPS_BLOCK 64   /* most pixels in a call of steps_draw */

/* The steps of a ball's colour under one light. */
struct colour_steps {
    bool usable;
    bool shaded; /* some sphere may block the light somewhere */
    uint8_t count;
    int8_t form_shift;        /* of G.v, for primary_form; its upper words have the exponent of A */
    int32_t root_most;        /* upper limit of S as a word */
    int32_t depth_doubt;      /* bound of the error of D's upper word */
    int32_t fine_doubt;       /* bound of the error of A and W S in a decision of 64 bits */
    int32_t margin;           /* bound of the error of A^2 - (W S)^2, upper words, in a decision of 32 bits */
    int32_t walk_doubt;       /* bound of the error of A and W S in steps_walk */
    int32_t walk_margin;      /* as `margin`, there */
    int32_t turn_doubt;       /* as fine_doubt, where it is decided whether u grows */
    int turn_shift;           /* 2^turn_shift is at most a quarter of the image's width; 0: that is too narrow */
    struct num_vec to_light;  /* G */
    int32_t at[COLOUR_STEPS]; /* W, with the exponent form_shift - b_shift + 32 */
    tia_rgb565 pixel[COLOUR_STEPS + 1]; /* the pixels below the first step and above each */
};

/* Returns one of several tables, by its number, from 1 on; NULL for 0. */
static inline struct colour_steps *steps_number(struct colour_steps *tables, unsigned number)
{
    return number ? &tables[number - 1] : NULL;
}

/* Sets the steps of a ball under a light at `light` from the eye, whose emission is `emission`. `usable` is false where
 * they have no proved bounds. */
void steps_prepare(const struct primary_rays *primary, const struct light_source *source,
                   const struct tia_rgb *emission, const struct tia_material *material, struct colour_steps *steps);

/* A row of pixels of a ball. u has at most one extremum in it: it changes in one direction up to pixel `turn_first`,
 * and in one from `turn_end` - 1 on. */
struct step_row {
    const struct colour_steps *steps;
    uint64_t d, d_step, d_twice;  /* D at the first pixel, its step, and that step's step, modulo 2^64 */
    int64_t b, b_step, g, g_step; /* accumulators of L.v and G.v at the first pixel */
    int at, count;                /* the pixel that is next, counted from the first; number of pixels */
    int index;                    /* number of steps at or below u */
    int way[2];                   /* 1 where u grows, -1 where it falls: before turn_first, and from turn_end on */
    int turn_first, turn_end;
    bool sure; /* u is certainly on this side of the step that it passed last */
    bool swap; /* pixels have the other byte order than the table's; set by the caller, read if TIA_SWAP */
};

/* Begins a row of `count` pixels, which all show the ball, from pixel (x, y) on. */
void steps_begin(const struct primary_rays *primary, const struct span_sphere *sphere, const struct colour_steps *steps,
                 int x, int y, int count, struct step_row *row);

/* Returns the row's pixel in the order in which it is written. */
static INLINED tia_rgb565 steps_shown(const struct step_row *row)
{
    return pixel_order(row->steps->pixel[row->index], TIA_SWAP && row->swap);
}

/* Draws the row's next pixels, up to STEPS_BLOCK, and returns the set of those in doubt. */
uint64_t steps_draw(struct step_row *row, tia_rgb565 *pixels);

#endif
