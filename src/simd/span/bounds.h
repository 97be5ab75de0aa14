/* bounds.h - bounds on the distance of a run's computed values from those of the integer code. */
#ifndef TIA_SIMD_SPAN_BOUNDS_H
#define TIA_SIMD_SPAN_BOUNDS_H

#include "bound_table.h"
#include "pair.h"
#include "row.h"

/* Units of the kernels' floats and of the doubles of exact.c, and the shares of D's size below which a pixel is
 * undecided. */
#define SIMD_FLOAT BOUND(SPAN_FLOAT_UNIT)
#define SIMD_FLOAT_CUT BOUND(SPAN_FLOAT_CUT)
#define SIMD_DOUBLE BOUND(SPAN_DOUBLE_UNIT)
#define SIMD_DOUBLE_CUT BOUND(SPAN_DOUBLE_CUT)

struct simd_bounds {
    double distance; /* lower limit of |w| */
    double square;   /* relative bound of |w|^2 */
    double lambert;  /* absolute bound of the cosine; SIMD_NEVER if it cannot be bounded */
};

/* Bounds a light's |w|^2 and cosine. `g_size` and `q_size` are the sizes |a0| + |a1| X of the linear forms G.v and -2
 * Q.v. */
void tia_simd_bound_light(const struct primary_rays *primary, const struct simd_lamp *lamp,
                          const struct simd_place *place, const struct simd_depth *depth, double unit, double g_size,
                          double q_size, struct simd_bounds *bounds);

/* Returns the largest distance from a level, in levels, at which a channel of 0..levels certainly rounds to it: a half
 * less the channel's error `off`, where 1 is white, and roundings of `unit`. */
double tia_simd_bound_level(double levels, double off, double unit);

/* Bounds of a caster: of A'.w and k, absolute; of |w|^2 together with the comparison's own error, relative. */
struct simd_cast_bounds {
    double a, k, w;
};

void tia_simd_bound_cast(const struct primary_rays *primary, const struct simd_lamp *lamp,
                         const struct simd_caster *cast, const struct simd_place *place, const struct simd_depth *depth,
                         const struct simd_bounds *light, double unit, double h_size, double c_size,
                         struct simd_cast_bounds *bounds);

#endif
