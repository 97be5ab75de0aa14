/* shaft_objects_tmpl.h - the objects that any shadow ray of a shaft may meet, in lists.
 *
 * Parameters: the doubles and pairs of floats of isa/isa.h. Defines: find_shaft().
 *
 * Where nothing is listed, all samples of a light reach the point. Spheres are listed with what decides each sample
 * without a root or a division, all other objects with a ball and a tube around them. */
#ifndef TIA_SIMD_RAYS_SHAFT_OBJECTS_TMPL_H
#define TIA_SIMD_RAYS_SHAFT_OBJECTS_TMPL_H

#include "shaft_faces_tmpl.h"

/* Returns the lanes whose shafts are certainly on one side of a plane: `from` is the height of O over it, `to` those of
 * the samples over O. */
LANE_OP vm on_one_side(const struct area *a, vd from, const struct affine *to, vd e)
{
    vd end = from + to->at, reach = affine_reach(a, to) + e;

    return mor(mand(vlt(e, from), vlt(reach, end)), mand(vlt(from, -e), vlt(end, -reach)));
}

LANE_OP vm misses_plane(const struct shaft *f, const struct sure_object *o)
{
    const struct area *a = f->area;
    struct v3 n = v3_set(o->normal), way = v3_sub(f->shade->outside, v3_set(o->at));
    struct affine to = affine_of(a->axes, a->out, n);

    return on_one_side(a, v3_dot(way, n), &to,
                       BOUND_OF(SHAFT_PLANE, a->apart + (v3_sum(way) + v3_sum(a->out)) * BOUND(PLANE_WAY) +
                                                 BOUND(PLANE_BEHIND_UNITS)));
}

/* Returns the lanes whose shafts certainly miss a level mesh, see level_tmpl.h. */
LANE_OP vm misses_level(const struct shaft *f, const struct sure_tree *mesh)
{
    const struct area *a = f->area;
    int axis = mesh->axis;
    struct affine to = {along_of(a->out, axis), along_of(a->axes[0], axis), along_of(a->axes[1], axis)};

    return on_one_side(a, along_of(f->shade->outside, axis) - vset(mesh->height), &to,
                       BOUND_OF(LEVEL_AWAY, a->apart + BOUND(LEVEL_HEIGHT)));
}

/* The lanes of a sphere: `dark` ones certainly have all their rays blocked by it, `known` ones decide each ray. */
struct ball_lanes {
    unsigned dark, known, inside;
};

/* Sets the numbers of a sphere. r' is larger than r by all errors, so that a fixed-point ray certainly misses the
 * sphere, or meets it behind O or beyond the sample, wherever the exact segment does so with r'. A ray meets the sphere
 * if its discriminant ((C - O).V)^2 - `outside` V^2 is above 0; where O and S are outside and 0 < (C - O).V < V^2,
 * between O and S. Rays from inside meet it, whatever their direction. */
static struct ball_lanes set_ball(const struct area *a, const struct local *t, const struct sure_object *o,
                                  unsigned lanes, struct ball *ball)
{
    vd l1 = v3_sum(t->l), far = v3_sum(t->out), r = vset(o->radius), square = v3_dot(t->l, t->l);
    vd lambda = BOUND_OF(SPHERE_ACROSS, t->eo + l1 * (t->ed + BOUND(SPHERE_ASIDE)) + BOUND(SPHERE_ASIDE_UNIT));
    vd all = BOUND_OF(SPHERE_ANY, t->eo + l1 * (2 * t->ed + BOUND(SPHERE_ASIDE)) + BOUND(SPHERE_ANY_UNITS));
    vd es = BOUND_OF(SPHERE_SQUARE, 2 * r * lambda + all * all + r * r * BOUND(SPHERE_SQUARE_ROUNDING)) +
            (l1 * l1 + far * far) * BOUND(SHAFT_SQUARE);
    vd pad = BOUND_OF(SHAFT_BALL, 2 * (t->apart + l1 * t->ed)), way = vsqrt(v3_dot(t->out, t->out));
    vd near = way - t->reach, most = way + t->reach;
    vm out, beyond, in = vlt(2 * (es + pad * pad), r * r - square);

    ball->object = o;
    ball->along = affine_of(t->axes, t->out, t->l);
    ball->outside = square - r * r;
    ball->error = es;
    vd reach = affine_reach(a, &ball->along), least = vmax(ball->along.at - reach, vset(0));
    lanes &= ~mbits(mand(t->fine, shaft_misses(t, square, ball->along.at, vsqrt(r * r + es) + pad, &out, &beyond)));
    vm covered = mand(vlt((ball->outside + es) * most * most * (1 + BOUND(SHAFT_TOUCH)), least * least),
                      vlt(ball->along.at + reach, near * near * (1 - BOUND(SHAFT_TOUCH))));
    unsigned known = lanes & mbits(mand(t->fine, mand(mor(out, in), beyond)));
    unsigned dark = o->opaque ? known & mbits(mor(in, mand(out, covered))) : 0;
    ball->lanes = lanes & ~dark;
    return (struct ball_lanes){dark, known & ~dark, mbits(in) & known};
}

