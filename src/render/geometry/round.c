/* round.c - cylinders and cones.
 *
 * Let z be the height of a point along the axis above the anchor, which is one of the axis's ends; r the radius there;
 * and rho the point's distance from the axis. The slope of the side has the cosine c = length/l and the sine s = (top
 * radius - base radius)/l, l being the side's length. The point is inside the side where
 *
 *     rho c <= g,   g = r c + z s                                                                    (1)
 *
 * rho c - g is the distance from the side, so all terms have the magnitude of lengths. A cylinder has c = 1, s = 0.
 *
 * The ray's origin is first moved along the ray to the point nearest to the anchor. If this point is farther from the
 * anchor than any point of the shape, the ray misses; so no number below is much larger than the shape. The anchor is
 * the thinner end because g, by which errors are divided, is smallest there. Let q be the length of the direction's
 * part across the axis, and d that of its part along the axis. Let m be the distance along the former part at which the
 * ray is nearest to the axis, and w the ray's distance from the axis there: rho^2 = w^2 + (t q - m)^2. With
 *
 *     P = w c,   M = m c,   G = g at t = 0,   (sigma, gamma) n = (q c, d s), sigma^2 + gamma^2 = 1,
 *
 * and with t in place of t n, the square of (1) is
 *
 *     P^2 + (sigma t - M)^2 <= (G + gamma t)^2.
 *
 * The roots of  ab t^2 - 2 H t + C,  ab = sigma^2 - gamma^2,  H = M sigma + G gamma,  C = M^2 + P^2 - G^2 are K/ab and
 * C/K for K = H +- D, with the sign of H. So nothing cancels. A ray parallel to the side (ab = 0) has the second root
 * alone. The discriminant is
 *
 *     D^2 = H^2 - ab C = E^2 - ab P^2,   E = G sigma + M gamma.
 *
 * E is sigma g at the ray's point nearest to the axis. This form is perpendicular too, and does not cancel.
 *
 * Squaring loses the sign of g. No point with g < 0 satisfies (1), but the other half of the double cone satisfies its
 * square. A ray that is flatter than the side (ab >= 0) is inside between its roots; g has the same sign all the way,
 * that of E. A steeper ray (ab < 0) is inside one half before the first root, and inside the other half after the
 * second. The half with g > 0 is after the second root if g grows along the ray, gamma > 0, and before the first root
 * otherwise. */
#include "round.h"

/* An interval of t; empty when far < near. */
struct span {
    num_length near, far;
};

static const struct span everywhere = {-NUM_LENGTH_MAX, NUM_LENGTH_MAX}, nowhere = {NUM_LENGTH_MAX, -NUM_LENGTH_MAX};

/* The ray relative to the axis. */
struct beam {
    num_length start;            /* distance by which the ray's origin was moved */
    num_length height;           /* height of the moved origin above the anchor */
    num_unit rise;               /* d */
    num_unit run;                /* q */
    num_length nearest, passing; /* m, w */
};

/* True if the ray's line passes the axis farther away than any point of the shape: |P x Q| > r |Q|, where P is a point
 * of the line and Q its direction, both projected along the axis. This is true for most rays near a slender shape, and
 * needs no normalisation. Rounding changes each side of the inequality by less than 2^-40; `thickness` has a margin of
 * 2^-13. */
static bool passes_by(const struct prepared_cone *cone, struct num_point o, const num_unit d[2])
{
    num_length p[2] = {num_point_dot(o, cone->across[0]), num_point_dot(o, cone->across[1])};
    num_length aside = num_times(p[0], d[1]) - num_times(p[1], d[0]);
    num_unit run = num_root_up(num_times(d[0], d[0]) + num_times(d[1], d[1]));
    num_length most = num_times(cone->thickness, run) + NUM_LENGTH_BIAS / 524288;

    return aside > most || aside < -most;
}

