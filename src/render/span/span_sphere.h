/* span_sphere.h - a sphere seen from the eye: its pixels and their distances.
 *
 * For the direction v, with b = L.v and c = L.L - r^2, the roots of |t v - L|^2 = r^2 are
 *
 *     t = (b -+ sqrt(b^2 - c v.v)) / v.v.
 *
 * Seen from outside the nearer root is c / (b + sqrt(b^2 - c v.v)), where nothing cancels; from
 * inside it is the farther one, (b + sqrt(b^2 - c v.v)) / v.v.
 */
#ifndef TIA_RENDER_SPAN_SPAN_SPHERE_H
#define TIA_RENDER_SPAN_SPAN_SPHERE_H

#include "cone_row.h"
#include "kernels.h"
#include "primary.h"

/* A sphere of the scene, or of a visible light. */
struct span_sphere {
    struct num_vec centre; /* L */
    num_wide c;            /* L.L - r^2, exponent 32: negative when the eye is inside */
    num_wide radius;       /* exponent 16 */
    num_u inverse;         /* num_inverse(radius) */
    int radius_bits;       /* num_bits(radius) */

    /* The exponents and constants of the kernels that compute t, see span_sphere.c. */
    int b_shift;         /* L.v * 2^b_shift fills an accumulator */
    num_u c_disc, c_top; /* c for the discriminant and for the quotient */
    int t_shift;         /* num_quotient's shift */
    int t_exponent;      /* exponent of t */
    struct span rows;    /* rows that may show the sphere; empty: no pixel does */
    bool wide;           /* hits do not store its distances, see coherence.h */
};

/* Prepares a sphere; one of radius 0 has no pixels. */
void span_sphere_prepare(const struct primary_rays *primary, struct span_sphere *sphere, struct num_vec centre,
                         tia_q16 radius);

/* Returns the pixels of row y that show the sphere; `guess` affects only the speed. */
struct span span_sphere_row(const struct primary_rays *primary, const struct span_sphere *sphere, int y,
                            struct span guess);

/* Gives all of `line` except count, for the pixels from (x, y) on. */
void span_sphere_line(const struct primary_rays *primary, const struct span_sphere *sphere, int y, int x,
                      struct sphere_line *line);

#endif