/* Sets a ball around a shape; false: there is none. */
static bool ball_around(const struct sure_object *o, double centre[3], double *radius)
{
    double square = 0;

    for (int i = 0; i < 3; i++) {
        double half = (o->normal[i] - o->at[i]) / 2;
        square += half * half;
        centre[i] = o->kind == SURE_BOX     ? o->at[i] + half
                    : o->kind == SURE_ROUND ? o->round->anchor[i]
                    : o->kind == SURE_MESH  ? o->mesh->centre[i]
                                            : o->at[i];
    }
    *radius = o->kind == SURE_BOX     ? __builtin_sqrt(square)
              : o->kind == SURE_ROUND ? o->round->reach
              : o->kind == SURE_MESH  ? o->mesh->extent
                                      : o->radius;
    return o->kind == SURE_BOX || o->kind == SURE_ROUND || o->kind == SURE_MESH || o->kind == SURE_DISC;
}

/* Sets the tube around a cylinder or cone, whose anchor is at t->l; returns the lanes that certainly miss it: those
 * that pass it by, and those that start outside and move away from the axis. */
static vm set_tube(const struct area *a, const struct local *t, const struct sure_round *k, vd pad, struct other *other)
{
    struct v3 axis = v3_set(k->axis), l = t->l, across = v3_sub(l, v3_scale(axis, v3_dot(l, axis)));
    vd radius = vset(k->base_radius > k->top_radius ? k->base_radius : k->top_radius) + pad, l1 = v3_sum(l);
    vd square = v3_dot(t->out, t->out), slack = (l1 + radius) * (v3_sum(t->out) + t->reach) * BOUND(SHAFT_TOUCH);
    struct affine near = affine_of(t->axes, t->out, across);

    other->side = affine_of(t->axes, t->out, v3_cross(axis, l));
    other->rise = affine_of(t->axes, t->out, axis);
    other->widest = radius * radius;
    other->eside = (l1 * l1 + radius * radius) * BOUND(SHAFT_SQUARE);
    vd flat = vsqrt(vmax(square - other->rise.at * other->rise.at, vset(0)) + square * BOUND(SHAFT_SQUARE)) + t->reach;
    vm by = vlt(flat * radius + slack + affine_reach(a, &other->side), vabs(other->side.at));
    return mor(
        by, mand(vlt(radius * radius, v3_dot(across, across)), vlt(near.at + affine_reach(a, &near) + slack, vset(0))));
}

/* Sets what is around an object; returns the lanes that certainly miss it. */
static vm surround(const struct shaft *f, const struct sure_object *o, unsigned lanes, struct other *other)
{
    double centre[3], radius;
    vm out, beyond, miss;

    other->tube = false;
    other->bound = ball_around(o, centre, &radius);
    if (!other->bound)
        return mnone();
    struct local t = local_shaft(f, o, v3_set(centre));
    vd l1 = v3_sum(t.l), square = v3_dot(t.l, t.l);
    vd pad = BOUND_OF(SHAFT_AROUND, 2 * t.apart + (l1 + v3_sum(t.out)) * BOUND(SLABS_FLOATS)) + BOUND(SHAFT_SHAPE);
    vd grown = vset(radius) + pad;
    other->along = affine_of(t.axes, t.out, t.l);
    other->outside = square - grown * grown;
    other->eoutside = l1 * l1 * BOUND(SHAFT_SQUARE);
    other->square = square_of(t.axes, t.out);
    miss = shaft_misses(&t, square, other->along.at, grown, &out, &beyond);
    other->tube = o->kind == SURE_ROUND;
    if (other->tube)
        miss = mor(miss, set_tube(f->area, &t, o->round, pad, other));
    if (lanes & ~mbits(t.fine))
        other->bound = other->tube = false;
    return mand(t.fine, miss);
}

