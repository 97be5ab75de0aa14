/* bounds.h - bounds on the differences between a run's computed values and the exact ones. */
#ifndef TIA_SIMD_SPAN_BOUNDS_H
#define TIA_SIMD_SPAN_BOUNDS_H

#include "bound_table.h"
#include "pair.h"
#include "row.h"

/* SIMD_FLOAT is the rounding unit u of the kernels' floats. A pixel is undecided where D is below SIMD_FLOAT_CUT of D's
 * size. */
#define SIMD_FLOAT BOUND(SPAN_FLOAT_UNIT)
#define SIMD_FLOAT_CUT BOUND(SPAN_FLOAT_CUT)

struct simd_bounds {
    double distance; /* lower limit of |w| */
    double square;   /* bound of the relative error of |w|^2 */
    double lambert;  /* bound of the absolute error of the cosine; SIMD_NEVER: none is known */
};

/* Bounds the errors of a light's |w|^2 and cosine. `g_size` and `q_size` are the sizes |a0| + |a1| X of the linear
 * forms G.v and -2 Q.v. */
void tia_simd_bound_light(const struct simd_lamp *lamp, const struct simd_place *place, const struct simd_depth *depth,
                          double unit, double g_size, double q_size, struct simd_bounds *bounds);

/* Returns the largest distance from a level at which a channel certainly rounds to this level: 1/2, less the channel's
 * error and the roundings. The result is in levels; the channel has the values 0..levels, and an error of `off` times
 * white. */
double tia_simd_bound_level(double levels, double off, double unit);

/* Bounds of errors for a caster: a and k bound the absolute errors of A'.w and k; w bounds the relative error of |w|^2,
 * including that of the comparison. */
struct simd_cast_bounds {
    double a, k, w;
};

void tia_simd_bound_cast(const struct simd_lamp *lamp, const struct simd_caster *cast, const struct simd_place *place,
                         const struct simd_depth *depth, const struct simd_bounds *light, double unit, double h_size,
                         double c_size, struct simd_cast_bounds *bounds);

#endif
