/* object_tmpl.h - what the intersections of all objects have in common.
 *
 * Parameters: the doubles of isa/isa.h. Defines: begin_object(), end_object(). */
#ifndef TIA_SIMD_RAYS_OBJECT_TMPL_H
#define TIA_SIMD_RAYS_OBJECT_TMPL_H

#include "hit_report_tmpl.h"

LANE_OP void begin_object(const struct sure_object *o, uint32_t index, struct query *q)
{
    q->index = index;
    q->object = vset((double)index);
    q->opaque = q->solid ? !o->layered : o->opaque;
    q->met = q->may_meet = mnone();
}

/* Filters light by an object, once for each ray. The products are rounded here and in fixed point. */
LANE_OP void filter(struct query *q, const struct sure_object *o)
{
    vm unclear = mand(q->may_meet, mnot(q->met));

    if (o->unclear)
        unclear = mor(unclear, q->met);
    q->maybe = mor(q->maybe, unclear);
    q->ethrough = q->ethrough + vsel(q->met, vset(BOUND(THROUGH_UNIT)), vset(0));
    for (int c = 0; c < 3; c++)
        q->through[c] = vsel(q->met, q->through[c] * vset(o->transmission[c]), q->through[c]);
}

LANE_OP void end_object(const struct sure_object *o, struct query *q)
{
    if (q->any && !q->opaque)
        filter(q, o);
}

#endif
