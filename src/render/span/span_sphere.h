/* span_sphere.h - a sphere seen from the eye: its pixels and their distances.
 *
 * For the direction v, with b = L.v and c = L.L - r^2, the roots of |t v - L|^2 = r^2 are
 *
 *     t = (b -+ sqrt(b^2 - c v.v)) / v.v.
 *
 * Seen from outside the nearer root is c / (b + sqrt(b^2 - c v.v)), where nothing cancels; from inside it is the
 * farther one, (b + sqrt(b^2 - c v.v)) / v.v, or |c| / (|b| + sqrt(b^2 - c v.v)) where b < 0.
 */
#ifndef TIA_RENDER_SPAN_SPAN_SPHERE_H
#define TIA_RENDER_SPAN_SPAN_SPHERE_H

#include "cone_row.h"
#include "kernels.h"
#include "primary.h"
#include "span_shift.h"

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
    int behind_shift;    /* from inside, where b < 0 */
    int t_exponent;      /* exponent of t */
    num_wide cone_doubt; /* of b^2 - c v.v, for num_cone() */
    int depth_bits;      /* K is off by less than 2^-depth_bits of itself */
    int turn;            /* K r in last bits of b is below 2^(turn + depth_bits) */
    int doubt_shift;     /* of t, for num_distance_doubt() */
    num_u doubt;
    num_u accurate;   /* t from SPAN_SHORT to here is accurate to 2^-7.2 */
    struct span rows; /* rows that may show the sphere; empty: no pixel does */
    uint8_t steps;    /* 1 + number of the table of its colour's steps: then hits do not store its distances; or 0 */
};

#define SPAN_SHORT 1024

/* True if the distance t is accurate to 2^-7. */
static inline bool span_is_accurate(const struct span_sphere *sphere, num_u t)
{
    return t >= SPAN_SHORT && t <= sphere->accurate;
}

/* Prepares a sphere; one of radius 0 has no pixels. */
void span_sphere_prepare(const struct primary_rays *primary, struct span_sphere *sphere, struct num_vec centre,
                         tia_q16 radius);

/* Gives all of `line` except count, for the pixels from (x, y) on. */
void span_sphere_line(const struct primary_rays *primary, const struct span_sphere *sphere, int y, int x,
                      struct sphere_line *line);

#endif
