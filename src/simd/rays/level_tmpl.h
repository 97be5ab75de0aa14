/* level_tmpl.h - rays that leave a mesh whose faces all lie in one plane across an axis, as floors do.
 *
 * Parameters: the doubles of isa/isa.h. Defines: leaves_level().
 *
 * The plane is exact, as all its vertices have the same coordinate. A ray that starts on one of its faces and certainly
 * moves away meets none of the others, for the same reason for which it does not meet that face again (see struct
 * origin). Nor does any ray whose fixed-point origin is on one side of the plane, and whose direction leads away from
 * it: roundings move no intersection as far as 2^-30 out of a shape. */
#ifndef TIA_SIMD_RAYS_LEVEL_TMPL_H
#define TIA_SIMD_RAYS_LEVEL_TMPL_H

#include "query_tmpl.h"

LANE_OP vd along_axis(struct v3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/* Returns the lanes whose rays certainly miss the mesh, which is level. */
LANE_OP vm leaves_level(const struct query *q, const struct sure_tree *mesh)
{
    const struct packet *p = q->p;
    vd height = along_axis(p->o, mesh->axis) - vset(mesh->height), way = along_axis(p->d, mesh->axis);
    vd least = BOUND_OF(LEVEL_AWAY, p->eo + BOUND(LEVEL_HEIGHT));
    vm over = mand(vlt(least, height), vlt(p->ed, way)), under = mand(vlt(height, -least), vlt(way, -p->ed));

    return mor(starts_here(q), mor(over, under));
}

#endif