/* Gives the ray relative to the axis; false if the ray certainly misses the shape. */
static bool beam_of(const struct prepared_cone *cone, const struct ray *ray, num_length limit, struct beam *b)
{
    const struct num_dir *a = cone->across;
    struct num_point o = num_point_sub(ray->origin, cone->anchor);
    num_unit d[2] = {num_dir_dot(ray->direction, a[0]), num_dir_dot(ray->direction, a[1])};

    if (passes_by(cone, o, d))
        return false;
    b->start = -num_point_dot(o, ray->direction);
    if (b->start < -cone->reach || b->start - cone->reach > limit)
        return false;
    o = num_point_at(o, ray->direction, b->start);
    if (!num_within(cone->reach, o))
        return false;
    struct num_dir q = num_dir_normalised((struct num_dir){d[0], d[1], 0});
    if (q.x == 0 && q.y == 0) /* parallel to the axis: any direction across it serves */
        q.x = NUM_UNIT_ONE;
    num_length p[2] = {num_point_dot(o, a[0]), num_point_dot(o, a[1])};
    b->height = num_point_dot(o, cone->axis);
    b->rise = num_dir_dot(ray->direction, cone->axis);
    b->run = num_times(d[0], q.x) + num_times(d[1], q.y);
    b->nearest = -(num_times(p[0], q.x) + num_times(p[1], q.y));
    b->passing = num_times(p[0], q.y) - num_times(p[1], q.x);
    return true;
}

/* G, M, P, sigma and gamma of the derivation above. */
struct quadratic {
    num_length g, m, p;
    num_unit sigma, gamma;
};

static struct span solve(const struct quadratic *u)
{
    num_unit ab = num_times(u->sigma + u->gamma, u->sigma - u->gamma);
    num_length h = num_times(u->m, u->sigma) + num_times(u->g, u->gamma);
    num_length e = num_times(u->g, u->sigma) + num_times(u->m, u->gamma);
    num_length p = num_times(u->p, num_unit_sqrt(ab < 0 ? -ab : ab));
    num_length d = ab < 0 ? num_norm((struct num_point){e, p, 0}) : num_half_chord(e, (struct num_point){p, 0, 0});

    if (ab >= 0 && (e <= 0 || d < 0))
        return nowhere;
    num_length k = h < 0 ? h - d : h + d;
    num_length one = num_div(k, ab), other = k == 0 ? 0 : num_point_power((struct num_point){u->m, u->p, 0}, u->g, k);
    struct span roots = one < other ? (struct span){one, other} : (struct span){other, one};
    if (ab >= 0)
        return roots;
    return u->gamma > 0 ? (struct span){roots.far, NUM_LENGTH_MAX} : (struct span){-NUM_LENGTH_MAX, roots.near};
}

/* Returns the interval of t inside the side, the side being extended infinitely in both directions. */
static struct span side_span(const struct prepared_cone *cone, const struct beam *b)
{
    num_unit c = cone->slope_cosine, s = cone->slope_sine;
    struct num_dir flat = {num_times(b->run, c), num_times(b->rise, s), 0}, n = num_dir_normalised(flat);
    num_unit scale = num_dir_dot(flat, n);
    num_length radius = cone->anchored > 0 ? cone->top_radius : cone->base_radius;
    struct quadratic u = {num_times(radius, c) + num_times(b->height, s), num_times(b->nearest, c),
                          num_times(b->passing, c), n.x, n.y};

    if (scale == 0) /* the distance from the side is constant */
        return num_within(u.g, (struct num_point){u.m, u.p, 0}) ? everywhere : nowhere;
    struct span span = solve(&u);
    return (struct span){num_div(span.near, scale), num_div(span.far, scale)};
}

/* Returns the interval of t between base and top. An apex is no limit here, since the side ends there. */
static struct span height_span(const struct prepared_cone *cone, const struct beam *b)
{
    num_length base = cone->base_radius > 0 ? -cone->anchored - b->height : -NUM_LENGTH_MAX;
    num_length top = cone->top_radius > 0 ? cone->length - cone->anchored - b->height : NUM_LENGTH_MAX;

