/* bounds.h - bounds on the distance of a run's computed values from those of the integer code. */
#ifndef TIA_SIMD_SPAN_BOUNDS_H
#define TIA_SIMD_SPAN_BOUNDS_H

#include "bound_table.h"
#include "pair.h"
#include "row.h"

/* The units of the kernels' floats and of exact.c's doubles; the shares of D below which a pixel is undecided. */
#define SIMD_FLOAT BOUND(SPAN_FLOAT_UNIT)
#define SIMD_FLOAT_CUT BOUND(SPAN_FLOAT_CUT)
#define SIMD_DOUBLE BOUND(SPAN_DOUBLE_UNIT)
#define SIMD_DOUBLE_CUT BOUND(SPAN_DOUBLE_CUT)

struct simd_bounds {
    double distance; /* |w| at least */
    double square;   /* |w|^2, relative */
    double lambert;  /* absolute; SIMD_NEVER when it cannot be bounded */
};

/* The sizes of the linear forms: |a0| + |a1| X. */
void tia_simd_bound_light(const struct primary_rays *primary, const struct simd_lamp *lamp,
                          const struct simd_place *place, const struct simd_depth *depth, double unit, double g_size,
                          double q_size, struct simd_bounds *bounds);

/* Bounds of one caster: A'.w and k, absolute; |w|^2 with the comparison's own error, relative. */
struct simd_cast_bounds {
    double a, k, w;
};

void tia_simd_bound_cast(const struct primary_rays *primary, const struct simd_lamp *lamp,
                         const struct simd_caster *cast, const struct simd_place *place, const struct simd_depth *depth,
                         const struct simd_bounds *light, double unit, double h_size, double c_size,
                         struct simd_cast_bounds *bounds);

#endif
