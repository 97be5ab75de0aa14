/* round_tmpl.h - cones: the steps of geometry/round.c, in numbers with bounds.
 *
 * Parameters: the doubles of isa/isa.h. Defines: meet_round(), discriminant(), struct reach, struct quadratic. */
#ifndef TIA_SIMD_RAYS_ROUND_TMPL_H
#define TIA_SIMD_RAYS_ROUND_TMPL_H

#include "hit_report_tmpl.h"
#include "interval_tmpl.h"
#include "render/geometry/round.h"

#define MOST 131072.0 /* NUM_LENGTH_MAX */

/* The ray in a cone's axes, as struct beam of geometry/round.c, and the decisions so far. In `fine` lanes all of them
 * are certain; `miss` lanes certainly miss the cone. */
struct beam {
    const struct sure_round *k;
    vm fine, miss;
    struct v3 near; /* the moved origin, relative to the anchor */
    vd start, estart, enear, l1, flat;
    struct ve d0, d1, height, rise, pace, nearest, passing;
};

/* Computes the point of the ray that is nearest to the anchor, and makes two quick tests: against a sphere around the
 * anchor, and against a cylinder around the axis. False: all lanes miss. */
LANE_OP bool beam_start(struct query *q, const struct sure_round *k, struct beam *b)
{
    const struct packet *p = q->p;
    struct v3 o = v3_sub(p->o, v3_set(k->anchor));
    vd reach = vset(k->reach);

    b->k = k;
    b->fine = mof((1u << LANES) - 1);
    b->l1 = v3_sum(o);
    b->start = -v3_dot(o, p->d);
    b->estart = BOUND_OF(CONE_START, p->eo + b->l1 * (p->ed + BOUND(CONE_START_ROUNDING)) + BOUND(LENGTH_UNIT));
    b->near = v3_along(o, p->d, b->start);
    b->enear = BOUND_OF(CONE_NEAR, p->eo + b->l1 * (2 * p->ed + BOUND(CONE_NEAR_ROUNDING)) + BOUND(CONE_NEAR_UNITS));
    vd lambda = BOUND_OF(CONE_PASS, p->eo + (vabs(b->start) + reach) * p->ed + b->l1 * BOUND(CONE_PASS_ROUNDING));
    vd square = v3_dot(b->near, b->near), out = reach + b->enear;
    b->miss = mor(starts_outside(q), vlt(out * out, square * (1 - BOUND(CONE_SQUARE))));
    b->miss = mor(b->miss, vlt(b->start + reach + b->estart, vset(0)));
    b->miss = mor(b->miss, vlt(q->limit, b->start - reach - b->estart));
    if (!any(mand(q->active, mnot(b->miss))))
        return false;
    /* the test of passes_by() in geometry/round.c; |Q|, whose square is `flat`, is at most 1 */
    struct v3 a0 = v3_set(k->across[0]), a1 = v3_set(k->across[1]);
    vd y0 = v3_dot(p->d, a0), y1 = v3_dot(p->d, a1), flat = y0 * y0 + y1 * y1;
    vd aside = vabs(v3_dot(b->near, a0) * y1 - v3_dot(b->near, a1) * y0) - b->l1 * BOUND(CONE_ASIDE);
    vd thick = vset((k->base_radius > k->top_radius ? k->base_radius : k->top_radius) + BOUND(CONE_THICKNESS));
    vd beside = BOUND_OF(CONE_BESIDE, 3 * lambda + BOUND(CONE_PASSED));
    vd bound = (thick * thick * flat + (2 * thick + beside) * beside) * (1 + BOUND(CONE_SQUARE));
    b->miss = mor(b->miss, mand(vlt(vset(0), aside), vlt(bound, aside * aside)));
    return any(mand(q->active, mnot(b->miss)));
}

