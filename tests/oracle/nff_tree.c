/* nff_tree.c - finds the nearest object by a tree of boxes: the larger files have too many objects to test each. */
#include "nff.h"

#include <stdlib.h>

#define FEW 4

static double coordinate(struct oracle_vec v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static int sorted_by; /* axis by which the objects are being sorted */

static int compare(const void *a, const void *b)
{
    const struct nff_thing *s = a, *t = b;
    double d = coordinate(s->min, sorted_by) + coordinate(s->max, sorted_by) - coordinate(t->min, sorted_by) -
               coordinate(t->max, sorted_by);

    return d < 0 ? -1 : d > 0;
}

static void bound(const struct nff *nff, struct nff_tree *tree)
{
    tree->min = nff->things[tree->first].min;
    tree->max = nff->things[tree->first].max;
    for (unsigned i = tree->first; i < tree->first + tree->count; i++) {
        const struct nff_thing *t = &nff->things[i];
        tree->min =
            (struct oracle_vec){fmin(tree->min.x, t->min.x), fmin(tree->min.y, t->min.y), fmin(tree->min.z, t->min.z)};
        tree->max =
            (struct oracle_vec){fmax(tree->max.x, t->max.x), fmax(tree->max.y, t->max.y), fmax(tree->max.z, t->max.z)};
    }
}

static void halve(struct nff *nff, unsigned first, unsigned count)
{
    struct nff_tree *tree = &nff->trees[nff->tree_count++];
    struct oracle_vec size;

    *tree = (struct nff_tree){.first = first, .count = count};
    bound(nff, tree);
    if (count <= FEW)
        return;
    size = sub(tree->max, tree->min);
    sorted_by = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    qsort(nff->things + first, count, sizeof *nff->things, compare);
    tree->count = 0;
    halve(nff, first, count / 2);
    tree->first = nff->tree_count;
    halve(nff, first + count / 2, count - count / 2);
}

void nff_plant(struct nff *nff)
{
    nff->trees = calloc(2 * (size_t)nff->thing_count + 1, sizeof *nff->trees);
    nff->tree_count = 0;
    if (nff->thing_count)
        halve(nff, 0, nff->thing_count);
}

/* True if the ray meets the box anywhere in 0..limit. The interval is enlarged a little for rounding errors. */
static bool meets(const struct nff_tree *tree, struct ray ray, double limit)
{
    double from = 0, to = limit;

    for (int i = 0; i < 3; i++) {
        double o = coordinate(ray.origin, i), d = coordinate(ray.direction, i);
        double a = (coordinate(tree->min, i) - o) / d, b = (coordinate(tree->max, i) - o) / d;
        from = fmax(from, fmin(a, b) * (1 - 1e-12)); /* fmin and fmax ignore NaN, 0/0 */
        to = fmin(to, fmax(a, b) * (1 + 1e-12));
    }
    return from <= to;
}

/* True if a point of the polygon's plane is inside the polygon: an odd number of edges crosses the line from the point
 * to the left. */
static bool is_inside(const struct nff_thing *t, struct oracle_vec p)
{
    double x = fabs(t->normal.x), y = fabs(t->normal.y), z = fabs(t->normal.z);
    int u = x >= y && x >= z ? 1 : 0, v = z > x && z > y ? 1 : 2;
    bool inside = false;

    for (unsigned i = 0; i < t->count; i++) {
        struct oracle_vec a = t->corner[i], b = t->corner[(i + 1) % t->count];
        double av = coordinate(a, v), bv = coordinate(b, v), pv = coordinate(p, v);
        if ((av > pv) == (bv > pv))
            continue;
        double at = coordinate(a, u) + (coordinate(b, u) - coordinate(a, u)) * (pv - av) / (bv - av);
        inside ^= coordinate(p, u) < at;
    }
    return inside;
}

/* Returns the normal at a point of a triangle that has normals at its corners, by barycentric coordinates. */
static struct oracle_vec smooth(const struct nff_thing *t, struct oracle_vec p)
{
    struct oracle_vec e1 = sub(t->corner[1], t->corner[0]), e2 = sub(t->corner[2], t->corner[0]), n = cross(e1, e2);
    struct oracle_vec q = sub(p, t->corner[0]);
    double u = dot(cross(q, e2), n) / dot(n, n), v = dot(cross(e1, q), n) / dot(n, n);

    return unit(along(along(scaled(t->normals[0], 1 - u - v), u, t->normals[1]), v, t->normals[2]));
}

static bool polygon_hit(const struct nff_thing *t, struct ray ray, struct hit *hit)
{
    if (!shape_plane(ray, t->corner[0], t->normal, hit) || !is_inside(t, at(ray, hit->t)))
        return false;
    if (t->normals)
        hit->smooth = smooth(t, at(ray, hit->t));
    return true;
}

static bool thing_hit(const struct nff_thing *t, struct ray ray, struct hit *hit)
{
    switch (t->kind) {
    case NFF_SPHERE:
        return shape_sphere(ray, t->point[0], t->radius[0], hit);
    case NFF_CONE:
        return shape_cone(ray, t->point[0], t->point[1], t->radius[0], t->radius[1], false, hit);
    default:
        return polygon_hit(t, ray, hit);
    }
}

static void search(const struct nff *nff, unsigned at, struct ray ray, unsigned *nearest, struct hit *hit)
{
    const struct nff_tree *tree = &nff->trees[at];
    struct hit h;

    if (!meets(tree, ray, hit->t))
        return;
    if (!tree->count) {
        search(nff, at + 1, ray, nearest, hit);
        search(nff, tree->first, ray, nearest, hit);
    }
    for (unsigned i = tree->first; i < tree->first + tree->count; i++)
        if (thing_hit(&nff->things[i], ray, &h) && h.t < hit->t) {
            *nearest = i;
            *hit = h;
        }
}

unsigned nff_nearest(const struct nff *nff, struct ray ray, struct hit *hit)
{
    unsigned nearest = nff->thing_count;

    *hit = (struct hit){.t = INFINITY};
    if (nff->tree_count)
        search(nff, 0, ray, &nearest, hit);
    return nearest;
}

static double pass(const struct nff *nff, unsigned at, struct ray ray)
{
    const struct nff_tree *tree = &nff->trees[at];
    double left = 1;
    struct hit h;

    if (!meets(tree, ray, 1))
        return 1;
    if (!tree->count) {
        left = pass(nff, at + 1, ray);
        return left > 0 ? left * pass(nff, tree->first, ray) : 0;
    }
    for (unsigned i = tree->first; i < tree->first + tree->count && left > 0; i++)
        if (thing_hit(&nff->things[i], ray, &h) && h.t < 1)
            left *= nff->materials[nff->things[i].material].t;
    return left;
}

double nff_transmission(const struct nff *nff, struct ray ray)
{
    return nff->tree_count ? pass(nff, 0, ray) : 1;
}
