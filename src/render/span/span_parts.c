/* span_parts.c - finds where a shadow begins and ends in a row, by halving.
 *
 * The points of a row lie on an arc of a circle, less than half of it, whose radius is at least w. No point between two
 * points P0 and P1 is farther from the segment P0 P1 than
 *
 *     sag = w' - sqrt(w'^2 - |P1 - P0|^2/4) <= |P1 - P0|^2/(4 w)
 *
 * for the circle's radius w'; nor, as the arc is less than half of the circle, than |P1 - P0|/2. The ray through a
 * point P meets the sphere in P and in a point that is farther away by less than 2 w'; the product of both distances is
 * c, so that c/|P| - |P| serves as 2 w.
 *
 * In quarters of the scene's unit, with E one of both points, D = C - E and G = Q - E, the point of the line from E to
 * the light Q nearest to a caster C, R is F = E + s G, s = B/A, B = D.G, A = G.G, in |D|^2 - B^2/A from C, squared.
 * With rho = R + 7 + sag and E's doubt, where 7 stands for all rounding and for the bias, as span_casters.c has it:
 *
 * Lit. If |C - F| > rho, and P1 is not on C's side of the plane through F across C - F, the plane that is nearer to C
 * by rho - R separates C's ball from all segments from the arc to the light. If F is not between E and Q, the nearest
 * one of these takes its place, and the other one must not be on C's side either.
 *
 * Dark. The points from which the ball C hides Q, that is beyond the ball or in it, are convex: a ray's points behind a
 * point of the ball. A segment from a point X near E to Q is at s within |X - E| of F. So if F is between E and Q, and
 * |C - F| < R - (rho - R) at both ends of the arc, each with a ball of radius rho - R around it, these balls' hull,
 * which contains the arc, is in the dark. Neither E nor Q may be within rho of C: then the segment enters the ball and
 * leaves it. The points themselves are visible, and so in no ball. */
#include "span_parts.h"

#include "math/integer.h"
#include "math/noinline.h"

#define SLACK 7
#define PENDING 12 /* points to the right that wait: halves of up to 1,024 pixels, and one */

/* The point of a pixel, which is counted from the span's first one. */
struct row_point {
    struct coarse_ball ball;
    int at;
    enum span_part part;
};

/* A span being divided. */
struct division {
    const struct span_view *spans;
    const struct span_sphere *sphere;
    const uint8_t *list; /* the spheres that may cast a shadow on this one */
    int x, y;
    struct sphere_line line; /* of the pixel being computed */
    num_wide b, row_square;  /* L.v at the span's first pixel, and Y^2 + K^2 */
    int width;               /* w, the least radius of the row's circle, is at least 2^width; -1: it is not known */
};

/* Computes the point of pixel `at`; false if it is not accurate. */
static bool find_point(struct division *d, int at, struct coarse_ball *ball)
{
    const struct primary_rays *primary = &d->spans->primary;
    num_wide first = num_pixel_coordinate(2 * (d->x + at) + 1 - primary->width, primary->exponent);
    num_u t;

    d->line.b = d->b + (num_wide)at * d->line.b_step;
    d->line.square.start = num_up(num_square(first) + d->row_square, primary->square_shift) + NUM_HALF;
    d->spans->kernels->sphere(&d->line, &t);
    return span_coarse_point(primary, d->sphere, d->x + at, d->y, t, 0, ball);
}

static num_wide size_of(num_wide x, num_wide y, num_wide z)
{
    return num_abs(x) + num_abs(y) + num_abs(z);
}

/* Returns `width` by one of the row's points. */
static int width_by(const struct span_sphere *sphere, const struct coarse_ball *p)
{
    num_wide near = size_of(p->x, p->y, p->z) + 3 * (num_wide)p->radius;
    int zeros = (int)tia_clz32((uint32_t)near);
    num_wide inverse =
        (num_wide)(tia_reciprocal((uint32_t)near << zeros) - 1); /* of near 2^zeros, with the exponent 63 */
    num_wide twice = span_shift(num_down(sphere->c, 34) * inverse, zeros - 33) - near - 1;

    return twice > 2 ? span_bits(twice) - 2 : -1;
}

