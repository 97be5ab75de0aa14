#include "radio.h"

#include <math.h>

struct search {
    const struct oracle_polygon *polygons;
    int count, order, most, found;
    const double *from, *to;
    double doubt;
    int chosen[ORACLE_ORDER];
    struct oracle_path *paths;
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void minus(const double a[3], const double b[3], double c[3])
{
    for (int k = 0; k < 3; k++)
        c[k] = a[k] - b[k];
}

static void cross(const double a[3], const double b[3], double c[3])
{
    for (int k = 0; k < 3; k++)
        c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static void normal_of(const struct oracle_polygon *p, double n[3])
{
    double a[3], b[3];

    minus(p->corner[1], p->corner[0], a);
    minus(p->corner[2], p->corner[0], b);
    cross(a, b, n);
    double length = sqrt(dot(n, n));
    for (int k = 0; k < 3; k++)
        n[k] /= length;
}

static double height(const struct oracle_polygon *p, const double at[3])
{
    double n[3], d[3];

    normal_of(p, n);
    minus(at, p->corner[0], d);
    return dot(n, d);
}

/* Returns the distance of a point in the polygon's plane from the nearest edge; it is negative outside the polygon. */
static double depth(const struct oracle_polygon *p, const double at[3])
{
    double n[3], least = INFINITY;

    normal_of(p, n);
    for (int i = 0; i < p->count; i++) {
        double edge[3], to[3], c[3];
        minus(p->corner[(i + 1) % p->count], p->corner[i], edge);
        minus(at, p->corner[i], to);
        cross(edge, to, c);
        least = fmin(least, dot(c, n) / sqrt(dot(edge, edge)));
    }
    return least;
}

/* True if x, which has an error of up to `doubt`, may be above 0. Clears *sure if |x| is not above `doubt`. */
static bool holds(const struct search *s, double x, bool *sure)
{
    *sure &= fabs(x) > s->doubt;
    return x > -s->doubt;
}

/* True if a polygon is between two points that are not on it. Clears *sure if that is uncertain. */
static bool blocks(const struct search *s, const struct oracle_polygon *p, const double a[3], const double b[3],
                   bool *sure)
{
    double ha = height(p, a), hb = height(p, b), at[3];

    if (fabs(ha) < s->doubt || fabs(hb) < s->doubt) {
        double nearer = fmin(fabs(ha), fabs(hb)) == fabs(ha) ? depth(p, a) : depth(p, b);
        *sure &= nearer < -s->doubt; /* an end point is in the plane, and perhaps on the polygon */
        return false;
    }
    if (ha * hb > 0)
        return false;
    for (int k = 0; k < 3; k++)
        at[k] = a[k] + ha / (ha - hb) * (b[k] - a[k]);
    double d = depth(p, at);
    *sure &= fabs(d) > s->doubt;
    return d > s->doubt;
}

static bool is_clear(const struct search *s, const double a[3], const double b[3], int first, int last, bool *sure)
{
    for (int i = 0; i < s->count; i++)
        if (i != first && i != last && blocks(s, &s->polygons[i], a, b, sure))
            return false;
    return true;
}

static void mirror(const struct oracle_polygon *p, const double a[3], double out[3])
{
    double n[3], h = height(p, a);

    normal_of(p, n);
    for (int k = 0; k < 3; k++)
        out[k] = a[k] - 2 * h * n[k];
}

static void try_sequence(struct search *s, int order)
{
    double images[ORACLE_ORDER + 1][3], at[3], length = 0;
    struct oracle_path path = {.order = order, .sure = true};

    for (int k = 0; k < 3; k++) {
        images[order][k] = s->to[k];
        at[k] = s->from[k];
    }
    for (int i = order - 1; i >= 0; i--)
        mirror(&s->polygons[s->chosen[i]], images[i + 1], images[i]);
    for (int i = 0; i < order; i++) {
        const struct oracle_polygon *p = &s->polygons[s->chosen[i]];
        double ha = height(p, at), hb = height(p, images[i]), step[3];
        if (!holds(s, -ha * hb, &path.sure) || (p->solid && !holds(s, ha, &path.sure)) || fabs(ha - hb) < s->doubt)
            return;
        for (int k = 0; k < 3; k++)
            path.point[i][k] = at[k] + ha / (ha - hb) * (images[i][k] - at[k]);
        if (!holds(s, depth(p, path.point[i]), &path.sure) ||
            !is_clear(s, at, path.point[i], i > 0 ? s->chosen[i - 1] : -1, s->chosen[i], &path.sure))
            return;
        minus(path.point[i], at, step);
        length += sqrt(dot(step, step));
        for (int k = 0; k < 3; k++)
            at[k] = path.point[i][k];
    }
    if (!is_clear(s, at, s->to, order > 0 ? s->chosen[order - 1] : -1, -1, &path.sure))
        return;
    double last[3];
    minus(s->to, at, last);
    path.length = length + sqrt(dot(last, last));
    if (s->found < s->most)
        s->paths[s->found] = path;
    s->found++;
}

int oracle_radio(const struct oracle_polygon *polygons, int count, const double from[3], const double to[3], int order,
                 double doubt, struct oracle_path *paths, int most)
{
    struct search s = {
        .polygons = polygons, .count = count, .most = most, .from = from, .to = to, .doubt = doubt, .paths = paths};

    for (int length = 0; length <= order; length++) {
        long sequences = (long)pow(count, length);
        for (long number = 0; number < sequences; number++) {
            long rest = number;
            bool repeats = false;
            for (int i = 0; i < length; i++, rest /= count) {
                s.chosen[i] = (int)(rest % count);
                repeats |= i > 0 && s.chosen[i] == s.chosen[i - 1];
            }
            if (!repeats)
                try_sequence(&s, length);
        }
    }
    return s.found;
}