    if (b->rise == 0)
        return base <= 0 && top >= 0 ? everywhere : nowhere;
    num_length to_base = num_div(base, b->rise), to_top = num_div(top, b->rise);
    return b->rise > 0 ? (struct span){to_base, to_top} : (struct span){to_top, to_base};
}

/* Gives the intersection at t from the moved origin. False if t is beyond the shape's reach, or the intersection is not
 * within 0..limit. */
static bool take(const struct prepared_cone *cone, const struct beam *b, num_length t, num_length limit,
                 uint32_t element, struct intersection *intersection)
{
    if (t > cone->reach || t < -cone->reach)
        return false;
    intersection->t = b->start + t;
    intersection->element = element;
    return intersection->t >= 0 && intersection->t <= limit;
}

/* Gives the intervals of t inside the side and between the ends; false if they share nothing. */
static bool spans_of(const struct prepared_cone *cone, const struct beam *b, struct span *side, struct span *height)
{
    *side = side_span(cone, b);
    *height = height_span(cone, b);
    return side->near <= side->far && side->near <= height->far && height->near <= side->far;
}

bool round_chord(const struct shape *shape, const struct ray *ray, num_length after, struct chord *chord)
{
    const struct prepared_cone *cone = &shape->cone;
    struct beam b = {.start = 0};
    struct span side, height;

    if (!beam_of(cone, ray, NUM_LENGTH_MAX, &b) || !spans_of(cone, &b, &side, &height))
        return false;
    bool rises = b.rise > 0, enters = side.near >= height.near, leaves = side.far <= height.far;
    num_length near = enters ? side.near : height.near, far = leaves ? side.far : height.far;
    if (near < -cone->reach || far > cone->reach)
        return false;
    chord->enter = (struct intersection){b.start + near, enters ? ROUND_SIDE : rises ? ROUND_BASE : ROUND_TOP};
    chord->leave = (struct intersection){b.start + far, leaves ? ROUND_SIDE : rises ? ROUND_TOP : ROUND_BASE};
    return chord->leave.t > after && near <= far;
}

bool round_intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                     struct intersection *intersection)
{
    const struct prepared_cone *cone = &shape->cone;
    struct beam b = {.start = 0};
    struct span side, height;

    if (!beam_of(cone, ray, limit, &b) || !spans_of(cone, &b, &side, &height))
        return false;
    bool enters = side.near >= height.near, leaves = side.far <= height.far;
    if (cone->capped) {
        uint32_t first = b.rise > 0 ? ROUND_BASE : ROUND_TOP, last = b.rise > 0 ? ROUND_TOP : ROUND_BASE;
        const uint32_t side_part = ROUND_SIDE;
        return take(cone, &b, enters ? side.near : height.near, limit, enters ? side_part : first, intersection) ||
               take(cone, &b, leaves ? side.far : height.far, limit, leaves ? side_part : last, intersection);
    }
    return (enters && take(cone, &b, side.near, limit, ROUND_SIDE, intersection)) ||
           (leaves && take(cone, &b, side.far, limit, ROUND_SIDE, intersection));
}

/* Gives the unit vector from the axis towards the point v, as its components along cone->across. */
static void aside(const struct prepared_cone *cone, struct num_point v, num_unit out[2])
{
    num_unit none;

    (void)num_normalise3(num_point_dot(v, cone->across[0]), num_point_dot(v, cone->across[1]), 0, &out[0], &out[1],
                         &none);
}

/* Returns the gradient of (1), normalised; at an apex, its part along the axis alone. */
static struct num_dir side_normal(const struct prepared_cone *cone, struct num_point point)
{
    num_unit out[2];

    aside(cone, num_point_sub(point, cone->base), out);
    struct num_dir a = num_dir_scaled(cone->across[0], num_times(out[0], cone->slope_cosine));
    struct num_dir b = num_dir_scaled(cone->across[1], num_times(out[1], cone->slope_cosine));
    struct num_dir up = num_dir_scaled(cone->axis, -cone->slope_sine);
    return num_dir_normalised(num_dir_add(num_dir_add(a, b), up));
}

