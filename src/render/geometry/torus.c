/* torus.c - ring tori.
 *
 * Let P be a point relative to the centre, z its height along the axis, rho its distance from the axis, and d its
 * distance from the circle in the middle of the tube:
 *
 *     d^2 = (rho - R)^2 + z^2,   f = d - r.                                                           (1)
 *
 * f is the exact distance from the surface, negative inside. On a line P + t D that starts at its point nearest to the
 * centre, |P + t D|^2 = p^2 + t^2, and (1) becomes, with rho^2 = p^2 + t^2 - z^2 and z = h + t e,
 *
 *     Q(t) = (d^2 - r^2)((rho + R)^2 + z^2 - r^2) = (p^2 + t^2 + R^2 - r^2)^2 - 4 R^2 rho^2
 *          = t^4 + A t^2 + B t + C,
 *     A = 2 (p^2 + R^2 - r^2) - 4 R^2 (1 - e^2),   B = 8 R^2 h e,   C = (p^2 + R^2 - r^2)^2 - 4 R^2 (p^2 - h^2).
 *
 * The second factor is positive, as R > r. So Q has the sign of f everywhere, and Q' = 0 is a cubic without a quadratic
 * term, whose derivative has the roots +-s, s^2 = -A/6.
 *
 * Between -s and s and on either side of them Q' is monotonic: each of these three intervals has one root of Q' or
 * none. Between these roots, Q is monotonic: each interval has one root of Q or none. So no root is searched for where
 * none is, and none is missed, whatever the distances between roots. Every search is Newton's method, kept by bisection
 * in an interval at whose ends the signs differ.
 *
 * The torus is scaled into the unit ball, so that the numbers of Q are of one magnitude at all sizes: |t|, p <= 1. The
 * chord of the ball has t^2 <= 1 - p^2. Q is (p^2 + t^2 + R^2 - r^2)^2 <= 4 at most, and -4 R^2 rho^2 >= -4 at least;
 * |A| <= 4, |B| <= 4, |C| <= 4, |Q'| < 16, |Q''| <= 20. Q/16 is computed, so that all numbers are below 2.
 *
 * Derivation of errors, in q16. Q/16 has a handful of roundings, below 2^-60 together; so the error of Q is below
 * E = 2^-56. It matters in two places.
 *
 * Whether a line enters. This is decided by the sign of f at the critical points of Q, not by that of Q. f has the
 * error of four coordinates and two roots of Q18.45, below 2^-43, the same for thin and thick tubes. A critical point c
 * that is off by x changes Q by less than |Q'| x there. The search ends where Q' is below its rounding, 2^-56, and x is
 * at most its cube root, where all three critical points meet; so Q is off by less than 2^-74. So a tangent line is met
 * or missed as a ball of the same error would be: outlines shift by 2^-43, and there are no gaps beside them.
 *
 * Where it enters. The root of Q is where f is below E/(8 r R (R - r)), in the unit of the ball: at a root rho >= R - r
 * and so Q = f (d + r)((rho + R)^2 + z^2 - r^2) = f (2 r)(4 R rho), nearly. This is 2^-49 for tubes of 1:10, but only
 * 2^-26 for R = 2^14 and r = 2^-10. Newton's method on f, kept between the same ends, leaves the error of f alone.
 * After a step of length x, f is x^2/(2 n) at most, n being the smaller of r and R - r, since no curvature of f beside
 * the surface is larger than 1/n; n is 2^-10 or more. One step is usual, as x is below 2^-28 there.
 *
 * The shift of the origin to the point nearest to the centre leaves P.D = x, |x| < 2^-41 for an origin 2^17 away, where
 * Q takes it as 0: 2 x t is missing in |P + t D|^2, which changes Q by 4 x t (|P|^2 - R^2 - r^2), that is f by
 * x t/R at most, nothing that the step does not correct. */
#include "crossings.h"

#include "math/noinline.h"

