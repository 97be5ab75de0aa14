/* pairs_tmpl.h - the faces of a mesh that lines may meet, in floats, two faces at once.
 *
 * Parameters: the doubles and pairs of floats of isa/isa.h. Defines: lines_of(), pair_passes(), struct lines, struct
 * passes.
 *
 * As in triangle_tmpl.h, an edge's area is w = D.P + M.E with P = A x B, E = B - A and M = O x D, from the mesh's
 * centre; |M| is the line's distance from that centre, wherever O lies on the line. In floats, v = 2^-24:
 *
 * Each term has two conversions from doubles, a product, and up to five sums: 8 v of the term. |D| is 1, so those of
 * D.P add up to |P|, those of M.E to |M| |E|, the one as |x| + |y| + |z|, the other the most of |x|, |y| and |z|. With
 * c no less than that of E, and than |P|/R, R being the mesh's extent, they are (R + |M|) c in all, which |w| is at
 * most: w is off by 8 v of that.
 *
 * The third edge follows from the sum: the E of a face add up to 0, the P to N, which is the same from anywhere. So w2
 * = D.N - w0 - w1. Where c is no less than |N|/R either, D.N is off by 5 v R c: its terms have two sums. With 8 v of w0
 * and of w1, and two differences, of w1 + w2 and of w2, these are 24 v of (R + |M|) c; the second orders and the
 * rounding of N in doubles are less than another v.
 *
 * To this is added the bound of the doubles against the fixed-point path, l.e + l.each times the face's extent, which
 * is 3 c at most: off + by c. Rounding that in floats takes less than 8 v of it. Products below 2^-126 may become 0;
 * that is less than the part of R in l.e, 2^-17 or more, as boxes are larger than their contents.
 *
 * Where floats leave undecided whether a line meets a face, doubles decide: for one in 100 of
 * the faces that are met in a mesh of 3000 faces, for one in 40 in a mesh of 300000. */
#ifndef TIA_SIMD_RAYS_PAIRS_TMPL_H
#define TIA_SIMD_RAYS_PAIRS_TMPL_H

#include "slabs_tmpl.h"
#include "triangle_tmpl.h"

/* Lines in the form for the test of pairs, two floats a lane: D, M and the bound of an area. */
struct lines {
    struct line line;
    vp way[3], moment[3], off, by;
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

/* Tests lines against a pair. The bound is larger than the error of any area, so a sum of 0 decides nothing wrongly. */
LANE_OP struct passes pair_passes(const struct lines *l, const struct sure_pair *f)
{
    vp a = pair_edge(l, f->edge[0]), b = pair_edge(l, f->edge[1]), c = pair_dot(l->way, f->whole) - a - b;
    vp least = vp_min(vp_min(a, b), c), most = vp_max(vp_max(a, b), c), e = l->off + l->by * vp_load(f->size);

    return (struct passes){vp_le(e, least) | vp_le(most, -e), vp_le(least, -e) & vp_le(e, most)};
}

#endif
