/* bounds.c - the bounds of lights and casters, derived in bounds/levels.h and bounds/shadows.h. u is the rounding unit
 * of the arithmetic; es and et are the relative bounds of 1/t and of P from row.c. */
#include "bounds.h"

#include <math.h>

static double larger(double a, double b)
{
    return a > b ? a : b;
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

void tia_simd_bound_light(const struct simd_lamp *lamp, const struct simd_place *place, const struct simd_depth *depth,
                          double unit, double g_size, double q_size, struct simd_bounds *bounds)
{
    double d = distance_least(lamp, depth), t = depth->t_most, p = depth->p_most;
    double es = depth->es, et = depth->et, u = unit, moved = 1 + BOUND(SPAN_MOVED);

    bounds->distance = d;
    bounds->lambert = SIMD_NEVER;
    if (!(d > 0))
        return;
    double computed = quadratic_bound(lamp->qq, q_size, place, depth, u);
    bounds->square = BOUND_OF(SPAN_SQUARE, (computed + 2 * moved * (lamp->size * p + p * p) * et) / (d * d));
    double facing =
        BOUND_OF(SPAN_FACING_OFF, fabs(lamp->k) * ((1 + BOUND(SPAN_FACING_SECOND)) * es + BOUND(SPAN_FACING) * u) +
                                      BOUND(SPAN_TURN) * u * g_size * t + moved * lamp->reach * p * et);
    if (bounds->square < BOUND(SPAN_SQUARE_KNOWN))
        bounds->lambert =
            BOUND_OF(SPAN_COSINE, (1 + BOUND(SPAN_COSINE_FACING)) * facing * lamp->per_r / d +
                                      BOUND(SPAN_COSINE_SQUARE) * bounds->square + BOUND(SPAN_LAMBERT) * u);
}

void tia_simd_bound_cast(const struct simd_lamp *lamp, const struct simd_caster *cast, const struct simd_place *place,
                         const struct simd_depth *depth, const struct simd_bounds *light, double unit, double h_size,
                         double c_size, struct simd_cast_bounds *bounds)
{
    double p = depth->p_most, q = lamp->size, c = cast->size, et = depth->et, u = unit, moved = 1 + BOUND(SPAN_MOVED);
    double bias = SIMD_BIAS * (q + p) * (1 + BOUND(SPAN_TOWARD_BIAS_SECOND)) * light->lambert;
    double parts = c * q + (c + q) * p + lamp->swell * (fabs(lamp->k) + lamp->reach * p);

    bounds->a = quadratic_bound(cast->aq, h_size, place, depth, u);
    bounds->k = quadratic_bound(cast->p0, c_size, place, depth, u);
    bounds->a = BOUND_OF(SPAN_TOWARD, bounds->a + moved * ((c + q) * p + 2 * p * p) * et + BOUND(SPAN_PARTS) * parts);
    bounds->a += BOUND_OF(SPAN_TOWARD_BIAS, bias);
    bounds->k = BOUND_OF(SPAN_POWER, bounds->k + moved * (2 * c * p + 2 * p * p) * et + cast->fixed);
    bounds->w = BOUND_OF(SPAN_COVERED, light->square + BOUND(SPAN_DELTA) * u);
}

double tia_simd_bound_level(double levels, double off, double unit)
{
    double rounded = levels * off + levels * BOUND(SPAN_LEVEL_ROUNDING) * unit;

    return .5 - BOUND_OF(SPAN_LEVELS, rounded * (1 + BOUND(SPAN_LEVEL_SECOND))) - BOUND(SPAN_LEVEL_NEAR) * unit;
}
