/* pairs.h */
#ifndef TIA_LEVELS_RAYS_PAIRS_H
#define TIA_LEVELS_RAYS_PAIRS_H

#include "descend.h"
#include "triangle.h"

/* Of each lane two bits. */
struct both {
    unsigned inside, outside;
};

LANE_OP struct line line_of_mesh(const struct pack *p, const struct sure_tree *mesh)
{
    struct line l = line_of(p, mesh->centre, mesh->extent);
    vd far = v3_sum(l.moment) + vset(mesh->extent);

    l.way[0] = vp_of(p->d.x);
    l.way[1] = vp_of(p->d.y);
    l.way[2] = vp_of(p->d.z);
    l.about[0] = vp_of(l.moment.x);
    l.about[1] = vp_of(l.moment.y);
    l.about[2] = vp_of(l.moment.z);
    l.off = vp_of(l.e * (1 + SURE_2(20)));
    l.by = vp_of((3 * l.each + far * (SURE_PAIR * SURE_2(24))) * (1 + SURE_2(20)));
    return l;
}

LANE_OP struct both pair_sides(const struct line *l, const struct sure_pair *f)
{
    vp w[3], e = l->off + l->by * vp_load(f->size);

    for (int i = 0; i < 3; i++) {
        vp a = l->way[0] * vp_load(f->edge[i][0][0]) + l->way[1] * vp_load(f->edge[i][0][1]) + l->way[2] * vp_load(f->edge[i][0][2]);
        w[i] = a + l->about[0] * vp_load(f->edge[i][1][0]) + l->about[1] * vp_load(f->edge[i][1][1]) + l->about[2] * vp_load(f->edge[i][1][2]);
    }
    vp least = vp_min(vp_min(w[0], w[1]), w[2]), most = vp_max(vp_max(w[0], w[1]), w[2]);
    return (struct both){vp_le(e, least) | vp_le(most, -e), vp_le(least, -e) & vp_le(e, most)};
}

/* Each second bit. */
LANE_OP unsigned half(unsigned lanes)
{
    lanes = (lanes | lanes >> 1) & 0x3333;
    lanes = (lanes | lanes >> 2) & 0x0f0f;
    return (lanes | lanes >> 4) & 0xff;
}

#endif
