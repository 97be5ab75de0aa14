/* bounds.h - how far a run's values, as computed, may be from what the integer code computes. */
#ifndef TIA_LEVELS_BOUNDS_H
#define TIA_LEVELS_BOUNDS_H

#include "pair.h"
#include "row.h"

/* The kernels' float, and the double of exact.c: half an ulp, and the share of D below which a pixel is open. */
#define LEVEL_FLOAT 0x1p-24
#define LEVEL_FLOAT_CUT 0x1p-8
#define LEVEL_DOUBLE 0x1p-48 /* with room for its coefficients */
#define LEVEL_DOUBLE_CUT 0x1p-16

struct level_bounds {
    double distance; /* |w| at least */
    double square;   /* |w|^2, relative */
    double lambert;  /* absolute; LEVEL_NEVER when it cannot be bounded */
};

/* The sizes of the linear forms: |a0| + |a1| X. */
void tia_level_bound_light(const struct primary_rays *primary, const struct level_lamp *lamp,
                           const struct level_place *place, const struct level_depth *depth, double unit, double g_size,
                           double q_size, struct level_bounds *bounds);

/* Of one caster: A'.w and k, absolute; |w|^2 with what the comparison itself may add, relative. */
struct level_cast_bounds {
    double a, k, w;
};

void tia_level_bound_cast(const struct primary_rays *primary, const struct level_lamp *lamp,
                          const struct level_caster *cast, const struct level_place *place,
                          const struct level_depth *depth, const struct level_bounds *light, double unit, double h_size,
                          double c_size, struct level_cast_bounds *bounds);

#endif
