/* span_error.h - bounds of the integers' errors on a run of pixels of one sphere, for comparing them with exact values:
 * binary logarithms in 256ths, in the scene's unit. span_proved.h derives them. */
#ifndef TIA_RENDER_SPAN_SPAN_ERROR_H
#define TIA_RENDER_SPAN_SPAN_ERROR_H

#include "span_shadow.h"

/* sqrt(D), S = b + sqrt(D) and t at a pixel, as the kernels compute them. From inside the root is a lower limit. */
struct span_depth {
    num_u root, sum, t;
};

struct span_error {
    int t;        /* relative error of t and P, as from inside relative to `point`; at least 0: no bound */
    int mantissa; /* largest mantissa of t */
    int point;    /* largest |P| */
    int reach;    /* error of |P|^2 as computed */
    int square;   /* error of |Q - P|^2, without the error of t */
    int facing;   /* error of r N.(Q - P) */
    int radius;   /* lower limit of r */
    int lambert;  /* error of the cosine, set by span_error_lambert; at least 0: no bound */
    int relative; /* relative error of |Q - P|^2, set by it */
};

/* Returns the depth where b and v.v have the mantissas `top` and `square`; from inside, `square` is the least of the
 * image. */
struct span_depth span_depth_of(const struct span_sphere *sphere, num_u top, num_u square, num_u t);

/* Sets the bounds of t and P on a run of pixels with the depths `ends` at both ends, where |v|, with the exponent of
 * pixel coordinates, is at most v_most. */
void span_error_points(const struct primary_rays *primary, const struct span_sphere *sphere,
                       const struct span_depth ends[2], num_wide v_most, struct span_error *error);

/* Returns the bound of the points' errors for span_coarse_point(), rounding included; 0 if it is unknown or too large.
 */
num span_error_coarse(const struct span_error *error);

/* Sets the bounds of a light there. */
void span_error_of(const struct light_source *source, const struct light_line *line, struct span_error *error);

/* Sets the bounds of lambert where |Q - P|^2, with the source's exponent, is at least `square`. */
void span_error_lambert(const struct light_source *source, num_wide square, struct span_error *error);

/* Returns the bound of r N.(Q - P) as the line has it. */
num_wide span_error_facing(const struct light_source *source, const struct light_line *line,
                           const struct span_error *error);

/* Sets the line's doubts; false if they are too large for the kernel. */
bool span_error_shadow(const struct light_source *source, const struct span_sphere *caster,
                       const struct span_error *error, struct shadow_line *line);

#endif