LANE_OP void beam_of(const struct packet *p, struct beam *b)
{
    const struct sure_round *k = b->k;
    struct v3 a0 = v3_set(k->across[0]), a1 = v3_set(k->across[1]), axis = v3_set(k->axis);
    vd edir = BOUND_OF(CONE_TURN, p->ed + vset(BOUND(CONE_DIRECTION)));
    vd epos = BOUND_OF(CONE_PLACE, b->enear + v3_sum(b->near) * BOUND(CONE_PLACE_ROUNDING) + BOUND(LENGTH_UNIT));
    b->d0 = ve_of(v3_dot(p->d, a0), edir);
    b->d1 = ve_of(v3_dot(p->d, a1), edir);
    b->flat = vsqrt(b->d0.v * b->d0.v + b->d1.v * b->d1.v);
    vm some = vlt(BOUND(CONE_KNOWN) * edir, b->flat);
    b->fine = mand(b->fine, some);
    vd over = 1 / vsel(some, b->flat, vset(1)), eq = edir * BOUND(CONE_CHORD) * over + BOUND(CONE_UNIT);
    struct ve q0 = ve_of(b->d0.v * over, eq), q1 = ve_of(b->d1.v * over, eq);
    struct ve p0 = ve_of(v3_dot(b->near, a0), epos), p1 = ve_of(v3_dot(b->near, a1), epos);
    b->height = ve_of(v3_dot(b->near, axis), epos);
    b->rise = ve_of(v3_dot(p->d, axis), edir);
    b->pace = ve_of(b->flat, edir + BOUND(CONE_LENGTH));
    b->nearest = ve_neg(ve_add(ve_mul(p0, q0), ve_mul(p1, q1)));
    b->passing = ve_sub(ve_mul(p0, q1), ve_mul(p1, q0));
}

/* A part of the ray inside a solid; undefined in lanes that are not fine or that miss. */
struct reach {
    struct ve in, out;
};

/* The quadratic, as struct quadratic of geometry/round.c, and the length by which its roots are divided. */
struct quadratic {
    struct ve g, m, w, n0, n1, ab, length;
    vm flatter, steeper;
};

LANE_OP struct quadratic quadratic_of(struct beam *b)
{
    const struct sure_round *k = b->k;
    struct ve c = ve_set(k->cosine), s = ve_set(k->sine);
    struct ve radius = ve_set(k->anchored > 0 ? k->top_radius : k->base_radius);
    struct ve fx = ve_mul(b->pace, c), fy = ve_mul(b->rise, s);
    vd f = vsqrt(fx.v * fx.v + fy.v * fy.v), ef = fx.e + fy.e;
    vm good = vlt(BOUND(CONE_KNOWN) * ef, f);
    vd inverse = 1 / vsel(good, f, vset(1)), en = ef * BOUND(CONE_CHORD) * inverse + BOUND(CONE_UNIT);
    struct quadratic u = {.n0 = ve_of(fx.v * inverse, en), .n1 = ve_of(fy.v * inverse, en)};

    b->fine = mand(b->fine, good);
    u.length = ve_of(f, ef + BOUND(CONE_LENGTH));
    u.g = ve_add(ve_mul(radius, c), ve_mul(b->height, s));
    u.m = ve_mul(b->nearest, c);
    u.w = ve_mul(b->passing, c);
    u.ab = ve_mul(ve_add(u.n0, u.n1), ve_sub(u.n0, u.n1));
    u.flatter = vlt(u.ab.e, u.ab.v);
    u.steeper = vlt(u.ab.v, -u.ab.e);
    b->fine = mand(b->fine, mor(u.flatter, u.steeper));
    return u;
}

/* Returns D of the roots; lanes that certainly have no roots become misses. */
LANE_OP struct ve discriminant(struct beam *b, const struct quadratic *u, struct ve e)
{
    struct ve root = ve_sqrt(ve_of(vabs(u->ab.v), u->ab.e), &b->fine), wr = ve_mul(u->w, root);
    struct ve e2 = ve_mul(e, e), w2 = ve_mul(wr, wr);
    struct ve rest = ve_sel(u->steeper, ve_add(e2, w2), ve_sub(e2, w2));

    vm none = mand(u->flatter, mor(vlt(rest.v, -rest.e), vlt(e.v, -e.e)));
    b->miss = mor(b->miss, mand(none, b->fine));
    b->fine = mand(b->fine, mor(u->steeper, vlt(e.e, e.v)));
    return ve_sqrt(rest, &b->fine);
}

LANE_OP struct reach side_reach(struct beam *b)
{
    struct quadratic u = quadratic_of(b);
    struct ve h = ve_add(ve_mul(u.m, u.n0), ve_mul(u.g, u.n1)), e = ve_add(ve_mul(u.g, u.n0), ve_mul(u.m, u.n1));
    struct ve d = discriminant(b, &u, e), most = ve_of(vset(MOST), vset(0)), least = ve_of(vset(-MOST), vset(0));
    vm down = vlt(h.v, -h.e), up = vlt(h.e, h.v);

    b->fine = mand(b->fine, mor(down, up));
    struct ve k = ve_sel(down, ve_sub(h, d), ve_add(h, d));
    struct ve c = ve_sub(ve_add(ve_mul(u.m, u.m), ve_mul(u.w, u.w)), ve_mul(u.g, u.g));
    struct ve one = ve_div(k, u.ab, &b->fine), other = ve_div(c, k, &b->fine);
    vm first = vlt(one.v, other.v);
    struct ve low = ve_sel(first, one, other), high = ve_sel(first, other, one);
    low.e = high.e = vmax(one.e, other.e);
    low = ve_div(low, u.length, &b->fine);
    high = ve_div(high, u.length, &b->fine);
    vm grows = vlt(u.n1.e, u.n1.v);
    b->fine = mand(b->fine, mor(u.flatter, mor(grows, vlt(u.n1.v, -u.n1.e))));
    return (struct reach){ve_sel(u.steeper, ve_sel(grows, high, least), low),
                          ve_sel(u.steeper, ve_sel(grows, most, low), high)};
}

