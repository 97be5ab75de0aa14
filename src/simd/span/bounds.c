/* bounds.c - the bounds of lights and casters, derived in bounds/levels.h and bounds/shadows.h. u is the rounding unit
 * of the arithmetic; es and et are the relative bounds of 1/t from row.c. */
#include "bounds.h"

#include <math.h>

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static double reach_bound(const struct primary_rays *primary, const struct simd_lamp *lamp,
                          const struct simd_depth *depth)
{
    double d = (double)primary->depth, t = depth->t_most;

    return BOUND_OF(SPAN_REACH,
                    BOUND(SPAN_REACH_T) * depth->mantissa_most * lamp->up +
                        BOUND(SPAN_REACH_SQUARE) * t * t * simd_power(32 - primary->square_shift) / (d * d));
}

/* Returns the bound of the kernels' error in a s^2 + h s + v.v, divided by s^2; `h_size` is the size of h. */
static double quadratic_bound(double a, double h_size, const struct simd_place *place, const struct simd_depth *depth,
                              double u)
{
    double es = depth->es, t = depth->t_most, second = 1 + BOUND(SPAN_FORM_SECOND);

    return BOUND_OF(SPAN_FORM, fabs(a) * (2 * es + BOUND(SPAN_TERM) * u) + h_size * t * (es + BOUND(SPAN_TERM) * u) +
                                   place->square_most * t * t * BOUND(SPAN_TERM) * u) *
           second;
}

/* Returns a lower limit of |w| for all P of the run. */
static double distance_least(const struct simd_lamp *lamp, const struct simd_depth *depth)
{
    double far = larger(depth->p_least - lamp->size, lamp->size - depth->p_most);

    return larger(lamp->gap, far) * (1 - BOUND(SPAN_DISTANCE));
}

void tia_simd_bound_light(const struct primary_rays *primary, const struct simd_lamp *lamp,
                          const struct simd_place *place, const struct simd_depth *depth, double unit, double g_size,
                          double q_size, struct simd_bounds *bounds)
{
    double d = distance_least(lamp, depth), t = depth->t_most, p = depth->p_most;
    double es = depth->es, et = depth->et, u = unit, mantissa = depth->mantissa_most;
    double moved = 1 + BOUND(SPAN_MOVED);

    bounds->distance = d;
    bounds->lambert = SIMD_NEVER;
    if (!(d > 0))
        return;
    double computed = quadratic_bound(lamp->qq, q_size, place, depth, u);
    double units = BOUND(SPAN_SQUARE_UNITS) + BOUND(SPAN_SQUARE_T) * mantissa;
    double integer = 2 * moved * (lamp->size * p + p * p) * et + units * lamp->ud + reach_bound(primary, lamp, depth);
    bounds->square = BOUND_OF(SPAN_SQUARE, (computed + integer) / (d * d));
    double facing =
        BOUND_OF(SPAN_FACING_OFF, fabs(lamp->k) * ((1 + BOUND(SPAN_FACING_SECOND)) * es + BOUND(SPAN_FACING) * u) +
                                      BOUND(SPAN_TURN) * u * g_size * t + moved * g_size * t * et +
                                      (BOUND(SPAN_FACING_UNITS) + BOUND(SPAN_FACING_T) * mantissa) * lamp->us);
    if (bounds->square < BOUND(SPAN_SQUARE_KNOWN))
        bounds->lambert = BOUND_OF(SPAN_COSINE, (1 + BOUND(SPAN_COSINE_FACING)) * facing * lamp->per_r / d +
                                                    BOUND(SPAN_COSINE_SQUARE) * bounds->square +
                                                    BOUND(SPAN_LAMBERT) * u + BOUND(SPAN_COSINE_UNITS));
}

void tia_simd_bound_cast(const struct primary_rays *primary, const struct simd_lamp *lamp,
                         const struct simd_caster *cast, const struct simd_place *place, const struct simd_depth *depth,
                         const struct simd_bounds *light, double unit, double h_size, double c_size,
                         struct simd_cast_bounds *bounds)
{
    double p = depth->p_most, q = lamp->size, c = cast->size, reach = reach_bound(primary, lamp, depth);
    double et = depth->et, u = unit, mantissa = depth->mantissa_most, moved = 1 + BOUND(SPAN_MOVED);
    double toward = BOUND(SPAN_TOWARD_UNITS) + BOUND(SPAN_TOWARD_T) * mantissa;
    double power = BOUND(SPAN_POWER_UNITS) + BOUND(SPAN_POWER_T) * mantissa;

    bounds->a = quadratic_bound(cast->aq, h_size, place, depth, u);
    bounds->k = quadratic_bound(cast->p0, c_size, place, depth, u);
    bounds->a = BOUND_OF(SPAN_TOWARD, bounds->a + moved * ((c + q) * p + 2 * p * p) * et + toward * cast->ua + reach);
    bounds->a += BOUND_OF(SPAN_TOWARD_BIAS,
                          SIMD_BIAS * (q + p) *
                              ((1 + BOUND(SPAN_TOWARD_BIAS_SECOND)) * light->lambert + BOUND(SPAN_TOWARD_BIAS_UNITS)));
    bounds->k =
        BOUND_OF(SPAN_POWER, bounds->k + moved * (2 * c * p + 2 * p * p) * et + power * cast->uk + reach + cast->fixed);
    bounds->w = BOUND_OF(SPAN_COVERED,
                         light->square + BOUND(SPAN_COVERED_CUT) + BOUND(SPAN_DELTA) * u +
                             BOUND_OF(SPAN_COVERED_UNITS, (lamp->ud + cast->ua) / (light->distance * light->distance)));
}

double tia_simd_bound_level(double levels, double off, double unit)
{
    double rounded = levels * off + levels * BOUND(SPAN_LEVEL_ROUNDING) * unit;

    return .5 - BOUND_OF(SPAN_LEVELS, rounded * (1 + BOUND(SPAN_LEVEL_SECOND))) - BOUND(SPAN_LEVEL_NEAR) * unit;
}
