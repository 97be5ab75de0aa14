/* pairs_tmpl.h - the faces of a mesh that lines may meet, in floats, two faces at once.
 *
 * Parameters: the doubles and pairs of floats of isa/isa.h. Defines: lines_of(), pair_passes(), struct lines, struct
 * passes.
 *
 * As in triangle_tmpl.h, the area of an edge from A to B is w = D.P + M.E, where P = A x B, E = B - A and M = O x D are
 * relative to the mesh's centre. |M| is the distance of the line from that centre, wherever O lies on the line. In
 * floats, with v = 2^-24:
 *
 * Each term has two conversions from doubles, a product, and up to five sums: it is off by 8 v of itself. As |D| is 1,
 * the sizes of the terms of D.P add up to |P| at most. Those of M.E add up to |M| |E| at most, |M| being taken as |x| +
 * |y| + |z|, and |E| as the largest of |x|, |y| and |z|. Let R be the mesh's extent, and let c be at least |E| and
 * |P|/R. Then all terms add up to (R + |M|) c at most. This is also a limit of |w|, and w is off by 8 v of it.
 *
 * The third area follows from the sum. The E of a face add up to 0, and the P to a vector N that does not depend on the
 * centre. So w2 = D.N - w0 - w1. Let c be at least |N|/R too. Then D.N is off by 5 v R c, as its terms have two sums
 * only. w0 and w1 are off by 8 v each. The differences are rounded by v of w1 + w2 and by v of w2, which is 3 v.
 * Together this is 24 v of (R + |M|) c. Terms of second order and the rounding of N in doubles are less than another v.
 *
 * The bound of doubles on the fixed-point area, l.e plus l.each times the face's extent, is added. The extent is 3 c at
 * most, so the whole bound is off + by c. Its roundings in floats are less than 8 v of it. Products below 2^-126 may
 * become 0; they are far smaller than l.e, which is at least 2^-42 R. R is 2^-17 or more, as boxes are larger than
 * their contents.
 *
 * Where floats cannot decide whether a line meets a face, doubles do: for one in 100 of the faces that are met in a
 * mesh of 3000 faces, for one in 40 in a mesh of 300000. */
#ifndef TIA_SIMD_RAYS_PAIRS_TMPL_H
#define TIA_SIMD_RAYS_PAIRS_TMPL_H

#include "slabs_tmpl.h"
#include "triangle_tmpl.h"

/* Lines prepared for the test of pairs, with two floats per lane: D, M and the bound of an area, off + by c. */
struct lines {
    struct line line;
    vp way[3], moment[3], off, by;
    unsigned starts; /* lanes whose rays start on the mesh and move away from it */
};

/* The result for two faces; bit 2 k + i: lane k, face i. */
struct passes {
    unsigned inside, outside;
};

LANE_OP void lines_of(struct lines *l, const struct packet *p, const struct sure_tree *mesh)
{
    const double up = 1 + BOUND(PAIR_ROUNDING);

    l->line = line_of(p, mesh->centre, mesh->extent);
    struct v3 m = l->line.moment;
    vd far = v3_sum(m) + vset(mesh->extent);
    l->way[0] = vp_of(p->d.x);
    l->way[1] = vp_of(p->d.y);
    l->way[2] = vp_of(p->d.z);
    l->moment[0] = vp_of(m.x);
    l->moment[1] = vp_of(m.y);
    l->moment[2] = vp_of(m.z);
    l->off = vp_of(l->line.e * up);
    l->by = vp_of((BOUND_OF(PAIR_EDGE, 3 * l->line.each) + far * BOUND(PAIR_AREA)) * up);
}

LANE_OP vp pair_dot(const vp a[3], const float b[3][2])
{
    return a[0] * vp_load(b[0]) + a[1] * vp_load(b[1]) + a[2] * vp_load(b[2]);
}

LANE_OP vp pair_edge(const struct lines *l, const float e[2][3][2])
{
    return pair_dot(l->way, e[0]) + l->moment[0] * vp_load(e[1][0]) + l->moment[1] * vp_load(e[1][1]) +
           l->moment[2] * vp_load(e[1][2]);
}

/* Tests lines against a pair. The bound is strictly larger than the error of an area, so that an area equal to the
 * bound is decided correctly. */
LANE_OP struct passes pair_passes(const struct lines *l, const struct sure_pair *f)
{
    vp a = pair_edge(l, f->edge[0]), b = pair_edge(l, f->edge[1]), c = pair_dot(l->way, f->whole) - a - b;
    vp least = vp_min(vp_min(a, b), c), most = vp_max(vp_max(a, b), c), e = l->off + l->by * vp_load(f->size);

    return (struct passes){vp_le(e, least) | vp_le(most, -e), vp_le(least, -e) & vp_le(e, most)};
}

#endif
