/* wide_tmpl.h - traversal of wide nodes by one ray of a packet: the boxes of a node and the spheres of a leaf are
 * tested side by side.
 *
 * Parameters: the doubles of isa/isa.h; vb and its operations, see there. Defines: walk_wide(), struct single,
 * WIDE_LANES.
 *
 * A visit costs a packet the same for one ray as for all. Where few rays of a packet enter a node, each of them goes on
 * by itself. The formulas are those of packets: bounds hold for one ray and several spheres in the lanes as they do for
 * several rays and one sphere, and the bound of slabs_tmpl.h holds for a box in any lane. A hit is reported to the
 * packet's query, in the lane of the ray. */
#ifndef TIA_SIMD_RAYS_WIDE_TMPL_H
#define TIA_SIMD_RAYS_WIDE_TMPL_H

#include "object_tmpl.h"
#include "slabs_tmpl.h"
#include "sphere_tmpl.h"

/* Most rays that leave a packet for a wide node; 0: none. With two lanes, a leaf of spheres takes as long as in
 * packets. */
#ifndef WIDE_LANES
#define WIDE_LANES (LANES < 4 ? 0 : LANES / 2)
#endif

#ifndef vb_set
typedef vp vb;
#define vb_set(x) vp_set(x)
#define vb_min(a, b) vp_min(a, b)
#define vb_max(a, b) vp_max(a, b)
#define vb_le(a, b) vp_le(a, b)
#endif

#define VB (sizeof(vb) / sizeof(float)) /* boxes tested at once */

/* A ray in all lanes, its query for the spheres in the lanes, and the children that wait. */
struct single {
    struct packet p;
    struct query q;
    uint64_t waits[SURE_WIDE_WAITS];
};

/* A ray prepared for the boxes of wide nodes, as in struct slabs. */
struct arrow {
    vb inv[3], in[3], out[3];
    int near[3];
};

LANE_OP vb vb_load(const float *p)
{
    vb b;

    __builtin_memcpy(&b, p, sizeof b);
    return b;
}

/* Prepares the ray of lane k, for spheres and for boxes. */
LANE_OP void single_out(struct single *one, struct arrow *to, const struct packet *p, int k)
{
    const vd *o[3] = {&p->o.x, &p->o.y, &p->o.z}, *inverse[3] = {&p->inv.x, &p->inv.y, &p->inv.z};

    one->p.o = v3_spread(&p->o, k);
    one->p.d = v3_spread(&p->d, k);
    one->p.eo = vspread(&p->eo, k);
    one->p.ed = vspread(&p->ed, k);
    one->p.from.object = vspread(&p->from.object, k);
    one->p.from.side = vspread(&p->from.side, k);
    one->q.p = &one->p;
    for (int i = 0; i < 3; i++) {
        double inv = lane_at(inverse[i], k), middle = lane_at(o[i], k) * inv,
               aside = lane_at(&p->pad, k) * __builtin_fabs(inv);
        to->inv[i] = vb_set((float)inv);
        to->in[i] = vb_set((float)(middle + aside));
        to->out[i] = vb_set((float)(middle - aside));
        to->near[i] = inv < 0 ? 3 : 0;
    }
}

/* Returns the children that the ray may enter before the limit. near[i] receives the distance of child i. */
LANE_OP unsigned enter_wide(const struct arrow *a, const struct sure_wide *n, vb limit, float near[SURE_WIDE])
{
    int x = a->near[0], y = a->near[1], z = a->near[2];
    unsigned entered = 0;

#define PLANE(k) vb_load(n->box[k] + i)
    for (unsigned i = 0; i < SURE_WIDE; i += VB) {
        vb in = vb_max(vb_max(PLANE(x) * a->inv[0] - a->in[0], PLANE(y + 1) * a->inv[1] - a->in[1]),
                       vb_max(PLANE(z + 2) * a->inv[2] - a->in[2], vb_set(0)));
        vb out = vb_min(vb_min(PLANE(3 - x) * a->inv[0] - a->out[0], PLANE(4 - y) * a->inv[1] - a->out[1]),
                        vb_min(PLANE(5 - z) * a->inv[2] - a->out[2], limit));
        __builtin_memcpy(near + i, &in, sizeof in);
        entered |= vb_le(in, out) << i;
    }
#undef PLANE
    return entered;
}

/* Returns a child and, above it, the bits of the distance at which the ray enters it. Distances are not negative, so
 * that a nearer child is a smaller number. */
LANE_OP uint64_t wait_of(const struct sure_wide *n, const float near[SURE_WIDE], int i)
{
    uint32_t bits;

    __builtin_memcpy(&bits, &near[i], sizeof bits);
    return (uint64_t)bits << 32 | n->child[i];
}

/* Goes on to the nearest of the children that the ray enters, and queues the others in any order: sorting them takes
 * more time than it saves. Returns the number of children in the queue. */