/* Returns the bound of the sag of the arc between two points `chord` apart, below 2^29; width -1: it is not known. */
static num_wide sag_of(num_wide chord, int width)
{
    num_wide sag = chord / 2 + 1;

    if (width >= 0 && span_bits(chord * chord) - width - 2 < span_bits(sag))
        sag = num_down(chord * chord, width + 2) + 1;
    return sag;
}

num_wide span_sag(const struct span_sphere *sphere, const struct coarse_ball *a, const struct coarse_ball *b)
{
    num_wide chord = size_of(b->x - a->x, b->y - a->y, b->z - a->z) + a->radius + b->radius;

    return span_bits(chord) > 29 ? chord : sag_of(chord, width_by(sphere, a));
}

/* ---- two points ---- */

/* From one point to another. */
struct row_step {
    num x, y, z;
};

static struct row_step between(const struct coarse_ball *a, const struct coarse_ball *b)
{
    return (struct row_step){b->x - a->x, b->y - a->y, b->z - a->z};
}

static INLINED_IN_WORDS num_wide dot(const struct row_step *a, const struct row_step *b)
{
    return num_mul(a->x, b->x) + num_mul(a->y, b->y) + num_mul(a->z, b->z);
}

/* Returns the part that a point E belongs to, or all of the arc from E to E + P, as far as one caster is concerned. No
 * point is farther than `off` from its segment. */
static NOINLINE enum span_part part_by(const struct coarse_ball *e, num off, const struct row_step *p,
                                       const struct coarse_ball *light, const struct coarse_ball *caster)
{
    struct row_step d = between(e, caster), g = between(e, light);
    num_wide a = dot(&g, &g), b = dot(&d, &g), square = dot(&d, &d), to_p = dot(&d, p);
    num slack = off + SLACK, rho = caster->radius + slack, deep = caster->radius - slack;
    num_wide k = square - num_mul(rho, rho);
    bool beyond = b >= a;

    if (k <= 0)
        return SPAN_OPEN;
    if (b <= 0)
        return to_p <= 0 ? SPAN_LIT : SPAN_OPEN;
    num_wide past = dot(&g, p);
    if (beyond)
        return k + a - 2 * b > 0 && to_p - b - past + a <= 0 ? SPAN_LIT : SPAN_OPEN;
    if (span_product_above(k, a, b, b))
        return span_product_above(to_p, a, b, past) ? SPAN_OPEN : SPAN_LIT;
    if (deep <= 0 || k + a - 2 * b <= 0 || span_product_above(square - num_mul(deep, deep), a, b, b))
        return SPAN_OPEN;
    return SPAN_DARK;
}

enum span_part span_part_of(const struct span_casters *casters, const struct coarse_ball *ball, uint32_t light,
                            uint32_t j)
{
    const struct row_step here = {0, 0, 0};

    return part_by(ball, ball->radius, &here, &casters->coarse[casters->count + light], &casters->coarse[j]);
}

/* Returns the part that a point belongs to. */
static enum span_part part_at(const struct division *d, const struct coarse_ball *point)
{
    const struct span_casters *casters = &d->spans->casters;
    const struct row_step here = {0, 0, 0};
    enum span_part part = SPAN_LIT;

    for (uint32_t j = 0; (j = span_next_in(casters, d->list, j)) < casters->count; j++) {
        enum span_part by = part_by(point, point->radius, &here, &casters->coarse[casters->count], &casters->coarse[j]);
        if (by == SPAN_DARK)
            return by;
        part = by == SPAN_LIT ? part : by;
    }
    return part;
}

/* An arc of a row from one point to another, none of whose points is farther than `off` from the line between them. */
struct row_arc {
    const struct coarse_ball *begin, *end;
    struct row_step forth, back;
    num off;
};