LANE_OP struct reach height_reach(struct beam *b, vm rises)
{
    const struct sure_round *k = b->k;
    struct ve most = ve_of(vset(MOST), vset(0)), anchored = ve_set(k->anchored);
    struct ve base = k->base_radius > 0 ? ve_sub(ve_neg(anchored), b->height) : ve_neg(most);
    struct ve top = k->top_radius > 0 ? ve_sub(ve_sub(ve_set(k->length), anchored), b->height) : most;
    struct ve to_base = ve_div(base, b->rise, &b->fine), to_top = ve_div(top, b->rise, &b->fine);

    return (struct reach){ve_sel(rises, to_base, to_top), ve_sel(rises, to_top, to_base)};
}

/* Reports an end of the interval inside both the side and the heights: the first end that lies ahead. Without caps,
 * only ends at the side count.
 *
 * For a ray that starts inside a cylinder, the first end lies behind the origin, see cylinder_tmpl.h. This does not
 * hold for a cone. Near its sharp edge, the offset b may put the origin outside again, and the ray may enter the cone
 * from there, although it moves away from the surface on which it started. */
LANE_OP void beam_report(struct query *q, struct beam *b, const struct reach *side, const struct reach *height,
                         vm rises)
{
    struct ve zero = ve_of(vset(0), vset(0)), begin = ve_of(b->start, b->estart);
    vm enters = ve_less(height->in, side->in), leaves = ve_less(side->out, height->out);
    b->fine =
        mand(b->fine, mand(mor(enters, ve_less(side->in, height->in)), mor(leaves, ve_less(height->out, side->out))));
    struct ve t1 = ve_add(begin, ve_sel(enters, side->in, height->in));
    struct ve t2 = ve_add(begin, ve_sel(leaves, side->out, height->out));
    vm take1 = ve_less(zero, t1), behind1 = ve_less(t1, zero), take2 = ve_less(zero, t2);
    b->fine = mand(b->fine, mand(mor(take1, behind1), mor(take2, ve_less(t2, zero))));
    if (!b->k->capped) {
        take1 = mand(take1, enters);
        take2 = mand(take2, leaves);
    }
    struct ve t = ve_sel(take1, t1, t2);
    vm by_side = mor(mand(take1, enters), mand(mnot(take1), leaves));
    vm at_base = mor(mand(take1, rises), mand(mnot(take1), mnot(rises)));
    t.e = t.e + BOUND(CONE_UNITS);

    report_hit(q, (struct hit_report){
                      .sure = mand(mand(b->fine, mnot(b->miss)), mor(take1, take2)),
                      .may = mand(mnot(b->fine), mnot(b->miss)),
                      .t = t.v,
                      .e = t.e,
                      .ep = BOUND_OF(CONE_POINT, q->p->eo + t.e + t.v * q->p->ed + BOUND(POINT_UNITS)),
                      .low = vmax(b->start - vset(b->k->reach) - q->p->eo -
                                      b->l1 * (q->p->ed + BOUND(CONE_START_ROUNDING)) - BOUND(LENGTH_UNIT),
                                  vset(0)),
                      .element = vsel(by_side, vset(ROUND_SIDE), vsel(at_base, vset(ROUND_BASE), vset(ROUND_TOP)))});
}

static __attribute__((noinline)) void meet_round(struct query *q, const struct sure_round *k)
{
    struct beam b;

    if (!beam_start(q, k, &b))
        return;
    beam_of(q->p, &b);
    vm rises = vlt(vset(0), b.rise.v);
    struct reach side = side_reach(&b), height = height_reach(&b, rises);
    vm apart = mor(ve_less(side.out, side.in), mor(ve_less(height.out, side.in), ve_less(side.out, height.in)));
    vm meets = mand(vlt(side.in.v + side.in.e, side.out.v - side.out.e),
                    mand(ve_less(side.in, height.out), ve_less(height.in, side.out)));
    b.miss = mor(b.miss, mand(b.fine, apart));
    b.fine = mand(b.fine, mor(apart, meets));
    beam_report(q, &b, &side, &height, rises);
}

#endif
