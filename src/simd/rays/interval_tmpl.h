/* interval_tmpl.h - interval arithmetic: numbers with error bounds, for steps whose derivation by hand would be long.
 *
 * Parameters: the doubles of isa/isa.h. Defines: struct ve, ve_of(), ve_set(), ve_neg(), ve_add(), ve_sub(), ve_mul(),
 * ve_div(), ve_sqrt(), ve_less(), ve_sel().
 *
 * Each operation adds the roundings of both codes, by doubles and in fixed point. These bounds are safe by
 * construction, but looser than derived ones. */
#ifndef TIA_SIMD_RAYS_INTERVAL_TMPL_H
#define TIA_SIMD_RAYS_INTERVAL_TMPL_H

#include "vector_tmpl.h"

struct ve {
    vd v, e;
};

LANE_OP struct ve ve_of(vd v, vd e)
{
    return (struct ve){v, e};
}

LANE_OP struct ve ve_set(double v)
{
    return (struct ve){vset(v), vset(__builtin_fabs(v) * BOUND(GIVEN))};
}

LANE_OP struct ve ve_neg(struct ve a)
{
    return (struct ve){-a.v, a.e};
}

LANE_OP struct ve ve_add(struct ve a, struct ve b)
{
    vd v = a.v + b.v;

    return (struct ve){v, BOUND_OF(INTERVAL_SUM, a.e + b.e) + vabs(v) * BOUND(SUM)};
}

LANE_OP struct ve ve_sub(struct ve a, struct ve b)
{
    return ve_add(a, ve_neg(b));
}

LANE_OP struct ve ve_mul(struct ve a, struct ve b)
{
    vd v = a.v * b.v;

    return (struct ve){v, BOUND_OF(INTERVAL_PRODUCT, vabs(a.v) * b.e + vabs(b.v) * a.e + a.e * b.e) +
                              vabs(v) * BOUND(PRODUCT) + BOUND(PRODUCT_UNIT)};
}

/* Returns a/b. Clears *fine in lanes whose b may be 0. */
LANE_OP struct ve ve_div(struct ve a, struct ve b, vm *fine)
{
    vd size = vabs(b.v);
    vm good = vlt(BOUND(DIVISOR_KNOWN) * b.e, size);
    vd v = a.v / vsel(good, b.v, vset(1));

    *fine = mand(*fine, good);
    return (struct ve){v, BOUND_OF(INTERVAL_QUOTIENT, (a.e + vabs(v) * b.e) / vsel(good, size - b.e, vset(1))) +
                              vabs(v) * BOUND(QUOTIENT) + BOUND(QUOTIENT_UNIT)};
}

/* Returns the square root of a. Clears *fine in lanes whose a may be negative. */
LANE_OP struct ve ve_sqrt(struct ve a, vm *fine)
{
    vm good = vlt(a.e, a.v);
    vd v = vsqrt(vsel(good, a.v, vset(1)));

    *fine = mand(*fine, good);
    return (struct ve){v, BOUND_OF(INTERVAL_ROOT, root_error(a.e, v)) + v * BOUND(ROOT) + BOUND(ROOT_UNIT)};
}

LANE_OP vm ve_less(struct ve a, struct ve b)
{
    return vlt(a.v + a.e, b.v - b.e);
}

LANE_OP struct ve ve_sel(vm m, struct ve a, struct ve b)
{
    return (struct ve){vsel(m, a.v, b.v), vsel(m, a.e, b.e)};
}

#endif
