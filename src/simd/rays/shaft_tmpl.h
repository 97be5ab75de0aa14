/* shaft_tmpl.h - the hull of a point and an area light, which has all shadow rays of the point in it.
 *
 * Parameters: the doubles and pairs of floats of isa/isa.h. Defines: shaft_start(), enter_shaft(), local_shaft(),
 * shaft_misses(), struct shaft, struct local, struct ball, struct other, BALLS, OTHERS, PAIRS.
 *
 * At the part s of the way from O to the light, 0 <= s <= 1, the box of the shaft is O + s (V -+ r), V = L - O, r being
 * the light's half axes. So a box from b to c has two limits of s along each axis: s (V - r) <= c - O and s (V + r) >=
 * b
 * - O. Where V - r and V + r have one sign, the shaft enters at one of them and leaves at the other; else it enters at
 * both. The margin around a ray in slabs_tmpl.h is one around a segment here. */
#ifndef TIA_SIMD_RAYS_SHAFT_TMPL_H
#define TIA_SIMD_RAYS_SHAFT_TMPL_H

#include "area_tmpl.h"

#define BALLS 32  /* most spheres in a list */
#define OTHERS 16 /* most other objects */
#define PAIRS 8   /* most pairs of faces: where there are more, walks of the mesh take less time */

/* A sphere that some samples may meet: (C - O).V, |C - O|^2 - r^2, and the error of the discriminant over V^2. */
struct ball {
    const struct sure_object *object;
    struct affine along;
    struct square square; /* V^2 in the axes of an instance; unused in the world's */
    vd outside, error;
    unsigned lanes, inside; /* inside: O is certainly in the sphere, and all samples are outside */
};

/* Another object that some samples may meet. `bound`: it lies in the ball that is given as in struct ball. `tube`: it
 * lies in a tube around the axis A through Q. A ray passes that axis at the distance |((Q - O) x A).V|/|V x A|. */
struct other {
    uint32_t index;
    unsigned lanes;
    bool placed, bound, tube;
    int pair, pairs; /* the pairs of faces that samples may meet, first and number; first: -1 if they are not listed */
    struct affine along, side, rise;
    struct square square;
    vd outside, eoutside, widest, eside;
};

struct pair_ref {
    const struct sure_pair *pair;
    unsigned lanes;
};

/* The shafts of a packet, in floats as in struct slabs, and the objects that they may meet. */
struct shaft {
    const struct area *area;
    const struct shade *shade;
    struct room *room;
    vp low[3], high[3], from_low[3], from_high[3]; /* 1/(V - r), 1/(V + r), and O with the margin, times these */
    int sign[3];                                   /* of V - r and V + r in all lanes, or 0 */
    unsigned lanes, rest; /* lanes that some sample may reach; those of them whose objects are not all listed */
    int balls, others, pairs;
    struct ball ball[BALLS];
    struct other other[OTHERS];
    struct pair_ref pair[PAIRS];
    uint32_t work;
};

