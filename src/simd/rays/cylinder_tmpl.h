/* cylinder_tmpl.h - cylinders.
 *
 * Parameters: the doubles of isa/isa.h. Defines: comes_near(), meet_cylinder().
 *
 * In the axes of a cylinder, from its base, a ray is p + t y across and h + t d along. With f = |y| it meets the side,
 * |p + t y| = r, at
 *
 *     t = (-p.y -+ D)/f^2,   D = sqrt(r^2 f^2 - (p x y)^2).
 *
 * At t the fixed-point ray is within lambda(t) = eo + t ed of the certified ray. So are their lines across the axis; y'
 * is the fixed-point y, f' its length: f' <= f + ed. Let X be the point where the certified ray meets the side at t,
 * and X + a the fixed-point ray's point at t, |a| <= lambda. The part of a along the fixed-point ray moves a point
 * along the ray alone; let b be the rest, and X + b + s D' the point where the fixed-point ray meets the side. Across
 * the axis, X + b being off the circle by eta = 2 r lambda + lambda^2 squared at most,
 *
 *     s = -eta'/(G + sqrt(G^2 - f'^2 eta')),   |eta'| <= |b| (2 sqrt(r^2 - g^2) + lambda) <= eta,
 *     G = (X + b).y',   |G| >= g = D - r ed - lambda,
 *
 * as |X.y| = D, and as b is at right angles to D', so that its part along the normal X/r is at most |b| sqrt(1 -
 * (g/r)^2). Let T = sqrt(g^2 - f'^2 eta). If g > 0 and T > 0 the fixed-point ray certainly meets the side, and s^2 <=
 * b^2 (r^2 - g^2 + eta/2)/T^2: the hit moves by
 *
 *     sqrt(b^2 + s^2) <= lambda sqrt(r^2 - f'^2 eta + eta/2)/T <= lambda (r + lambda)/T,
 *
 * and t, to which the part of a along the ray adds, by no more, as (|b|, |a - b|) is no longer than lambda.
 *
 * Across the axis the hit moves less. Along y' the line is w = r sin v off the axis where it is v round it, X in the
 * fixed-point direction, and then off by lambda at most, so that the arc is at most r lambda over the least r cos v on
 * its way; which is |X.y'|/f' >= g/f' before and sqrt(G^2 - f'^2 eta')/f' >= T/f' behind: r lambda f'/T. That is f'
 * times the bound above, and the normal is off by that over r.
 *
 * The hit of a plane across the axis moves by lambda/(|d| - ed), along the ray as in space, by the same triangle.
 *
 * The roundings of either side are counted as a move of the ray, which is no less. In doubles, with l = |x| + |y| + |z|
 * of the origin from the base, each of its coordinates in the axes is off by 5 u l (the difference, the axis, a
 * product, two sums), p x y and p.y by 2 u l f more: together below 16 u l. Those of the direction are off by 4 u, and
 * 5 u are for f^2, 1/f^2, and t: 16 u. D^2 is off by 4 u r^2 f^2 and D by u r f, as if r were by 3 u r. The fixed-point
 * origin, moved along the ray, is half a unit off in each of its coordinates, p again in each of two, the distance from
 * the axis by one: 2.6 units. Along the ray, across the axis, the place nearest to it is off by a unit and the root by
 * one and a half. That is 5.25 units in all; t and the point are then rounded by 2 units together, heights by 3. All
 * else is within 2^-55 of the reach, of which 8 u are added.
 *
 * No test notices when the following parts are left out. l in lambda: |O| is at most |t| and twice the reach, so that
 * the others, 16 u |t| and 8 u of the reach, leave 4 u |O| without it; doubles were never seen to be off by 1 u |O|.
 * The difference of D and g: lambda is that of the farther end, which is half a chord away at least, D/f^2, so that f^2
 * eta is 2 r D ed or more, as much as r ed takes off g^2 but for r^2 ed^2; and the part of b along y' leaves the line
 * across the axis where it is. `slanted`: along the axis 1/f^2 would be infinite and t not a number, so that every lane
 * is undecided anyway. */
#ifndef TIA_SIMD_RAYS_CYLINDER_TMPL_H
#define TIA_SIMD_RAYS_CYLINDER_TMPL_H

#include "hit_report_tmpl.h"
#include "render/geometry/round.h"

/* True if any lane's line passes the axis so close that it may meet the side; most packets that miss it are decided
 * here. (D x A).O is the distance from the axis times f = |D x A|. Both are off by less than 32 u of the way to the
 * shape, and pad is 2^-21 of that at least. */
