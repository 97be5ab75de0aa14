/* round.c - spheres, discs, cylinders and cones. */
#include "shape.h"

/* Returns 1/2 - atan2(z, x)/(2 pi). */
static double turn(double z, double x)
{
    return 0.5 - atan2(z, x) / (2.0 * PI);
}

bool shape_sphere(struct ray ray, struct oracle_vec centre, double radius, struct hit *hit)
{
    double scale = length(ray.direction);
    struct oracle_vec d = divide(ray.direction, scale), l = sub(centre, ray.origin);
    double tca = dot(l, d);
    struct oracle_vec perpendicular = along(l, -tca, d);
    double thc = sqrt(radius * radius - dot(perpendicular, perpendicular));
    double t = tca - thc >= 0 ? tca - thc : tca + thc;

    if (!(t >= 0)) /* NaN when the root is imaginary */
        return false;
    struct oracle_vec p = sub(along(ray.origin, t, d), centre), n = unit(p);
    double cosine = p.y / radius;
    *hit = (struct hit){.t = t / scale, .normal = n, .smooth = n, .u = turn(p.z, p.x)};
    hit->v = 1 - acos(cosine > 1 ? 1 : cosine < -1 ? -1 : cosine) / PI;
    return true;
}

bool shape_plane(struct ray ray, struct oracle_vec point, struct oracle_vec normal, struct hit *hit)
{
    double slope = dot(ray.direction, normal), t = dot(sub(point, ray.origin), normal) / slope;
    struct oracle_vec right, up;

    if (!(t >= 0) || isinf(t))
        return false;
    struct oracle_vec p = sub(at(ray, t), point);
    tangents(normal, &right, &up);
    *hit = (struct hit){.t = t, .normal = normal, .smooth = normal, .u = dot(p, right), .v = dot(p, up)};
    return true;
}

bool shape_disc(struct ray ray, struct oracle_vec centre, struct oracle_vec normal, double radius, struct hit *hit)
{
    if (!shape_plane(ray, centre, normal, hit) || length(sub(at(ray, hit->t), centre)) > radius)
        return false;
    hit->u = 0.5 + hit->u / (2 * radius);
    hit->v = 0.5 + hit->v / (2 * radius);
    return true;
}

/* The side of a frustum: |p - (p.axis) axis| = base_radius + slope p.axis, 0 <= p.axis <= height, p relative to `base`.
 */
struct side {
    struct oracle_vec base, axis;
    double height, base_radius, slope;
};

/* Computes the real roots of a t^2 + 2 b t + c, the smaller first, without cancellation. Returns their number, 0 or
 * 2. */
static int roots(double a, double b, double c, double t[2])
{
    double discriminant = b * b - a * c;

    if (discriminant < 0 || (a == 0 && b == 0))
        return 0;
    double q = -(b + copysign(sqrt(discriminant), b));
    t[0] = q == 0 ? 0 : c / q;
    t[1] = a == 0 ? t[0] : q / a;
    if (t[0] > t[1]) {
        double swap = t[0];
        t[0] = t[1];
        t[1] = swap;
    }
    return 2;
}

/* Computes the hit at t. Returns false if it is not on the side. */
static bool on_side(const struct side *side, struct ray ray, double t, struct hit *hit)
{
    struct oracle_vec p = sub(at(ray, t), side->base), u, v;
    double rise = dot(p, side->axis);

    if (!(t >= 0) || rise < 0 || rise > side->height)
        return false;
    struct oracle_vec out = along(p, -rise, side->axis);
    if (length(out) > 0)
        out = unit(out);
    tangents(side->axis, &u, &v);
    hit->t = t;
    hit->normal = hit->smooth = unit(along(out, -side->slope, side->axis));
    hit->u = turn(-dot(p, v), dot(p, u));
    hit->v = rise / side->height;
    return true;
}

/* Intersects the side. The equation is relative to the ray's point nearest to the base, which keeps the coefficients
 * small. */
static bool side_hit(const struct side *side, struct ray ray, struct hit *hit)
{
    struct oracle_vec d = ray.direction;
    double shift = dot(sub(side->base, ray.origin), d) / dot(d, d), t[2];
    struct oracle_vec o = sub(at(ray, shift), side->base);
    double d_axis = dot(d, side->axis), o_axis = dot(o, side->axis);
    struct oracle_vec d_out = along(d, -d_axis, side->axis), o_out = along(o, -o_axis, side->axis);
    double radius = side->base_radius + side->slope * o_axis, grows = side->slope * d_axis;
    int count = roots(dot(d_out, d_out) - grows * grows, dot(o_out, d_out) - radius * grows,
                      dot(o_out, o_out) - radius * radius, t);

    for (int i = 0; i < count; i++)
        if (on_side(side, ray, shift + t[i], hit))
            return true;
    return false;
}

/* Intersects a cap, a disc with an outward normal. There is none if the radius is 0. */
static bool cap_hit(struct ray ray, struct oracle_vec centre, struct oracle_vec outwards, double radius,
                    struct hit *hit)
{
    return radius > 0 && shape_disc(ray, centre, outwards, radius, hit);
}

bool shape_cone(struct ray ray, struct oracle_vec base, struct oracle_vec top, double base_radius, double top_radius,
                bool capped, struct hit *hit)
{
    struct side side = {.base = base, .axis = unit(sub(top, base)), .height = length(sub(top, base))};
    struct hit found[3] = {{0}};
    bool met[3] = {false};
    int nearest = -1;

    side.base_radius = base_radius;
    side.slope = (top_radius - base_radius) / side.height;
    met[0] = side_hit(&side, ray, &found[0]);
    met[1] = capped && cap_hit(ray, base, scaled(side.axis, -1), base_radius, &found[1]);
    met[2] = capped && cap_hit(ray, top, side.axis, top_radius, &found[2]);
    for (int i = 0; i < 3; i++)
        if (met[i] && (nearest < 0 || found[i].t < found[nearest].t))
            nearest = i;
    if (nearest < 0)
        return false;
    *hit = found[nearest];
    hit->part = (uint32_t)nearest;
    return true;
}
