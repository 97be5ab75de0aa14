/* ring.c - tori and rounded boxes, by their distance functions: a step as long as the distance from the surface never
 * passes through it. Slow, and simple. */
#include "shape.h"

#define STEPS_MAX 100000

struct body {
    struct oracle_vec low, high; /* torus: centre, axis; box: the inner box */
    double major, radius;        /* major: 0 for a box */
};

/* Returns the vector to p from the nearest point of the circle or of the inner box. */
static struct oracle_vec offset(const struct body *b, struct oracle_vec p)
{
    if (b->major > 0) {
        struct oracle_vec v = sub(p, b->low), aside = along(v, -dot(v, b->high), b->high);
        return along(v, -b->major, unit(aside));
    }
    return (struct oracle_vec){p.x - fmin(fmax(p.x, b->low.x), b->high.x), p.y - fmin(fmax(p.y, b->low.y), b->high.y),
                               p.z - fmin(fmax(p.z, b->low.z), b->high.z)};
}

static double depth(const struct body *b, struct ray ray, double t)
{
    return b->radius - length(offset(b, at(ray, t)));
}

/* Walks along a ray of length 1 until the depth changes its sign, from t0 to t1 at most. A step of a millionth of the
 * size, where the distance is less, may jump over a part of the line that is as short. */
static bool walk(const struct body *b, struct ray ray, double t0, double t1, double size, double *t)
{
    bool inside = depth(b, ray, t0) > 0;
    double before = t0, after = t0;

    for (int i = 0; i < STEPS_MAX; i++) {
        after = before + fmax(fabs(depth(b, ray, before)), size * 1e-6);
        if ((depth(b, ray, after) > 0) != inside)
            break;
        before = after;
        if (before > t1)
            return false;
    }
    for (int i = 0; i < 100; i++) {
        double middle = (before + after) / 2;
        if ((depth(b, ray, middle) > 0) == inside)
            before = middle;
        else
            after = middle;
    }
    *t = after;
    return true;
}

/* Finds the nearest hit; all of the body is within `size` of the centre. */
static bool meet(const struct body *b, struct ray ray, struct oracle_vec centre, double size, struct hit *hit)
{
    double scale = length(ray.direction), t;
    struct ray one = {ray.origin, divide(ray.direction, scale)};
    double nearest = dot(sub(centre, ray.origin), one.direction);

    if (nearest < -size || !walk(b, one, fmax(nearest - size, 0), nearest + size, size, &t))
        return false;
    struct oracle_vec n = unit(offset(b, at(one, t)));
    *hit = (struct hit){.t = t / scale, .normal = n, .smooth = n};
    return true;
}

bool shape_torus(struct ray ray, struct oracle_vec centre, struct oracle_vec axis, double major, double minor,
                 struct hit *hit)
{
    const struct body b = {centre, axis, major, minor};
    struct oracle_vec right, up;

    if (!meet(&b, ray, centre, 1.01 * (major + minor), hit))
        return false;
    struct oracle_vec v = sub(at(ray, hit->t), centre);
    tangents(axis, &right, &up);
    double z = dot(v, axis);
    hit->u = 0.5 - atan2(-dot(v, up), dot(v, right)) / (2 * PI);
    hit->v = 0.5 + atan2(z, length(along(v, -z, axis)) - major) / (2 * PI);
    return true;
}

bool shape_rounded(struct ray ray, struct oracle_vec min, struct oracle_vec max, double radius, struct hit *hit)
{
    const struct body b = {
        {min.x + radius, min.y + radius, min.z + radius}, {max.x - radius, max.y - radius, max.z - radius}, 0, radius};
    struct oracle_vec centre = divide(along(min, 1, max), 2), size = sub(max, min);

    if (!meet(&b, ray, centre, 0.51 * length(size), hit))
        return false;
    struct oracle_vec p = at(ray, hit->t), n = hit->normal, v = sub(p, min);
    double x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    double u[3] = {v.x / size.x, v.y / size.y, v.z / size.z};
    if (x >= y && x >= z) {
        hit->u = n.x > 0 ? 1 - u[2] : u[2];
        hit->v = u[1];
    } else if (y >= z) {
        hit->u = u[0];
        hit->v = n.y > 0 ? 1 - u[2] : u[2];
    } else {
        hit->u = n.z > 0 ? u[0] : 1 - u[0];
        hit->v = u[1];
    }
    return true;
}
