/* groups_tmpl.h - the groups of a mesh's faces that shadow rays pass through. Each group filters a ray's light only
 * once.
 *
 * Parameters: the doubles of isa/isa.h. Defines: note_group(), filter_groups(). */
#ifndef TIA_SIMD_RAYS_GROUPS_TMPL_H
#define TIA_SIMD_RAYS_GROUPS_TMPL_H

#include "query_tmpl.h"

/* Adds a group to the lists of rays. `sure` lanes certainly meet one of its faces; `open` lanes may, and stay undecided
 * unless they certainly meet another one. */
LANE_OP void note_group(struct group_list *g, uint32_t group, unsigned sure, unsigned open)
{
    for (int k = 0; (sure | open) >> k; k++) {
        int i = 0;
        if (!((sure | open) >> k & 1))
            continue;
        while (i < g->count[k] && g->group[k][i] != group)
            i++;
        if (i == GROUPS) {
            g->full |= 1u << k;
            continue;
        }
        if (i == g->count[k]) {
            g->count[k]++;
            g->group[k][i] = group;
            g->sure[k][i] = false;
        }
        g->sure[k][i] = g->sure[k][i] || sure >> k & 1;
    }
}

/* Filters each ray's light by the groups in its list, and marks undecided rays. */
static void filter_groups(struct query *q, const struct group_list *g, const double transmission[3])
{
    double through[3][LANES], more[LANES];
    unsigned open = g->full;

    for (int c = 0; c < 3; c++)
        vstore(through[c], q->through[c]);
    for (int k = 0; k < LANES; k++) {
        more[k] = 0;
        for (int i = 0; i < g->count[k]; i++) {
            open |= (unsigned)!g->sure[k][i] << k;
            more[k] += BOUND(THROUGH_UNIT);
            for (int c = 0; c < 3; c++)
                through[c][k] *= transmission[c];
        }
    }
    for (int c = 0; c < 3; c++)
        q->through[c] = vload(through[c]);
    q->ethrough = q->ethrough + vload(more);
    q->maybe = mor(q->maybe, mof(open));
}

#endif
