/* sphere_tmpl.h - spheres: L = C - O, P = L - (L.D) D, thc = sqrt(r^2 - |P|^2).
 *
 * Parameters: the doubles of isa/isa.h. Defines: find_sphere(), meet_sphere().
 *
 * P is off by lambda = eo + |tca| ed + U + 16 u |L| across the ray, and by `all` = eo + 2 |L| ed + 2 U + 16 u |L| in
 * any direction. As P is at right angles to D, an error along the ray counts only in second order, as all^2. So s = r^2
 * - |P|^2 is within
 *
 *     es = 2 |P| lambda + all^2 + 32 u r^2.
 *
 * If s < -es, the ray certainly misses. Otherwise |P| is at most r, except in lanes that are undecided anyway. thc is
 * within the root's error by es, see root_error(), and U + 4 u r. t is within the sum of eo, |P| ed, the bound of thc
 * and the roundings of tca. The point relative to C is -(P + thc D). It is within lambda + thc ed across the
 * ray, and within |P| ed and the bound of thc along the ray. ep is the hypotenuse of both, and 2 U.
 *
 * As these two bounds are separate, a direction is within lambda/(r cos) + ed after a bounce; with a single bound, this
 * would be 20 times as large. */
#ifndef TIA_SIMD_RAYS_SPHERE_TMPL_H
#define TIA_SIMD_RAYS_SPHERE_TMPL_H

#include "hit_report_tmpl.h"

/* Intersects each lane's ray with a sphere at `at` of radius r. Returns false if no lane may hit its sphere. */
LANE_OP bool find_sphere(const struct query *q, struct v3 at, vd r, struct hit_report *found)
{
    const struct packet *p = q->p;
    struct v3 l = v3_sub(at, p->o);
    vd tca = v3_dot(l, p->d), l1 = v3_sum(l);
    struct v3 side = v3_sub(l, v3_scale(p->d, tca));
    vd p2 = v3_dot(side, side), s = r * r - p2, round = r * r * BOUND(SPHERE_SQUARE_ROUNDING);
    vd lambda =
        BOUND_OF(SPHERE_ACROSS, p->eo + vabs(tca) * p->ed + l1 * BOUND(SPHERE_ASIDE) + BOUND(SPHERE_ASIDE_UNIT));
    vd all = BOUND_OF(SPHERE_ANY, p->eo + l1 * (2 * p->ed + BOUND(SPHERE_ASIDE)) + BOUND(SPHERE_ANY_UNITS));
    vd es = BOUND_OF(SPHERE_SQUARE, 2 * r * lambda + all * all + round);
    vm active = mand(q->active, mnot(starts_outside(q))), own = starts_inside(q);
    vm hit = mand(vlt(es, s), active), unclear = mand(mand(vle(-es, s), mnot(hit)), active);

    if (!any(mor(hit, unclear)))
        return false;
    vd aside = vmin(vsqrt(p2) + all, r), thc = vsqrt(vmax(s, es)), more = all * p->ed;
    vd ethc = BOUND_OF(SPHERE_HALF_CHORD, root_error(2 * aside * lambda + all * all + round, thc) +
                                              BOUND(SPHERE_ROOT_UNIT) + BOUND(SPHERE_ROOT) * r);
    vd along = BOUND_OF(SPHERE_POINT_ALONG, aside * p->ed + ethc + more);
    vd across = BOUND_OF(SPHERE_POINT_ACROSS, lambda + thc * p->ed);
    vd e = BOUND_OF(SPHERE_DISTANCE, p->eo + l1 * BOUND(SPHERE_ALONG) + BOUND(SPHERE_ALONG_UNIT) + along);
    vd t0 = tca - thc, t1 = tca + thc;
    vm ahead = mand(vlt(e, t0), mnot(own)), within = mand(mor(own, vlt(t0, -e)), vlt(e, t1)), behind = vlt(t1, -e);
    vm sure = mand(hit, mor(ahead, within));
    /* the fixed-point thc of undecided lanes is at most sqrt(s + es) <= sqrt(2) thc */
    vd reach = 2 * thc + e;
    vm passed = vlt(tca + reach, vset(0));
    vm may = mor(mand(hit, mnot(mor(sure, behind))), mand(unclear, mnot(passed)));

    *found =
        (struct hit_report){.sure = sure,
                            .may = may,
                            .t = vsel(ahead, t0, t1),
                            .e = e,
                            .ep = BOUND_OF(SPHERE_POINT, vsqrt(across * across + along * along) + BOUND(POINT_UNITS)),
                            .low = vsel(hit, vset(0), tca - reach),
                            .element = vset(0)};
    return any(mor(sure, may));
}

LANE_OP void meet_sphere(struct query *q, const double at[3], double radius)
{
    struct hit_report found;

    if (find_sphere(q, v3_set(at), vset(radius), &found))
        report_hit(q, found);
}

#endif
