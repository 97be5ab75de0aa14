/* num_estimate.h - arithmetic of the sampling integrators, on top of num_ray.h.
 *
 *   num_ray_bias(bias)           rays' offset from a surface: 2^-26, or the scene's `bias` if the arithmetic needs it
 *   num_q24(x)                   x in 0..2^14, rounded to nearest, ties up, in units of 2^-24
 *   num_chance(p)                a probability as a 32-bit chance: a random 32-bit number is below it with the
 *                                probability p; UINT32_MAX: always
 *   num_of_chance(c)             the probability that a chance stands for
 *
 * Densities have no fixed range. A struct num_density is a number >= 0, in the integer builds a mantissa with an
 * exponent of its own; an operation has a relative error below 2^-58.
 *
 *   num_density_of(x)            a length as a density
 *   num_density_of_unit(d)       a fraction as a density
 *   num_density_product, num_density_quotient, num_density_sum
 *   num_density_over(x, p)       x/p as a length, 0 if p is 0
 *   num_density_share(p, q)      p/(p + q), 0 if both are 0
 */
#ifndef TIA_NUM_NUM_ESTIMATE_H
#define TIA_NUM_NUM_ESTIMATE_H

#include "num_ray.h"

#if defined TIA_NUM_F64 || defined TIA_NUM_F32 || defined TIA_NUM_F128
#include "num_estimate_real.h"
#else
#include "num_estimate_q16.h"
#endif

/* True if an event with this chance happens, for a random 32-bit number. */
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
