/* num_estimate.h - arithmetic of the sampling integrators, on top of num_ray.h.
 *
 *   num_ray_bias(scene's bias)   their rays' offset from a surface: 2^-26, or as much as the arithmetic needs
 *   num_q24(x)                   x in 0..2^14, rounded to nearest, ties up, in units of 2^-24
 *   num_chance(p)                a probability as a chance: a random 32-bit number is below the chance with that
 * probability. UINT32_MAX: sure num_of_chance(c)             the probability that a chance stands for
 *
 * Densities have no range: a struct num_density is a number from 0 up, block floating point in integers, with a
 * relative error below 2^-58 an operation.
 *
 *   num_density_of(x)            of a length; num_density_of_unit(d) of a part
 *   num_density_product, num_density_quotient, num_density_sum
 *   num_density_over(x, p)       x/p as a length, 0 where p is 0
 *   num_density_share(p, q)      p/(p + q), 0 where both are
 * */
#ifndef TIA_NUM_NUM_ESTIMATE_H
#define TIA_NUM_NUM_ESTIMATE_H

#include "num_ray.h"

#if defined TIA_NUM_F64 || defined TIA_NUM_F32
#include "num_estimate_real.h"
#else
#include "num_estimate_q16.h"
#endif

static inline bool num_happens(uint32_t chance, uint32_t number)
{
    return number < chance || chance == UINT32_MAX;
}

/* Returns (u + 1/2)/2^32. */
static inline num_unit num_unit_of_u32(uint32_t u)
{
    return num_unit_of_q62(((int64_t)u << 30) + (INT64_C(1) << 29));
}

#endif