LANE_OP int go_deeper(uint64_t *next, uint64_t *restrict waits, int depth, const struct sure_wide *n, unsigned entered,
                      const float near[SURE_WIDE])
{
    uint64_t nearest = wait_of(n, near, __builtin_ctz(entered));

    for (entered &= entered - 1; entered; entered &= entered - 1) {
        uint64_t other = wait_of(n, near, __builtin_ctz(entered));
        waits[depth++] = nearest < other ? other : nearest;
        nearest = nearest < other ? nearest : other;
    }
    *next = nearest;
    return depth;
}

/* Takes the next child that the ray enters before the limit. Returns the number of children in the queue, or -1 if
 * there was none. */
LANE_OP int take_next(uint64_t *next, const uint64_t *waits, int depth, float limit)
{
    uint32_t bits;

    __builtin_memcpy(&bits, &limit, sizeof bits);
    while (depth-- > 0) {
        *next = waits[depth];
        if (*next >> 32 <= bits)
            return depth;
    }
    return -1;
}

/* Reports what a ray may hit of the spheres in the lanes, one by one, in the ray's lane k. */
LANE_OP void report_single(const struct sure_scene *s, struct query *q, int k, const struct hit_report *r,
                           const double *spheres)
{
    vd first = vsel(r->sure, r->t - r->e, r->low);
    unsigned left = mbits(mand(mor(r->sure, r->may), vle(first, vspread(&q->limit, k))));

    for (; left; left &= left - 1) {
        int i = __builtin_ctz(left);
        uint32_t index = (uint32_t)spheres[i];
        begin_object(&s->object[index], index, q);
        report_hit(q, (struct hit_report){.sure = mof((mbits(r->sure) >> i & 1) << k),
                                          .may = mof((mbits(r->may) >> i & 1) << k),
                                          .t = vspread(&r->t, i),
                                          .e = vspread(&r->e, i),
                                          .ep = vspread(&r->ep, i),
                                          .low = vspread(&r->low, i),
                                          .element = vset(0)});
        end_object(&s->object[index], q);
    }
}

/* Intersects the ray with the spheres of a leaf. Numbers behind the last sphere are loaded, but not used. */
LANE_OP void meet_spheres(const struct sure_scene *s, struct single *one, struct query *q, int k, const double *leaf)
{
    const uint32_t n = (uint32_t)*leaf++;

    q->work += n;
    for (uint32_t i = 0; i < n; i += LANES, leaf += LANES) {
        struct hit_report found;
        uint32_t left = n - i;
        one->q.object = vload(leaf + 4 * n);
        one->q.active = mof(left < LANES ? (1u << left) - 1 : (1u << LANES) - 1);
        if (find_sphere(&one->q, (struct v3){vload(leaf), vload(leaf + n), vload(leaf + 2 * n)}, vload(leaf + 3 * n),
                        &found))
            report_single(s, q, k, &found, leaf + 4 * n);
    }
}

LANE_OP float limit_of(const struct query *q, int k)
{
    vd limit = up(q->limit);

    return (float)lane_at(&limit, k);
}

/* Visits a wide node and those below it with the ray of lane k, the only active one. */
static __attribute__((noinline)) void walk_single(const struct sure_scene *s, const struct sure_tree *tree,
                                                  struct single *one, struct query *q, int k, uint32_t from)
{
    float limit = limit_of(q, k), near[SURE_WIDE];
    vb most = vb_set(limit);
    uint64_t next = from;
    int depth = 0;
    struct arrow arrow;

    single_out(one, &arrow, q->p, k);
    do {
        const struct sure_wide *n = &tree->wide[(uint32_t)next];
        unsigned entered;
        if (next & SURE_LEAF_AT) {
            meet_spheres(s, one, q, k, tree->leaves + ((uint32_t)next - SURE_LEAF_AT));
            if (!any(q->active))
                return;
            limit = limit_of(q, k);
            most = vb_set(limit);
        } else if ((entered = enter_wide(&arrow, n, most, near)) != 0) {
            depth = go_deeper(&next, one->waits, depth, n, entered, near);
            continue;
        }
        depth = take_next(&next, one->waits, depth, limit);
    } while (depth >= 0);
}

/* Visits a wide node with some of a packet's rays, one by one. */
LANE_OP void walk_wide(const struct sure_scene *s, const struct sure_tree *tree, struct single *one, struct query *q,
                       uint32_t from, unsigned lanes)
{
    vm all = q->active;

    for (; lanes; lanes &= lanes - 1) {
        vm lane = mof(lanes & ~(lanes - 1));
        q->active = lane;
        walk_single(s, tree, one, q, __builtin_ctz(lanes), from);
        all = mor(mand(all, mnot(lane)), q->active);
    }
    q->active = all;
}

#endif
