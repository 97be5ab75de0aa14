/* shaft_faces_tmpl.h - the faces of a mesh that any shadow ray of a shaft may meet.
 *
 * Parameters: the doubles and pairs of floats of isa/isa.h. Defines: shaft_mesh().
 *
 * An edge's area as in pairs_tmpl.h is linear in the direction D of a ray from O: D.P + (O x D).E = D.g, g = P + E x O.
 * So over all samples it is within |x| |g.A| + |y| |g.B| of g.V. Where one of the three areas or their sum is certainly
 * above 0 for all samples, and another one is below 0, each ray has areas of both signs and passes the face by. */
#ifndef TIA_SIMD_RAYS_SHAFT_FACES_TMPL_H
#define TIA_SIMD_RAYS_SHAFT_FACES_TMPL_H

#include "shaft_tmpl.h"

/* A packet's shafts in floats, relative to the centre of a mesh, and the bound of an area: off + by c. */
struct pair_test {
    vp at[3], way[3], axis[2][3], most, off, by;
};

/* The ranges of areas: the largest of their lower ends, and the least of their upper ends. */
struct pair_range {
    vp least, most;
};

LANE_OP void spread_floats(vp to[3], struct v3 v)
{
    to[0] = vp_of(v.x);
    to[1] = vp_of(v.y);
    to[2] = vp_of(v.z);
}

LANE_OP void pair_test_of(const struct shaft *f, const struct sure_tree *mesh, struct pair_test *t)
{
    const struct area *a = f->area;
    struct v3 o = v3_sub(f->shade->outside, v3_set(mesh->centre));
    vd eo = f->shade->eoutside, size = v3_sum(a->out) + a->reach;
    vd far = BOUND_OF(TRIANGLE_FAR, v3_sum(o) + vset(mesh->extent) + eo);
    vd e = BOUND_OF(TRIANGLE_ROUNDINGS, far * (BOUND(TRIANGLE_CORNERS) + far * BOUND(TRIANGLE_AREA)));
    vd each = BOUND_OF(TRIANGLE_EDGE, 2 * (eo + far * a->eout));

    spread_floats(t->at, o);
    spread_floats(t->way, a->out);
    spread_floats(t->axis[0], a->axes[0]);
    spread_floats(t->axis[1], a->axes[1]);
    t->most = vp_of(vset(a->most));
    t->off = vp_of(BOUND_OF(SHAFT_PAIR_OFF, 2 * size * e));
    t->by = vp_of(BOUND_OF(SHAFT_PAIR, size * (2 * BOUND_OF(PAIR_EDGE, 3 * each) + 8 * far * BOUND(PAIR_AREA))));
}

LANE_OP vp pair_product(const vp a[3], const vp b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

LANE_OP vp pair_size(vp a)
{
    return vp_max(a, vp_set(0) - a);
}

/* Takes in the range of another area, g.V -+ (|x| |g.A| + |y| |g.B|). */
LANE_OP void pair_widen(struct pair_range *r, const struct pair_test *t, const vp g[3])
{
    vp at = pair_product(g, t->way),
       reach = t->most * (pair_size(pair_product(g, t->axis[0])) + pair_size(pair_product(g, t->axis[1])));

    r->least = vp_min(r->least, at + reach);
    r->most = vp_max(r->most, at - reach);
}

/* Returns the lanes of which some ray may meet a face of the pair, two bits per lane. */
LANE_OP unsigned pair_may_be_met(const struct pair_test *t, const struct sure_pair *pair)
{
    vp g[4][3];
    struct pair_range r = {vp_set(1e30f), vp_set(-1e30f)};

    for (int k = 0; k < 3; k++) {
        int x = k < 2 ? k + 1 : 0, y = k > 0 ? k - 1 : 2;
        for (int i = 0; i < 2; i++)
            g[i][k] = vp_load(pair->edge[i][0][k]) + vp_load(pair->edge[i][1][x]) * t->at[y] -
                      vp_load(pair->edge[i][1][y]) * t->at[x];
        g[2][k] = vp_load(pair->whole[k]);
        g[3][k] = g[2][k] - g[0][k] - g[1][k];
    }
    for (int i = 0; i < 4; i++)
        pair_widen(&r, t, g[i]);
    vp e = t->off + t->by * vp_load(pair->size);
    return vp_le(vp_set(0) - e, r.least) | vp_le(r.most, e);
}

/* Returns the lanes that start on a face, and leave it. */
LANE_OP unsigned on_face(const struct shade *h, uint32_t object, uint32_t face)
{
    unsigned own = 0;

    for (int k = 0; k < LANES; k++)
        own |= (unsigned)(h->index[k] == object && h->element[k] == face) << k;
    return own;
}

/* Lists a leaf's pairs as far as there is room; returns the lanes that may meet one. */
static unsigned shaft_faces(struct shaft *f, uint32_t object, const struct pair_test *t, const struct sure_pair *pairs,
                            uint32_t count, unsigned lanes)
{
    unsigned all = 0;

    for (const struct sure_pair *pair = pairs; pair < pairs + count; pair++) {
        unsigned met = pair_may_be_met(t, pair);
        unsigned may = lanes & ((half(met) & ~on_face(f->shade, object, pair->face[0])) |
                                (half(met >> 1) & ~on_face(f->shade, object, pair->face[1])));
        if (may && f->pairs < PAIRS)
            f->pair[f->pairs] = (struct pair_ref){pair, may};
        f->pairs += may != 0;
        all |= may;
    }
    return all;
}

/* Lists the pairs of faces that these lanes may meet, and returns the lanes that may meet any. Ends with all lanes if
 * there are more than PAIRS. */
static __attribute__((noinline)) unsigned shaft_mesh(struct shaft *f, const struct sure_tree *mesh, uint32_t object,
                                                     struct pending *restrict stack, unsigned lanes)
{
    struct pair_test t;
    unsigned met = 0;
    int depth = mesh->node_count ? 1 : 0;

    pair_test_of(f, mesh, &t);
    stack[0].child.index = 0;
    while (depth > 0 && f->pairs <= PAIRS) {
        const struct sure_node *n = &mesh->nodes[stack[--depth].child.index];
        unsigned entered = enter_shaft(f, n);
        f->work++;
        for (int i = 0; i < 2; i++) {
            unsigned in = half(entered >> i) & lanes;
            if (in && n->count[i] == SURE_INNER)
                stack[depth++].child.index = n->index[i];
            else if (in)
                met |= shaft_faces(f, object, &t, &mesh->pairs[n->index[i]], n->count[i], in);
        }
    }
    return f->pairs <= PAIRS ? met : lanes;
}

#endif