/* Lists an object whose rays are traced. */
static void shaft_other(struct shaft *f, const struct sure_object *o, uint32_t index, unsigned lanes)
{
    struct other *other = &f->other[f->others];
    int pairs = f->pairs;

    if (f->others == OTHERS || o->kind == SURE_UNKNOWN) {
        f->rest |= lanes;
        return;
    }
    lanes &= ~mbits(surround(f, o, lanes, other));
    other->index = index;
    other->placed = o->placed;
    other->pair = -1;
    if (lanes && o->kind == SURE_MESH && !o->placed && !o->grouped) {
        lanes = shaft_mesh(f, o->mesh, index, f->room->faces, lanes);
        if (f->pairs <= PAIRS) {
            other->pair = pairs;
            other->pairs = f->pairs - pairs;
        } else {
            f->pairs = pairs;
        }
    }
    other->lanes = lanes;
    f->others += lanes != 0;
}

static void shaft_ball(struct shaft *f, const struct sure_object *o, uint32_t index, unsigned lanes)
{
    struct ball *ball = &f->ball[f->balls < BALLS ? f->balls : 0];
    bool room = f->balls < BALLS && (o->opaque || !o->unclear);
    struct local t = local_shaft(f, o, v3_set(o->at));

    if (!room) {
        shaft_other(f, o, index, lanes);
        return;
    }
    struct ball_lanes of = set_ball(f->area, &t, o, lanes, ball);
    unsigned left = ball->lanes & ~of.known;
    f->lanes &= ~of.dark;
    ball->lanes = of.known;
    ball->inside = of.inside;
    if (o->placed)
        ball->square = square_of(t.axes, t.out);
    f->balls += of.known != 0;
    if (left)
        shaft_other(f, o, index, left);
}

/* Returns the lanes that do not start on the object, or may meet it nevertheless. The others certainly leave it, as
 * only samples over the tangent plane count; see struct origin. */
LANE_OP unsigned not_own(const struct shade *h, const struct sure_object *o, uint32_t index, unsigned lanes)
{
    unsigned own = 0, out = ~mbits(h->back);

    for (int k = 0; k < LANES; k++)
        own |= (unsigned)(h->index[k] == index) << k & lanes;
    if (!own)
        return lanes;
    switch (o->kind) {
    case SURE_SPHERE:
    case SURE_ROUND:
    case SURE_BOX:
        return lanes & ~(own & out);
    case SURE_PLANE:
    case SURE_DISC:
    case SURE_TRIANGLE:
        return lanes & ~(o->placed ? own & out : own);
    case SURE_MESH:
        return o->mesh->level ? lanes & ~(o->placed ? own & out : own) : lanes;
    default:
        return lanes;
    }
}

static void shaft_object(const struct sure_scene *s, uint32_t index, unsigned lanes, struct shaft *f)
{
    const struct sure_object *o = &s->object[index];

    f->work++;
    lanes = not_own(f->shade, o, index, lanes & f->lanes & ~f->rest);
    if (lanes && o->kind == SURE_SPHERE) {
        shaft_ball(f, o, index, lanes);
        return;
    }
    if (lanes && !o->placed && o->kind == SURE_PLANE)
        lanes &= ~mbits(misses_plane(f, o));
    else if (lanes && !o->placed && o->kind == SURE_MESH && o->mesh->level)
        lanes &= ~mbits(misses_level(f, o->mesh));
    if (lanes)
        shaft_other(f, o, index, lanes);
}

static void walk_shaft(const struct sure_scene *s, struct pending *restrict stack, struct shaft *f)
{
    unsigned active = twice(f->lanes & ~f->rest);
    int depth = s->objects.node_count ? 1 : 0;

    stack[0].child.index = 0;
    while (depth > 0 && active) {
        const struct sure_node *n = &s->objects.nodes[stack[--depth].child.index];
        unsigned entered = enter_shaft(f, n) & active;
        for (int i = 0; entered; i++, entered = entered >> 1 & EVEN) {
            if (!(entered & EVEN))
                continue;
            if (n->count[i] == SURE_INNER) {
                stack[depth++].child.index = n->index[i];
                continue;
            }
            for (uint32_t k = 0; k < n->count[i]; k++)
                shaft_object(s, s->objects.items[n->index[i] + k], half(entered), f);
            active = twice(f->lanes & ~f->rest);
        }
    }
}

/* Lists the objects that these lanes' shadow rays may meet. f->area and f->shade are set. */
static __attribute__((noinline)) void find_shaft(const struct sure_scene *s, struct room *room, unsigned lanes,
                                                 struct shaft *f)
{
    f->room = room;
    f->lanes = lanes;
    f->balls = f->others = f->pairs = 0;
    f->work = 0;
    f->rest = lanes & ~mbits(mand(f->area->fine, shaft_start(s, f)));
    for (uint32_t i = 0; i < s->unbounded_count; i++)
        shaft_object(s, s->unbounded[i], lanes, f);
    walk_shaft(s, room->objects, f);
    f->rest &= f->lanes;
}

#endif