#define STEPS_MAX 200                          /* of a search; 5 to 10 are usual */
#define SHORT_LENGTH (NUM_LENGTH_BIAS / 32768) /* 2^-28: f is then below its square over 2 n, 2^-47 at most */
#define SHORT (NUM_UNIT_LEAST / 1024)          /* a step after which the error is below its square */

/* Q/16, of t^4/16 + second t^2 + first t + constant, in units of the reach. */
struct quartic {
    num_unit second, first, constant;
};

/* A line near the torus. */
struct passage {
    const struct prepared_torus *torus;
    struct num_point origin; /* the point nearest to the centre, relative to the centre */
    struct num_dir direction;
    num_length start;  /* t of the ray at this point */
    num_length height; /* h */
    num_unit rise;     /* e */
    num_length lo, hi; /* the part within the ball and between the planes that touch the tube, from `from` on */
    bool cut;          /* the part starts at `from` */
    struct quartic q;
};

/* Gives Q/16 and Q'/16 at t or, for the cubic, Q'/16 and Q''/16. */
static void evaluate(const struct quartic *q, bool cubic, num_unit t, num_unit *value, num_unit *slope)
{
    num_unit square = num_times(t, t), first = num_times(t, square / 4 + 2 * q->second) + q->first;

    *value = cubic ? first : num_times(square, square / 16 + q->second) + num_times(t, q->first) + q->constant;
    *slope = cubic ? 3 * (square / 4) + 2 * q->second : first;
}

/* Returns the root of Q or of Q' between lo and hi, where its sign changes: to plus if it rises. */
static NOINLINE num_unit root_between(const struct quartic *q, bool cubic, bool rises, num_unit lo, num_unit hi)
{
    num_unit t = lo + (hi - lo) / 2, value, slope;

    for (int i = 0; i < STEPS_MAX; i++) {
        evaluate(q, cubic, t, &value, &slope);
        if ((value < 0) == rises)
            lo = t;
        else
            hi = t;
        num_unit step = num_fraction(value, slope);
        if (step < SHORT && step > -SHORT)
            return num_length_clamp(t - step, lo, hi);
        t -= step;
        if (t <= lo || t >= hi)
            t = lo + (hi - lo) / 2;
        if (t == lo || t == hi)
            break;
    }
    return t;
}

/* Returns f at t, and gives f'. */
static num_length distance_at(const struct passage *p, num_length t, num_unit *slope)
{
    struct num_point v = num_point_at(p->origin, p->direction, t);
    num_length z = p->height + num_times(t, p->rise);
    struct num_point across = num_point_sub(v, num_point_along(p->torus->axis, z));
    num_length aside = num_norm(across) - p->torus->major, d = num_norm((struct num_point){aside, z, 0});

    if (slope) {
        const struct num_point section = {aside, z, 0};
        struct num_dir out, from;
        (void)num_normalise(across, &out);
        (void)num_normalise(section, &from);
        *slope = num_times(num_dir_dot(out, p->direction), from.x) + num_times(p->rise, from.y);
    }
    return d - p->torus->minor;
}

/* Returns the root of f between lo and hi, where its sign changes: to plus if it rises. The search begins at t. */
static NOINLINE num_length polished(const struct passage *p, num_length t, num_length lo, num_length hi, bool rises)
{
    num_unit slope;

    for (int i = 0; i < STEPS_MAX; i++) {
        if (t <= lo || t >= hi)
            t = lo + (hi - lo) / 2;
        if (t <= lo || t >= hi)
            break;
        num_length f = distance_at(p, t, &slope), step = num_div(f, slope);
        if ((f < 0) == rises)
            lo = t;
        else
            hi = t;
        t -= num_length_clamp(step, -2 * p->torus->reach, 2 * p->torus->reach);
        if (step < SHORT_LENGTH && step > -SHORT_LENGTH)
            break;
    }
    return num_length_clamp(t, lo, hi);
}

