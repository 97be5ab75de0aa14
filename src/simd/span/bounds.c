/* bounds.c - the bounds, derived. u is the arithmetic's unit, es and et the relative bounds of 1/t from row.c.
 *
 * Arithmetic here. A quadratic in s, a s^2 + h s + v.v with h linear, is off by
 *
 *     |a| s^2 (2 es + 8 u) + |h| s (es + 8 u) + 8 u v.v
 *
 * and 1.01 makes up for es^2, es being below .01. The numbers of u are those of proved.h.
 *
 * The integer code, see render/span/kernels.h. T is the mantissa of t. A factor's upper half is off by .51 of its last
 * bit, so a product t (a.v) by .51 T last bits; a constant or a shift by half a bit; |P|^2 by
 *
 *     reach = .52 T up + .51 t^2 (last bit of v.v).
 *
 * t's own error et moves each form by its derivative: t d/dt of |w|^2 is at most 2 (|Q| |P| + |P|^2), and so on; 1.02
 * makes up for the second order. */
#include "bounds.h"

#include <math.h>

#include "proved.h"

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static double reach_bound(const struct primary_rays *primary, const struct simd_lamp *lamp,
                          const struct simd_depth *depth)
{
    double d = (double)primary->depth, t = depth->t_most;

    return .52 * depth->mantissa_most * lamp->up + .51 * t * t * simd_power(32 - primary->square_shift) / (d * d);
}

/* Returns the bound of a s^2 + h s + v.v divided by s^2. */
static double quadratic_bound(double a, double h_size, const struct simd_place *place, const struct simd_depth *depth,
                              double u)
{
    double es = depth->es, t = depth->t_most;

    return fabs(a) * (2 * es + SIMD_TERM * u) + h_size * t * (es + SIMD_TERM * u) +
           place->square_most * t * t * SIMD_TERM * u;
}

/* |w| >= ||G| - r|, and >= |P| - |Q| and |Q| - |P| for every P of the run.
 *
 * lambert = r N.w/(r |w|): the errors of r N.w divided by r |w|, half of |w|^2's relative one and its second order, .53
 * together while that is below .04. SIMD_LAMBERT is for 1/sqrt and the products; 2^-26 for the
 * integer code's shift of r N.w (2^-30), tia_rsqrt (2^-30), num_mul_top (2^-30), num_lambert (2^-31) and 1/r (2^-31):
 * they add up to 2^-27.9. */
void tia_simd_bound_light(const struct primary_rays *primary, const struct simd_lamp *lamp,
                          const struct simd_place *place, const struct simd_depth *depth, double unit, double g_size,
                          double q_size, struct simd_bounds *bounds)
{
    double far = larger(depth->p_least - lamp->size, lamp->size - depth->p_most);
    double d = larger(lamp->gap, far) * (1 - 0x1p-30), t = depth->t_most, p = depth->p_most;
    double es = depth->es, et = depth->et, u = unit, mantissa = depth->mantissa_most;

    bounds->distance = d;
    bounds->lambert = SIMD_NEVER;
    if (!(d > 0))
        return;
    double computed = quadratic_bound(lamp->qq, q_size, place, depth, u);
    double integer =
        2.04 * (lamp->size * p + p * p) * et + (1 + 1.02 * mantissa) * lamp->ud + reach_bound(primary, lamp, depth);
    bounds->square = (computed * 1.01 + integer) / (d * d);
    double facing = fabs(lamp->k) * (1.01 * es + SIMD_FACING * u) + SIMD_TURN * u * g_size * t +
                    1.02 * g_size * t * et + (.5 + .51 * mantissa) * lamp->us;
    if (bounds->square < .04)
        bounds->lambert = 1.01 * facing * lamp->per_r / d + .53 * bounds->square + SIMD_LAMBERT * u + 0x1p-26;
}

/* A'.w = A.w - bias N.w: the latter is bias |w| lambert, |w| <= |Q| + |P|, rounded by half a bit of ua.
 *
 * The comparison: num_covers cuts its factors to 31 bits, 2^-29 on each side; the squares and products here are good
 * for SIMD_DELTA u; and |w|^2 <= A'.w is decided by numbers shifted to the coarser of the last bits ud and ua. */
void tia_simd_bound_cast(const struct primary_rays *primary, const struct simd_lamp *lamp,
                         const struct simd_caster *cast, const struct simd_place *place, const struct simd_depth *depth,
                         const struct simd_bounds *light, double unit, double h_size, double c_size,
                         struct simd_cast_bounds *bounds)
{
    double p = depth->p_most, q = lamp->size, c = cast->size, reach = reach_bound(primary, lamp, depth);
    double et = depth->et, u = unit, mantissa = depth->mantissa_most;

    bounds->a = quadratic_bound(cast->aq, h_size, place, depth, u);
    bounds->k = quadratic_bound(cast->p0, c_size, place, depth, u);
    bounds->a = 1.01 * bounds->a + 1.02 * ((c + q) * p + 2 * p * p) * et + (2.5 + .52 * mantissa) * cast->ua + reach;
    bounds->a += 0x1p-13 * (q + p) * (1.05 * light->lambert + 0x1p-27);
    bounds->k = 1.01 * bounds->k + 1.02 * (2 * c * p + 2 * p * p) * et + (2.5 + 1.04 * mantissa) * cast->uk + reach +
                cast->fixed;
    bounds->w = light->square + 0x1p-26 + SIMD_DELTA * u + (lamp->ud + cast->ua) / (light->distance * light->distance);
}