/* True if all points of an arc of a part belong to it, as far as one caster is concerned: lit if that can be said by
 * either end, dark by both. */
static bool is_all(const struct row_arc *arc, const struct coarse_ball *light, const struct coarse_ball *caster,
                   enum span_part part)
{
    bool by_end = part_by(arc->end, arc->off, &arc->back, light, caster) == part;

    if (by_end == (part == SPAN_LIT))
        return by_end;
    return part_by(arc->begin, arc->off, &arc->forth, light, caster) == part;
}

/* True if all points between two of the same part belong to it. */
static bool is_same_between(const struct division *d, const struct row_point *a, const struct row_point *b)
{
    const struct span_casters *casters = &d->spans->casters;
    struct row_arc arc = {&a->ball, &b->ball, between(&a->ball, &b->ball), between(&b->ball, &a->ball), 0};
    num_wide doubt = a->ball.radius > b->ball.radius ? a->ball.radius : b->ball.radius;
    num_wide chord = size_of(arc.forth.x, arc.forth.y, arc.forth.z) + 2 * doubt;

    if (a->part != b->part || a->part == SPAN_OPEN || span_bits(chord) > 29)
        return false;
    arc.off = (num)(doubt + sag_of(chord, d->width));
    for (uint32_t j = 0; (j = span_next_in(casters, d->list, j)) < casters->count; j++)
        if (is_all(&arc, &casters->coarse[casters->count], &casters->coarse[j], a->part) != (a->part == SPAN_LIT))
            return a->part != SPAN_LIT;
    return a->part == SPAN_LIT;
}

/* ---- a span ---- */

static void begin(struct division *d, const struct span_view *spans, uint32_t object, int x, int y)
{
    const struct primary_rays *primary = &spans->primary;
    num_wide row = primary_y(primary, y);

    d->spans = spans;
    d->sphere = &spans->spheres[object];
    d->list = span_list_of(&spans->casters, object, 0);
    d->x = x;
    d->y = y;
    d->width = -1;
    span_sphere_line(primary, d->sphere, d->y, d->x, &d->line);
    d->line.count = 1;
    d->b = d->line.b;
    d->row_square = num_square(row) + num_square(primary->depth);
}

/* Gives a point with its part. */
static void give_point(struct division *d, int at, struct row_point *point)
{
    point->at = at;
    point->part = find_point(d, at, &point->ball) ? part_at(d, &point->ball) : SPAN_OPEN;
}

/* Extends the last part by the pixels up to `end`, or appends another one; false if it does not fit. */
static bool extend(struct span_run runs[SPAN_RUNS], int *count, enum span_part part, int end)
{
    if (*count > 0 && (runs[*count - 1].part == part || runs[*count - 1].end == end)) {
        runs[*count - 1].end = end;
        return true;
    }
    if (*count == SPAN_RUNS)
        return false;
    runs[(*count)++] = (struct span_run){end, part};
    return true;
}

int span_divide(const struct tia_view *view, uint32_t object, int x, int y, int count, struct span_run runs[SPAN_RUNS])
{
    struct division d;
    struct row_point left, right[PENDING];
    int depth = 1, found = 0;

    begin(&d, span_view_of(view), object, x, y);
    give_point(&d, 0, &left);
    if (left.part != SPAN_OPEN)
        d.width = width_by(d.sphere, &left.ball);
    give_point(&d, count - 1, &right[0]);
    (void)extend(runs, &found, left.part, 1);
    while (depth > 0) {
        struct row_point *next = &right[depth - 1];
        if (next->at - left.at <= 1 || is_same_between(&d, &left, next)) {
            if (!extend(runs, &found, left.part, next->at) || !extend(runs, &found, next->part, next->at + 1))
                break;
            left = *next;
            depth--;
        } else {
            give_point(&d, left.at + (next->at - left.at) / 2, &right[depth]);
            depth++;
        }
    }
    return found;
}