/* Clips the part of the line to the two planes that touch the tube. */
static bool clip(struct passage *p)
{
    num_length thick = p->torus->minor + NUM_LENGTH_BIAS;

    if (p->rise == 0)
        return p->height <= thick && p->height >= -thick;
    num_length a = num_div(-thick - p->height, p->rise), b = num_div(thick - p->height, p->rise);
    num_length near = a < b ? a : b, far = a < b ? b : a;

    p->lo = near > p->lo ? near : p->lo;
    p->hi = far < p->hi ? far : p->hi;
    return p->lo < p->hi;
}

/* Moves the line's origin to the point nearest to the centre and clips the line. False if it certainly misses. */
static bool approach(const struct prepared_torus *torus, const struct ray *ray, const struct line_part *part,
                     struct passage *p)
{
    struct num_point from = num_point_sub(ray->origin, torus->centre);

    p->torus = torus;
    p->direction = ray->direction;
    p->start = -num_point_dot(from, ray->direction);
    if (p->start + torus->reach < part->from || p->start - torus->reach > part->limit)
        return false;
    p->origin = num_point_at(from, ray->direction, p->start);
    p->hi = num_half_chord(torus->reach, p->origin);
    if (p->hi < 0)
        return false;
    p->lo = -p->hi;
    p->height = num_point_dot(p->origin, torus->axis);
    p->rise = num_dir_dot(ray->direction, torus->axis);
    if (!clip(p) || p->start + p->lo > part->limit)
        return false;
    p->cut = part->from - p->start > p->lo;
    p->lo = p->cut ? part->from - p->start : p->lo;
    return p->lo < p->hi;
}

/* Sets the numbers of Q/16. */
static void set_quartic(struct passage *p)
{
    const struct prepared_torus *torus = p->torus;
    struct num_dir o = {num_fraction_by(p->origin.x, torus->per), num_fraction_by(p->origin.y, torus->per),
                        num_fraction_by(p->origin.z, torus->per)};
    num_unit h = num_fraction_by(p->height, torus->per), square = num_dir_dot(o, o);
    num_unit half = (square + torus->bulk) / 2; /* (p^2 + R^2 - r^2)/2 */

    p->q.second = half / 4 - num_times(torus->ring, NUM_UNIT_ONE - num_times(p->rise, p->rise)) / 4;
    p->q.first = num_times(num_times(torus->ring, h), p->rise) / 2;
    p->q.constant = num_times(half, half) / 4 - num_times(torus->ring, square - num_times(h, h)) / 4;
}

/* The search for crossings from left to right: what is known at the point reached. */
struct search {
    num_unit at;    /* the point: `lo` or a critical point */
    bool inside;    /* f < 0 there */
    unsigned count; /* crossings found */
    num_length *t;
};

/* Moves on to the next critical point or to the end; Q is monotonic until there. Adds the crossing, if there is one. */
static void move_on(const struct passage *p, struct search *s, num_unit to, bool inside)
{
    if (inside != s->inside) {
        num_length lo = num_times(p->torus->reach, s->at), hi = num_times(p->torus->reach, to);
        num_length root = num_times(p->torus->reach, root_between(&p->q, false, s->inside, s->at, to));
        s->t[s->count++] = p->start + polished(p, root, lo, hi, s->inside);
    }
    s->at = to;
    s->inside = inside;
}

static NOINLINE void search(const struct passage *p, struct search *s, unsigned most)
{
    num_unit lo = num_fraction_by(p->lo, p->torus->per), hi = num_fraction_by(p->hi, p->torus->per);
    num_unit bend = p->q.second < 0 ? num_unit_sqrt(p->q.second / 3 * -8) : 0, value, slope;

    s->at = lo;
    evaluate(&p->q, true, lo, &value, &slope);
    for (int i = 0; i < 3 && s->count < most; i++) {
        num_unit next = i == 0 ? -bend : i == 1 ? bend : hi;
        bool fell = value < 0;
        next = next < hi ? next : hi;
        if (next <= lo)
            continue;
        evaluate(&p->q, true, next, &value, &slope);
        if (fell != (value < 0)) {
            num_unit c = root_between(&p->q, true, fell, lo, next);
            move_on(p, s, c, distance_at(p, num_times(p->torus->reach, c), NULL) < 0);
        }
        lo = next;
    }
    if (s->count < most)
        move_on(p, s, hi, false);
}

