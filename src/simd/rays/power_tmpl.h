/* power_tmpl.h - x^e for highlights, as 2^(e log2 x) by polynomials.
 *
 * Parameters: the doubles of isa/isa.h. Defines: power(), power_turn().
 *
 * The logarithm of m in sqrt(1/2)..sqrt(2) is 2 atanh z, with z = (m - 1)/(m + 1) and |z| <= 0.1716. Its series up to
 * z^15 is off by 2 z^17/17 < 1.2e-14, and log2, roundings included, by 2e-14. The exponential function is applied to ln
 * 2 times a fraction in -1/2..1/2. Its series up to the power 11 is off by 0.3466^12/12! < 7e-15.
 *
 * The logarithm's error is relative: the rest of the series is z^16/17 < 3.4e-14 of the logarithm, and roundings add
 * 1e-15. So y = e log2 x is off by 3.5e-14 |y|, and 2^y by 3.5e-14 ln 2 |y| 2^y < 1.3e-14 for any e, as |y| 2^y is
 * 0.531 at most. With the exponential's 7e-15 and its roundings this is 2.1e-14. The fixed-point result is rounded to
 * 2^-46, after e squarings rounded to 2^-62: 1.7e-14. Together the errors are below 2^-44.
 *
 * Results below 2^-64 are replaced by 0. So |y| is at most 64, and adding 1.5 2^52 rounds y to an integer. */
#ifndef TIA_SIMD_RAYS_POWER_TMPL_H
#define TIA_SIMD_RAYS_POWER_TMPL_H

#include "vector_tmpl.h"

/* The sum x + SHIFT is x rounded to an integer, which the sum's lowest bits hold. */
#define SHIFT 6755399441055744.0 /* 1.5 2^52 */

LANE_OP vd log2_of(vd x)
{
    const int64_t least = INT64_C(0x3fe6a09e667f3bcd); /* the bits of sqrt(1/2) */
    vi above = as_integers(x) - least, exponent = above >> 52;
    vd m = as_doubles((above & 0xfffffffffffff) + least),
       n = as_doubles(exponent + INT64_C(0x4338000000000000)) - vset(SHIFT);
    vd z = (m - 1) / (m + 1), w = z * z, sum = vset(1.0 / 15);

    sum = sum * w + 1.0 / 13;
    sum = sum * w + 1.0 / 11;
    sum = sum * w + 1.0 / 9;
    sum = sum * w + 1.0 / 7;
    sum = sum * w + 1.0 / 5;
    sum = sum * w + 1.0 / 3;
    return n + (sum * w * z + z) * 2.8853900817779268; /* times 2/ln 2 */
}

/* Returns 2^y, -64 <= y <= 0. */
LANE_OP vd exp2_of(vd y)
{
    vd k = y + SHIFT, f = (y - (k - SHIFT)) * 0.69314718055994531, sum = vset(1.0 / 39916800);
    vi halvings = INT64_C(0x4338000000000000) - as_integers(k);

    sum = sum * f + 1.0 / 3628800;
    sum = sum * f + 1.0 / 362880;
    sum = sum * f + 1.0 / 40320;
    sum = sum * f + 1.0 / 5040;
    sum = sum * f + 1.0 / 720;
    sum = sum * f + 1.0 / 120;
    sum = sum * f + 1.0 / 24;
    sum = sum * f + 1.0 / 6;
    sum = sum * f + 0.5;
    sum = sum * f + 1;
    sum = sum * f + 1;
    return as_doubles(as_integers(sum) - (halvings << 52));
}

/* Returns x^e, x in 0..1, e in 1..10000. */
LANE_OP vd power(vd x, vd e)
{
    vm none = vlt(x, vset(1e-18));
    vd y = e * log2_of(vsel(none, vset(1), x));
    vm small = mor(none, vlt(y, vset(-64)));

    return vsel(small, vset(0), exp2_of(vsel(small, vset(0), y)));
}

/* Returns the change of x^n, computed as p, if x changes by e. It is at most n e, and n e (x + e)^(n - 1). For 4 n e <=
 * x the power is at most exp(1/4) x^(n - 1) < 1.3 x^n/x. */
LANE_OP vd power_turn(vd x, vd e, vd n, vd p)
{
    vd most = n * e;
    vm known = vlt(vmax(BOUND(POWER_KNOWN) * most, vset(BOUND(POWER_LEAST))), x);
    vd steep = BOUND_OF(POWER_STEEP, BOUND(POWER_GROWTH) * (p + vset(BOUND(POWER)))) / vsel(known, x, vset(1));

    return most * vsel(known, vmin(steep, vset(1)), vset(1));
}

#endif