LANE_OP bool comes_near(const struct query *q, const struct sure_round *k)
{
    const struct packet *p = q->p;
    struct v3 across = v3_cross(p->d, v3_set(k->axis));
    vd aside = vabs(v3_dot(across, v3_sub(p->o, v3_set(k->base)))),
       widest = BOUND_OF(TUBE_WIDEST, vset(k->base_radius) + p->pad);
    vd sure = vmax(aside - p->pad * BOUND(TUBE_ASIDE), vset(0));
    vm passes = mor(starts_outside(q), vlt(widest * widest * v3_dot(across, across), sure * sure));

    return any(mand(q->active, mnot(passes)));
}

/* The part of a ray, within the shape's box, that may be inside the side, from `from` to `to`; only this part can have
 * hits. */
struct tube {
    const struct sure_round *k;
    vd square, towards, discriminant; /* f^2, -p.y, D^2 */
    vd height, rise;
    vd off, turn; /* lambda(t) = off + |t| turn */
    vd over;      /* 1/f^2 */
    vd from, to;
    vm slanted; /* the ray is not along the axis, so that f^2 is a divisor */
    vm miss;
};

LANE_OP vd lambda_at(const struct tube *b, vd t)
{
    return b->off + vabs(t) * b->turn;
}

LANE_OP vd eta_of(vd radius, vd lambda)
{
    return BOUND_OF(TUBE_ETA, (2 * radius + lambda) * lambda * BOUND(TUBE_BOUND));
}

/* Finds the part inside the side; false: all lanes miss. The fixed-point ray is inside the side only where the
 * certified one is within r + lambda of the axis: f^2 (t + p.y/f^2)^2 <= (r + lambda)^2 - (p x y)^2/f^2. */
LANE_OP bool tube_of(const struct query *q, const struct sure_round *k, struct tube *b)
{
    const struct packet *p = q->p;
    struct v3 o = v3_sub(p->o, v3_set(k->base)), a0 = v3_set(k->across[0]), a1 = v3_set(k->across[1]);
    struct v3 axis = v3_set(k->axis);
    vd p0 = v3_dot(o, a0), p1 = v3_dot(o, a1), y0 = v3_dot(p->d, a0), y1 = v3_dot(p->d, a1), l1 = v3_sum(o);
    vd r = vset(k->base_radius), reach = vset(k->reach), aside = p0 * y1 - p1 * y0;

    b->k = k;
    b->height = v3_dot(o, axis);
    b->rise = v3_dot(p->d, axis);
    b->square = y0 * y0 + y1 * y1;
    b->towards = -(p0 * y0 + p1 * y1);
    b->discriminant = r * r * b->square - aside * aside;
    b->off = BOUND_OF(TUBE_OFF, p->eo + l1 * BOUND(TUBE) + reach * BOUND(TUBE_REACH) + BOUND(TUBE_UNITS));
    b->turn = BOUND_OF(TUBE_TURN, p->ed + BOUND(TUBE));
    vd start = b->towards - b->height * b->rise, estart = BOUND_OF(TUBE_START, b->off + l1 * b->turn);
    vd lambda = lambda_at(b, vabs(start) + reach + estart), most = b->discriminant + eta_of(r, lambda) * b->square;
    b->miss = mor(starts_outside(q), vlt(most, vset(0)));
    b->from = start - reach - estart;
    b->to = start + reach + estart;
    b->miss = mor(b->miss, mor(vlt(b->to, vset(0)), vlt(q->limit, b->from)));
    if (!any(mand(q->active, mnot(b->miss))))
        return false;
    b->slanted = vlt(vset(BOUND(TUBE_SLANTED)), b->square);
    b->over = 1 / vsel(b->slanted, b->square, vset(1));
    vd half = vsqrt(vmax(most, vset(0))) * BOUND(TUBE_BOUND);
    vd margin = BOUND_OF(TUBE_MARGIN, lambda + BOUND(TUBE_HEIGHT_UNITS));
    b->from = vsel(b->slanted, vmax(b->from, (b->towards - half) * b->over - BOUND(TUBE_DISTANCE_UNITS)), b->from);
    b->to = vsel(b->slanted, vmin(b->to, (b->towards + half) * b->over + BOUND(TUBE_DISTANCE_UNITS)), b->to);
    vd z0 = b->height + b->from * b->rise, z1 = b->height + b->to * b->rise;
    b->miss = mor(b->miss, mor(vlt(b->to, vset(0)), vlt(q->limit, b->from)));
    b->miss = mor(b->miss, mor(vlt(vmax(z0, z1), -margin), vlt(vset(k->length) + margin, vmin(z0, z1))));
    return any(mand(q->active, mnot(b->miss)));
}

/* An end of the part inside the side: its height, and its position relative to the shape's ends. */
struct tube_end {
    vd t, e, element;
    vm low, above, high, below; /* certain comparisons: low and above with the base, high and below with the top */
    vm hit, none;
};

