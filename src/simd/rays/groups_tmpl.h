/* groups_tmpl.h - the groups of a mesh's faces that shadow rays pass through. Each group filters a ray's light only
 * once.
 *
 * Parameters: the doubles of isa/isa.h. Defines: note_group(), filter_groups(). */
#ifndef TIA_SIMD_RAYS_GROUPS_TMPL_H
#define TIA_SIMD_RAYS_GROUPS_TMPL_H

#include "query_tmpl.h"

/* Adds a group to the packet's list. `sure` lanes certainly meet one of its faces; `open` lanes may, and stay undecided
 * unless they certainly meet another one. */
LANE_OP void note_group(struct group_list *g, uint32_t group, unsigned sure, unsigned open)
{
    int i = 0;

    if (!(sure | open))
        return;
    while (i < g->count && g->group[i] != group)
        i++;
    if (i == GROUPS) {
        g->full |= sure | open;
        return;
    }
    if (i == g->count) {
        g->count++;
        g->group[i] = group;
        g->sure[i] = g->open[i] = 0;
    }
    g->sure[i] |= sure;
    g->open[i] |= open;
}

/* Filters each ray's light by the groups that it meets, and marks undecided rays. */
static void filter_groups(struct query *q, const struct group_list *g, const double transmission[3])
{
    unsigned open = g->full;

    for (int i = 0; i < g->count; i++) {
        vm met = mof(g->sure[i]);
        open |= g->open[i] & ~g->sure[i];
        q->ethrough = q->ethrough + vsel(met, vset(BOUND(THROUGH_UNIT)), vset(0));
        for (int c = 0; c < 3; c++)
            q->through[c] = vsel(met, q->through[c] * vset(transmission[c]), q->through[c]);
    }
    q->maybe = mor(q->maybe, mof(open));
}

#endif
