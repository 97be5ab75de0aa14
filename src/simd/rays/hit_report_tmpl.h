/* hit_report_tmpl.h - the update of a query by a hit.
 *
 * Parameters: the doubles of isa/isa.h. Defines: report_hit(). */
#ifndef TIA_SIMD_RAYS_HIT_REPORT_TMPL_H
#define TIA_SIMD_RAYS_HIT_REPORT_TMPL_H

#include "groups_tmpl.h"

LANE_OP void report_any_hit(struct query *q, const struct hit_report *r)
{
    vm before = mand(r->sure, vlt(r->t + r->e, q->distance - q->edistance));
    vm not_behind = mor(mand(r->sure, vle(r->t - r->e, q->distance + q->edistance)),
                        mand(r->may, vle(r->low, q->distance + q->edistance)));
    vm open = mand(not_behind, mnot(before));

    if (!q->opaque) {
        q->met = mor(q->met, before);
        q->may_meet = mor(q->may_meet, open);
        if (q->groups)
            note_group(q->groups, q->group, mbits(before), mbits(open));
        return;
    }
    q->blocked = mor(q->blocked, before);
    q->maybe = mor(q->maybe, open);
    q->active = mand(q->active, mnot(before));
    q->blocker = any(before) ? q->index : q->blocker;
}

/* Adds a hit to the query. The fixed-point code has no hits beyond 2^17, so that a hit that may be farther is only a
 * possible one. */
LANE_OP void report_hit(struct query *q, struct hit_report r)
{
    vm far = mand(r.sure, mnot(vlt(r.t + r.e, vset(131072))));

    r.low = vsel(far, r.t - r.e, r.low);
    r.may = mand(mor(r.may, far), q->active);
    r.sure = mand(mand(r.sure, mnot(far)), q->active);
    if (q->any) {
        report_any_hit(q, &r);
        return;
    }
    vm nearer = mand(r.sure, vlt(r.t + r.e, q->t - q->e));
    vd other = vsel(nearer, q->t - q->e, vset(INFINITE));
    other = vsel(mand(r.sure, mnot(nearer)), r.t - r.e, other);
    other = vsel(r.may, vmin(other, r.low), other);
    q->low = vmin(q->low, other);
    q->t = vsel(nearer, r.t, q->t);
    q->e = vsel(nearer, r.e, q->e);
    q->ep = vsel(nearer, r.ep, q->ep);
    q->id = vsel(nearer, q->object, q->id);
    q->element = vsel(nearer, r.element, q->element);
    q->limit = vmin(q->limit, vsel(nearer, r.t + r.e, q->limit));
}

#endif
