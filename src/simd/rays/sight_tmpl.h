/* sight_tmpl.h - distances along the line of sight of the faces that the rasteriser has found.
 *
 * Parameters: the doubles of isa/isa.h. Defines: struct sight, sight_of(). */
#ifndef TIA_SIMD_RAYS_SIGHT_TMPL_H
#define TIA_SIMD_RAYS_SIGHT_TMPL_H

#include "vector_tmpl.h"

/* A distance along the line of sight, and its error; `fine` is false in undecided lanes. */
struct sight {
    vd z, e;
    vm fine;
};

/* Returns the distances of the lanes' faces. In perspective z = 1/i, with |1/i - 1/i'| <= e/(i i') and i' >= 15/16 i
 * where e <= i/16. */
LANE_OP struct sight sight_of(bool orthographic, struct v3 inverse, vd x, vd y)
{
    vd i = inverse.x * x + inverse.y * y + inverse.z;
    vd e = (vabs(inverse.x) * x + vabs(inverse.y) * y + vabs(inverse.z)) * BOUND(SIGHT_SUM);
    vm fine = vlt(BOUND(SIGHT_KNOWN) * e, i);

    if (orthographic)
        return (struct sight){i, e + BOUND(SIGHT_UNIT), fine};
    vd z = 1 / vsel(fine, i, vset(1));
    return (struct sight){
        z, BOUND_OF(SIGHT_INVERSE, z * z * e * BOUND(SIGHT_QUOTIENT)) + z * BOUND(QUOTIENT) + BOUND(SIGHT_UNIT), fine};
}

#endif