LANE_OP vd along_of(struct v3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/* Prepares the test of boxes; returns the lanes that are certain enough for it. */
static vm shaft_start(const struct sure_scene *s, struct shaft *f)
{
    const struct area *a = f->area;
    struct v3 from = f->shade->outside;
    vd tiny = vset(BOUND(SLABS_TINY)), reach = v3_sum(v3_sub(from, v3_set(s->centre))) + vset(s->extent);
    vd pad = a->apart + (v3_sum(from) + reach) * BOUND(SLABS_FLOATS);

    for (int i = 0; i < 3; i++) {
        const struct affine to = {along_of(a->out, i), along_of(a->axes[0], i), along_of(a->axes[1], i)};
        vd half = affine_reach(a, &to), low = to.at - half, high = to.at + half, o = along_of(from, i);
        unsigned over = mbits(vlt(tiny, low)) & f->lanes, under = mbits(vlt(high, -tiny)) & f->lanes;
        f->sign[i] = over == f->lanes ? 1 : under == f->lanes ? -1 : 0;
        if (f->sign[i] == 0) {
            low = vmin(low, -tiny);
            high = vmax(high, tiny);
        }
        low = 1 / low;
        high = 1 / high;
        f->low[i] = vp_of(low);
        f->high[i] = vp_of(high);
        f->from_low[i] = vp_of((o - pad) * low);
        f->from_high[i] = vp_of((o + pad) * high);
    }
    return vlt(a->apart, vset((s->extent + BOUND(SLABS_LEAST)) * BOUND(SLABS_WIDE)));
}

/* Returns the lanes whose shafts may enter a node's children, two bits per lane. */
LANE_OP unsigned enter_shaft(const struct shaft *f, const struct sure_node *n)
{
    vp in = vp_set(0), out = vp_set(1);

    for (int i = 0; i < 3; i++) {
        vp low = vp_load(n->box[i + 3]) * f->low[i] - f->from_low[i],
           high = vp_load(n->box[i]) * f->high[i] - f->from_high[i];
        if (f->sign[i] > 0) {
            in = vp_max(in, high);
            out = vp_min(out, low);
        } else if (f->sign[i] < 0) {
            in = vp_max(in, low);
            out = vp_min(out, high);
        } else {
            in = vp_max(in, vp_max(low, high));
        }
    }
    return vp_le(in, out);
}

/* The shafts in the axes of an object: V, A and B, C - O, and the errors of origins and directions. */
struct local {
    struct v3 out, axes[2], l;
    vd eo, ed, reach, apart;
    vm fine;
};

/* Returns a direction in the axes of an instance. */
LANE_OP struct v3 to_axes(const struct sure_instance *i, struct v3 v)
{
    return (struct v3){v3_dot(v, v3_set(i->axes[0])) * vset(i->inverse[0]),
                       v3_dot(v, v3_set(i->axes[1])) * vset(i->inverse[1]),
                       v3_dot(v, v3_set(i->axes[2])) * vset(i->inverse[2])};
}

/* Converts a shaft to the axes of an instance as place_rays() converts rays. Directions have the length k there. */
static void place_shaft(const struct shaft *f, const struct sure_instance *i, struct local *t)
{
    const struct area *a = f->area;
    struct v3 v = v3_sub(f->shade->outside, v3_set(i->position)), at = to_axes(i, v);
    vd over = vset(1 / i->least), size = v3_sum(v) + vset(i->size);

    t->out = to_axes(i, a->out);
    t->axes[0] = to_axes(i, a->axes[0]);
    t->axes[1] = to_axes(i, a->axes[1]);
    t->l = v3_sub(v3_add(t->l, f->shade->outside), at);
    t->eo = BOUND_OF(INSTANCE_PLACE, (t->eo + size * BOUND(INSTANCE_ORIGIN) + BOUND(INSTANCE_UNITS)) * over) +
            BOUND(INSTANCE_SCALED_UNITS) + v3_sum(at) * BOUND(INSTANCE_SCALED);
    t->reach = vset(a->most) * (vsqrt(v3_dot(t->axes[0], t->axes[0])) + vsqrt(v3_dot(t->axes[1], t->axes[1])));
    vd far = vsqrt(v3_dot(t->out, t->out)), k = (far - t->reach) / (vsqrt(a->shadow.at) + a->reach);
    vd ek = BOUND_OF(INSTANCE_LENGTH, (a->eout + vset(BOUND(INSTANCE_DIRECTION))) * over);
    t->fine = vlt(BOUND(INSTANCE_KNOWN) * ek, k);
    t->ed = ek / vsel(t->fine, k, vset(1)) * BOUND(UNIT_CHORD) + BOUND(UNIT_ROUNDING);
    t->apart = BOUND_OF(SHAFT_PLACED, t->eo + 2 * (far + t->reach) * t->ed + a->apart * over);
}

LANE_OP struct local local_shaft(const struct shaft *f, const struct sure_object *o, struct v3 centre)
{
    const struct area *a = f->area;
    struct local t = {.out = a->out,
                      .axes = {a->axes[0], a->axes[1]},
                      .l = v3_sub(centre, f->shade->outside),
                      .eo = f->shade->eoutside,
                      .ed = a->eout,
                      .reach = a->reach,
                      .apart = a->apart,
                      .fine = mnot(mnone())};

    if (o->placed)
        place_shaft(f, o->placed, &t);
    return t;
}

/* Returns the lanes whose shafts certainly miss the ball of radius r' around C. `square` is |C - O|^2 and `along` is (C
 * - O).V. A point at the part s of the way is within s R of O + s V, R being the reach of the light, so the ball is
 * missed where |C - O - s V| > r' + s R for all s: a s^2 - 2 b s + c > 0 with a = V^2 - R^2, b = `along` + r' R, c =
 * `square` - r'^2. *out receives the lanes with c > 0, whose O is outside the ball; *beyond those where s = 1 fulfills
 * this, so that the light is outside. */
LANE_OP vm shaft_misses(const struct local *t, vd square, vd along, vd radius, vm *out, vm *beyond)
{
    vd a = v3_dot(t->out, t->out) - t->reach * t->reach, b = along + radius * t->reach, c = square - radius * radius;
    vm ahead = vlt(vset(0), b), within = vlt(b, a), apart = vlt(b * b * (1 + BOUND(SHAFT_TOUCH)), a * c);

    *out = vlt(vset(0), c);
    *beyond = vlt(vset(0), a - 2 * b + c);
    return mand(*out, mor(mnot(ahead), mor(mand(within, apart), mand(mnot(within), *beyond))));
}

#endif