LANE_OP struct tube_end side_end(const struct tube *b, vd t, vd stretch)
{
    vd e = BOUND_OF(TUBE_DISTANCE, lambda_at(b, t) * stretch + BOUND(TUBE_DISTANCE_UNITS));
    vd margin = BOUND_OF(TUBE_END, e + BOUND(TUBE_HEIGHT_UNITS)), z = b->height + t * b->rise;
    vd under = vset(b->k->length) - z;
    struct tube_end end = {.t = t, .e = e, .element = vset(ROUND_SIDE)};

    end.low = vlt(z, -margin);
    end.above = vlt(margin, z);
    end.high = vlt(under, -margin);
    end.below = vlt(margin, under);
    end.hit = mand(end.above, end.below);
    end.none = mor(mor(end.low, end.high), vlt(t, -e));
    return end;
}

/* Moves an end to a cap: with caps, a ray outside the length at this end enters or leaves by them if it is inside at
 * the other end. */
LANE_OP void cap_end(const struct tube *b, struct tube_end *end, const struct tube_end *other)
{
    vd slope = vabs(b->rise) - b->turn, size = vsel(vlt(vset(0), slope), slope, vset(1));
    vm crosses = mand(mor(mand(end->low, other->above), mand(end->high, other->below)), vlt(vset(0), slope));
    vd plane = vsel(end->low, vset(0), vset(b->k->length)) - b->height;
    vd t = plane / vsel(crosses, b->rise, vset(1)),
       e = BOUND_OF(TUBE_CAP, lambda_at(b, t) / size + BOUND(TUBE_DISTANCE_UNITS));

    end->none = mor(mand(end->low, other->low), mand(end->high, other->high));
    end->t = vsel(crosses, t, end->t);
    end->e = vsel(crosses, e, end->e);
    end->element = vsel(crosses, vsel(end->low, vset(ROUND_BASE), vset(ROUND_TOP)), end->element);
    end->hit = mor(end->hit, crosses);
    end->none = mor(end->none, mand(end->hit, vlt(end->t, -end->e)));
}

/* Reports the hit. From inside, the first end lies behind. Where it is undecided if the second end is at a cap, a cap
 * may be met before it. */
LANE_OP void tube_report(struct query *q, const struct tube *b, const struct tube_end ends[2], vm known)
{
    const struct tube_end *in = &ends[0], *out = &ends[1];
    vm own = starts_inside(q), passed = mand(known, mor(own, in->none));
    vm first = mand(mand(known, mnot(own)), mand(in->hit, vlt(in->e, in->t)));
    vm second = mand(passed, mand(out->hit, vlt(out->e, out->t))), sure = mand(mor(first, second), mnot(b->miss));
    vm done = mor(mor(b->miss, sure), mand(passed, out->none));
    vd e = vsel(first, in->e, out->e), beyond = vmax(b->from, out->t - out->e);
    vm later = b->k->capped ? mand(passed, out->hit) : passed;

    report_hit(q, (struct hit_report){.sure = sure,
                                      .may = mnot(done),
                                      .t = vsel(first, in->t, out->t),
                                      .e = e,
                                      .ep = BOUND_OF(TUBE_POINT, e),
                                      .low = vmax(vsel(later, beyond, b->from), vset(0)),
                                      .element = vsel(first, in->element, out->element)});
}

static __attribute__((noinline)) void meet_cylinder(struct query *q, const struct sure_round *k)
{
    struct tube b;

    if (!tube_of(q, k, &b))
        return;
    vd r = vset(k->base_radius), d = vsqrt(vmax(b.discriminant, vset(0)));
    vd t0 = (b.towards - d) * b.over, t1 = (b.towards + d) * b.over;
    vd lambda = lambda_at(&b, vmax(vabs(t0), vabs(t1))), g = d - r * b.turn - lambda;
    vd rest = g * g * BOUND(TUBE_LEAST) - eta_of(r, lambda) * (b.square + BOUND(TUBE_SQUARE) * b.turn);
    vm known = mand(b.slanted, mand(vlt(vset(0), g), vlt(vset(0), rest)));
    vd stretch = BOUND_OF(TUBE_STRETCH, (r + lambda) * BOUND(TUBE_BOUND) / vsqrt(vsel(known, rest, vset(1))));
    struct tube_end ends[2] = {side_end(&b, t0, stretch), side_end(&b, t1, stretch)};

    if (k->capped) {
        struct tube_end first = ends[0];
        cap_end(&b, &ends[0], &ends[1]);
        cap_end(&b, &ends[1], &first);
    }
    tube_report(q, &b, ends, known);
}

#endif