unsigned torus_crossings(const struct prepared_torus *torus, const struct ray *ray, const struct line_part *part,
                         num_length t[TORUS_CROSSINGS])
{
    struct passage p;
    struct search s = {0, false, 0, t};

    if (!approach(torus, ray, part, &p))
        return 0;
    set_quartic(&p);
    s.inside = p.cut && distance_at(&p, p.lo, NULL) < 0;
    search(&p, &s, part->most);
    return s.count;
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection)
{
    const struct line_part ahead = {0, limit, 1};
    num_length t[TORUS_CROSSINGS];

    intersection->element = 0;
    if (!torus_crossings(&shape->torus, ray, &ahead, t))
        return false;
    intersection->t = t[0];
    return t[0] >= 0 && t[0] <= limit;
}

static bool chord_of(const struct shape *shape, const struct ray *ray, num_length after, struct chord *chord)
{
    const struct line_part whole = {-NUM_LENGTH_MAX, NUM_LENGTH_MAX, TORUS_CROSSINGS};
    num_length t[TORUS_CROSSINGS];
    unsigned count = torus_crossings(&shape->torus, ray, &whole, t);

    return crossings_chord(t, count, after, chord);
}

/* Gives the point relative to the centre in the torus's own frame: along U and -V, and the height. */
static struct num_point framed(const struct prepared_torus *torus, struct num_point point)
{
    struct num_point v = num_point_sub(point, torus->centre);

    return (struct num_point){num_point_dot(v, torus->across[0]), num_point_dot(v, torus->across[1]),
                              num_point_dot(v, torus->axis)};
}

/* The normal points away from the nearest point of the circle. */
static void surface_at(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface)
{
    const struct prepared_torus *torus = &shape->torus;
    struct num_point v = num_point_sub(point, torus->centre);
    struct num_dir out;

    (void)element;
    (void)num_normalise(num_point_sub(v, num_point_along(torus->axis, num_point_dot(v, torus->axis))), &out);
    (void)num_normalise(num_point_sub(v, num_point_along(out, torus->major)), &surface->normal);
    surface->smooth = surface->normal;
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2])
{
    const struct prepared_torus *torus = &shape->torus;
    struct num_point v = framed(torus, point);
    const struct num_point flat = {v.x, v.y, 0}, section = {num_norm(flat) - torus->major, v.z, 0};
    struct num_dir around, over;

    (void)element;
    (void)num_normalise(flat, &around);
    (void)num_normalise(section, &over);
    uv[0] = NUM_LENGTH_ONE / 2 - num_length_of_unit(num_atan2(around.y, around.x));
    uv[1] = NUM_LENGTH_ONE / 2 + num_length_of_unit(num_atan2(over.y, over.x));
}

/* The reach has a margin of 2^-13, so that no point of the surface is on the ball. */
static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    struct prepared_torus *torus = &shape->torus;
    struct num_dir tangents[2];

    (void)scene;
    torus->centre = num_point_of(given->torus.centre);
    torus->axis = num_dir_of(given->torus.axis);
    shape_tangents(torus->axis, tangents);
    torus->across[0] = tangents[0];
    torus->across[1] = num_dir_negated(tangents[1]);
    torus->major = num_length_of(given->torus.major);
    torus->minor = num_length_of(given->torus.minor);
    torus->reach = torus->major + torus->minor + NUM_LENGTH_BIAS;
    num_length hole = torus->major - torus->minor;
    torus->per = num_divisor_of(torus->reach);
    num_unit major = num_fraction_by(torus->major, torus->per);
    torus->ring = num_times(major, major);
    torus->bulk =
        num_times(num_fraction_by(hole, torus->per), num_fraction_by(torus->major + torus->minor, torus->per));
}

const struct shape_kind SHAPE_KIND(torus) = {prepare, intersect, shape_occludes, surface_at, uv_at, chord_of};