void round_surface(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface)
{
    const struct prepared_cone *cone = &shape->cone;

    if (element == ROUND_SIDE)
        surface->normal = side_normal(cone, point);
    else
        surface->normal = element == ROUND_TOP ? cone->axis : num_dir_negated(cone->axis);
    surface->smooth = surface->normal;
}

/* Gives the surface coordinates of a cap, which are those of a disc, at the point v relative to the base's centre. The
 * normal of the base is the negated axis. This negates U or, if the axis is along y, V. */
static void cap_uv(const struct prepared_cone *cone, struct num_point v, bool is_base, num_length uv[2])
{
    num_length radius = is_base ? cone->base_radius : cone->top_radius;
    num_length right = num_point_dot(v, cone->across[0]), down = num_point_dot(v, cone->across[1]);

    if (is_base && shape_is_upright(cone->axis))
        down = -down;
    else if (is_base)
        right = -right;
    uv[0] = num_ratio(radius + right, 2 * radius);
    uv[1] = num_ratio(radius - down, 2 * radius);
}

void round_uv(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2])
{
    const struct prepared_cone *cone = &shape->cone;
    struct num_point v = num_point_sub(point, cone->base);
    num_unit out[2];

    if (element != ROUND_SIDE) {
        cap_uv(cone, v, element == ROUND_BASE, uv);
        return;
    }
    aside(cone, v, out);
    uv[0] = NUM_LENGTH_ONE / 2 - num_length_of_unit(num_atan2(out[1], out[0]));
    uv[1] = num_ratio(num_point_dot(v, cone->axis), cone->length);
}

/* Sets the anchor, reach and thickness. Lengths are rounded down; 2^-13 is added to reach and thickness, so that no
 * point of the shape is missed. */
static void set_anchor(struct prepared_cone *cone, struct num_point top)
{
    bool at_top = cone->top_radius < cone->base_radius;
    num_length here = at_top ? cone->top_radius : cone->base_radius,
               there = at_top ? cone->base_radius : cone->top_radius;

    cone->anchor = at_top ? top : cone->base;
    cone->anchored = at_top ? cone->length : 0;
    num_length far = num_norm((struct num_point){cone->length, there, 0});
    cone->reach = (far > here ? far : here) + NUM_LENGTH_BIAS;
    cone->thickness = there + NUM_LENGTH_BIAS;
}

struct tia_fine_ends round_fine(const struct tia_scene *scene, const struct tia_shape *given)
{
    static const struct tia_fine_ends none = {0};

    /* members of solids are not among the scene's shapes, and have none */
    size_t i = ((uintptr_t)given - (uintptr_t)scene->shapes) / sizeof *given;

    return scene->fine && !given->transform && i < scene->shape_count ? scene->fine->shapes[i] : none;
}

void round_prepare(struct prepared_cone *cone, const struct round_ends *ends, bool capped)
{
    struct num_point top = num_point_add(num_point_of(ends->top), num_point_fine(ends->fine.top)), along;
    struct num_dir tangents[2];
    num_unit none;

    cone->capped = capped;
    cone->base = num_point_add(num_point_of(ends->base), num_point_fine(ends->fine.base));
    along = num_point_sub(top, cone->base);
    (void)num_normalise(along, &cone->axis);
    shape_tangents(cone->axis, tangents);
    cone->across[0] = tangents[0];
    cone->across[1] = num_dir_negated(tangents[1]);
    cone->length = num_norm(along);
    cone->base_radius = num_length_of(ends->base_radius) + num_fine(ends->fine.base_radius);
    cone->top_radius = num_length_of(ends->top_radius) + num_fine(ends->fine.top_radius);
    (void)num_normalise3(cone->length, cone->top_radius - cone->base_radius, 0, &cone->slope_cosine, &cone->slope_sine,
                         &none);
    set_anchor(cone, top);
}
