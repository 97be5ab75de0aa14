/* cylinder_tmpl.h - intersection of rays with cylinders.
 *
 * Parameters: the doubles of isa/isa.h. Defines: comes_near(), meet_cylinder().
 *
 * In the axes of a cylinder, relative to its base, a ray is p + t y across the axis and h + t d along it. Let f = |y|.
 * The ray meets the side, |p + t y| = r, at
 *
 *     t = (-p.y -+ D)/f^2,   D = sqrt(r^2 f^2 - (p x y)^2).
 *
 * At t the fixed-point ray is within lambda(t) = eo + |t| ed of the certified ray, in space and so also across the
 * axis. Let E be the direction of the fixed-point ray, y' its part across the axis, and f' = |y'| <= f + ed. Let X be
 * the point where the certified ray meets the side at t, and X + a the point of the fixed-point ray at t, |a| <=
 * lambda. Split a into a part along E, which only moves the point along the fixed-point ray, and the rest b, at right
 * angles to E. The fixed-point ray meets the side at some point X + b + s E. Let eta' be the squared distance of X + b
 * from the axis, less r^2. Then
 *
 *     s = -eta'/(G + sqrt(G^2 - f'^2 eta')),   G = (X + b).y',   |G| >= g = D - r ed - lambda,
 *     |eta'| <= |b| (2 sqrt(r^2 - g^2) + lambda) <= eta = 2 r lambda + lambda^2.
 *
 * The bound of G holds as |X.y| = D. In the bound of eta', the part of b along the normal X/r is at most |b| sqrt(1 -
 * (g/r)^2), as b is at right angles to E. Let T = sqrt(g^2 - f'^2 eta). If g > 0 and T > 0, the fixed-point ray
 * certainly meets the side, and s^2 <= b^2 (r^2 - g^2 + eta/2)/T^2. So the hit moves by
 *
 *     sqrt(b^2 + s^2) <= lambda sqrt(r^2 - f'^2 eta + eta/2)/T <= lambda (r + lambda)/T.
 *
 * t moves by at most |s| + |a - b|. By the Cauchy-Schwarz inequality this is within the same bound, as b^2 + |a - b|^2
 * <= lambda^2.
 *
 * Across the axis the hit moves less. A line in the direction y' whose distance from the axis is w = r sin v meets the
 * circle at the angle v to y'. The line through X in this direction and the fixed-point line differ in w by at most
 * lambda, so the arc between their hits is at most r lambda over the least r cos v on it. At X, r cos v is |X.y'|/f' >=
 * g/f'; at the fixed-point hit it is sqrt(G^2 - f'^2 eta')/f' >= T/f'. So the arc is at most r lambda f'/T, which is
 * within f' times the bound above, and the error of the normal is the arc over r.
 *
 * The hit of a plane across the axis moves by at most lambda/(|d| - ed), in space and along the ray, by the same split
 * of a.
 *
 * The roundings of both codes are counted as a displacement of the ray, whose effect is at least as large. In doubles,
 * let l = |x| + |y| + |z| of the origin relative to the base. Each coordinate in the cylinder's axes is off by 5 u l (a
 * difference, the axis, a product, two sums), and p x y and p.y by another 2 u l f: together below 16 u l. The
 * coordinates of the direction are off by 4 u, and f^2, 1/f^2 and t add 5 u: together below 16 u. D^2 is off by 4 u r^2
 * f^2 and D by u r f, as if r were off by 3 u r. In fixed point, the origin, moved along the ray, is off by half a unit
 * in each coordinate, p by another half in each of its two, and the distance from the axis by one: 2.6 units. Along the
 * ray across the axis, the point nearest to the axis is off by a unit, and the root by one and a half. Together these
 * are 5.1 units; lambda includes 5.25. The later roundings of t and the point, 2 units together, and of heights, 3
 * units, are added separately. All other roundings are below 2^-55 of the reach; 8 u of it are added for them.
 *
 * No test fails if one of the following parts is left out.
 *
 * l in lambda: |O| is at most |t| and twice the reach, so that 16 u |t| and 8 u of the reach still include 4 u |O|. In
 * tests, doubles are off by less than u |O|.
 *
 * r ed and lambda in g: lambda is that of the farther end, at a distance of at least half a chord, D/f^2. So f^2 eta is
 * at least 2 r D ed, as much as r ed takes off g^2 but for r^2 ed^2. The part of b along y' does not move the line
 * across the axis.
 *
 * `slanted`: for a ray along the axis 1/f^2 would be infinite and t NaN, so that the lane is undecided anyway. */
#ifndef TIA_SIMD_RAYS_CYLINDER_TMPL_H
#define TIA_SIMD_RAYS_CYLINDER_TMPL_H

#include "hit_report_tmpl.h"
#include "render/geometry/round.h"

/* True if any lane's line passes the axis so closely that it may meet the side; most packets that miss it are rejected
 * here. With O relative to the base, and D and A the directions of ray and axis, |(D x A).O| is the line's distance
 * from the axis times f = |D x A|. Both are computed within 32 u of the distance to the shape, and pad is at least
 * 2^-21 of that distance. */
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

/* The interval of a ray, near the shape, in which it may be inside the infinite cylinder: `from` to `to`. Hits are
 * possible only there. */
struct tube {
    const struct sure_round *k;
    vd square, towards, discriminant; /* f^2, -p.y, D^2 */
    vd height, rise;
    vd off, turn; /* lambda(t) = off + |t| turn */
    vd over;      /* 1/f^2 */
    vd from, to;
    vm slanted; /* the ray is not along the axis, so that f^2 can be a divisor */
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

/* Finds the interval in which rays may be inside the side; false: all lanes miss. The fixed-point ray is inside the
 * side only where the certified one is within r + lambda of the axis: f^2 (t + p.y/f^2)^2 <= (r + lambda)^2 - (p x
 * y)^2/f^2. */
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

/* An end of the interval in which the ray is inside the side: t and its error, and the position relative to base and
 * top. */
struct tube_end {
    vd t, e, element;
    vm low, above, high, below; /* certainly: below the base, above the base, above the top, below the top */
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

/* Moves an end to a cap. A ray that is beyond the plane of a cap at this end, and on its inner side at the other,
 * enters or leaves the capped shape through that cap. */
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

/* Reports the hit. Where the ray starts inside, its first end lies behind the origin. Where the second end is undecided
 * and the shape is capped, a cap may be met before that end. */
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
