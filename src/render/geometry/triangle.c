/* triangle.c - watertight triangles, after Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2013.
 *
 * Relative to the ray's origin, and with the axes turned so that the largest component of D is the last, a corner (x,
 * y, z) is projected along the ray:
 *
 *     x' = x - z Dx/Dz,   y' = y - z Dy/Dz.
 *
 * The ray passes through the triangle if the areas that the origin forms with the edges,
 *
 *     a' x b' = ax' by' - ay' bx',
 *
 * do not differ in sign; 0 counts as either sign. Divided by their sum, the areas are the barycentric coordinates, and
 * t is the mean of the corners' z, weighted by these coordinates, divided by Dz.
 *
 * The test is watertight. x' and y' are rounded, but they depend on the corner and the ray alone, so all triangles at a
 * corner use the same values, and an error of b' moves the corner in all of them. In that slightly moved mesh the
 * decision is exact in q16: 128 bits hold the area. In floating point, each of the two products is rounded. Rounding
 * keeps their order, so the sign is right or 0, and an area of 0 excludes no triangle. An edge in the opposite
 * direction has exactly the negated area.
 *
 * Error of t: x' is off by 2^-46, and by 2^-59 |z| for the slope. A corner displaced by e displaces the intersection
 * from the plane by e at most, wherever the corners are, since no large numbers are subtracted. Range of the areas: two
 * corners differ by less than 2^16 in each coordinate, and so by less than 2^17 in x'; the sum of the areas stays below
 * 2^34, or 2^124 units of num_area. */
#include "triangle.h"

#include "math/wide.h"

static num_unit size(num_unit d)
{
    return d < 0 ? -d : d;
}

static int largest(struct num_dir d)
{
    num_unit x = size(d.x), y = size(d.y), z = size(d.z);

    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/* Gives the point's components in the order of the main axis, the next axis, and the one after that. */
static void turn(int axis, struct num_point p, num_length v[3])
{
    v[0] = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    v[1] = axis == 0 ? p.y : axis == 1 ? p.z : p.x;
    v[2] = axis == 0 ? p.z : axis == 1 ? p.x : p.y;
}

static void relative(struct num_point origin, int axis, struct tia_vec3 corner, num_length v[3])
{
    turn(axis, num_point_sub(num_point_of(corner), origin), v);
}

void triangle_ray_prepare(struct triangle_ray *start, const struct ray *ray)
{
    const struct num_dir *d = &ray->direction;
    int axis = largest(*d);

    start->main = axis;
    turn(axis, ray->origin, start->origin);
    start->along = num_divisor_of(axis == 0 ? d->x : axis == 1 ? d->y : d->z);
    start->slope[0] = num_fraction_by(axis == 0 ? d->y : axis == 1 ? d->z : d->x, start->along);
    start->slope[1] = num_fraction_by(axis == 0 ? d->z : axis == 1 ? d->x : d->y, start->along);
}

/* Gives the corners' coordinates, relative to the ray's origin, along the axis `step` places after the main axis. */
static void corners_along(const struct triangle_ray *ray, const struct triangle_corners *corners, int step,
                          num_length v[3])
{
    int axis = ray->main + step;

    axis = axis > 2 ? axis - 3 : axis;
    for (int i = 0; i < 3; i++) {
        const struct tia_vec3 *c = &corners->at[i];
        v[i] = num_length_of(axis == 0 ? c->x : axis == 1 ? c->y : c->z) - ray->origin[step];
    }
}

/* Gives the coordinates of the projected corners along the axis `step` places after the main axis. Not inlined, so that
 * the temporaries of its products take no stack of a small processor during deeper calls. */
__attribute__((noinline)) static void seen(const struct triangle_ray *ray, const struct triangle_corners *corners,
                                           int step, const num_length ahead[3], num_length v[3])
{
    corners_along(ray, corners, step, v);
    for (int i = 0; i < 3; i++)
        v[i] -= num_times(ahead[i], ray->slope[step - 1]);
}

/* True if all projected corners are strictly on one side of the ray. In this case some areas differ in sign, or all are
 * 0. */
static bool is_beside(const num_length v[3])
{
    return (v[0] > 0 && v[1] > 0 && v[2] > 0) || (v[0] < 0 && v[1] < 0 && v[2] < 0);
}

/* Returns the area of the triangle of the origin and the edge that does not touch corner i. */
static num_area span_area(const num_length x[3], const num_length y[3], int i)
{
    int a = i < 2 ? i + 1 : 0, b = i > 0 ? i - 1 : 2;

    return num_cross2(x[a], y[a], x[b], y[b]);
}

/* True if the ray passes through the triangle: no two areas differ in sign, and not all are 0. The third area is
 * computed only if the first two do not differ in sign. */
static bool is_inside(const num_length x[3], const num_length y[3], num_area areas[3])
{
    areas[0] = span_area(x, y, 0);
    areas[1] = span_area(x, y, 1);
    int a = num_area_sign(areas[0]), b = num_area_sign(areas[1]);

    if (a * b < 0)
        return false;
    areas[2] = span_area(x, y, 2);
    int c = num_area_sign(areas[2]);
    return b * c >= 0 && c * a >= 0 && (a || b || c);
}

/* The edges from the first corner, in units of 2^-16, each shorter than 2^33. */
struct edges {
    int64_t ab[3], ac[3];
};

static struct edges edges_of(const struct triangle_corners *corners)
{
    struct tia_vec3 a = corners->at[0], b = corners->at[1], c = corners->at[2];

    return (struct edges){{(int64_t)b.x - a.x, (int64_t)b.y - a.y, (int64_t)b.z - a.z},
                          {(int64_t)c.x - a.x, (int64_t)c.y - a.y, (int64_t)c.z - a.z}};
}

/* Returns the component of the edges' cross product along the axis before axis j. It is exact, with up to 67 bits. */
static wide edge_product(const struct edges *e, int j)
{
    int k = j < 2 ? j + 1 : 0;

    return wide_difference(wide_product(e->ab[j], e->ac[k]), wide_product(e->ab[k], e->ac[j]));
}

/* True if the corners do not lie on one line. */
static bool has_area(const struct triangle_corners *corners)
{
    struct edges edges = edges_of(corners);

    for (int j = 0; j < 3; j++)
        if (wide_sign(edge_product(&edges, j)))
            return true;
    return false;
}

bool triangle_intersect(const struct triangle_ray *ray, const struct triangle_corners *corners, num_length limit,
                        num_length *t)
{
    num_length ahead[3], x[3], y[3];
    num_area areas[3];
    num_unit parts[3];

    corners_along(ray, corners, 0, ahead);
    seen(ray, corners, 1, ahead, x);
    if (is_beside(x))
        return false;
    seen(ray, corners, 2, ahead, y);
    if (is_beside(y) || !is_inside(x, y, areas))
        return false;
    num_barycentric(areas, parts);
    *t = num_div_by(num_dot3(ahead[0], ahead[1], ahead[2], parts[0], parts[1], parts[2]), ray->along);
    /* rounding may give corners on one line an area */
    return *t >= 0 && *t <= limit && *t < NUM_LENGTH_MAX && has_area(corners);
}

/* Gives the normal. Only the last step rounds; all others are exact. */
bool triangle_normal(const struct triangle_corners *corners, struct num_dir *normal)
{
    struct edges edges = edges_of(corners);
    wide product[3];
    int64_t n[3], d[3];
    int bits = 0;

    for (int i = 0; i < 3; i++) {
        product[i] = edge_product(&edges, i < 2 ? i + 1 : 0);
        int length = wide_bits(wide_size(product[i]));
        bits = length > bits ? length : bits;
    }
    for (int i = 0; i < 3; i++)
        n[i] = bits > 61 ? wide_round(product[i], (unsigned)(bits - 61)) : (int64_t)wide_low(product[i]);
    (void)wide_normalise(n, d);
    *normal = (struct num_dir){num_unit_of_q62(d[0]), num_unit_of_q62(d[1]), num_unit_of_q62(d[2])};
    return bits > 0;
}

/* Gives the barycentric coordinates in the projection along the normal's main axis; a point that rounding has moved
 * outside counts as on the edge. */
void triangle_barycentric(const struct triangle_corners *corners, struct num_dir normal, struct num_point point,
                          num_unit parts[3])
{
    num_length v[3], x[3], y[3];
    num_area areas[3];

    for (int i = 0; i < 3; i++) {
        relative(point, largest(normal), corners->at[i], v);
        x[i] = v[1];
        y[i] = v[2];
    }
    for (int i = 0; i < 3; i++)
        areas[i] = span_area(x, y, i);
    num_barycentric(areas, parts);
}

static num_length cross(const num_length a[2], const num_length b[2])
{
    return num_product(a[0], b[1]) - num_product(a[1], b[0]);
}

static num_length longest(num_length v[2][2])
{
    num_length most = 0;

    for (int i = 0; i < 4; i++) {
        num_length x = v[i / 2][i % 2] < 0 ? -v[i / 2][i % 2] : v[i / 2][i % 2];
        most = x > most ? x : most;
    }
    return most;
}

/* Gives the projection of a vector and of the edges from the first corner along the normal's main axis, all scaled by a
 * power of two, by which the edges' largest component becomes 1/2..1. The vector's is below 2^16. */
static void flatten(const struct triangle_corners *corners, struct num_dir normal, struct num_point vector,
                    num_length edge[2][2], num_length v[2])
{
    const struct num_point from = num_point_of(corners->at[0]);
    num_length turned[3];

    turn(largest(normal), vector, turned);
    for (int k = 0; k < 2; k++)
        v[k] = turned[k + 1];
    for (int i = 0; i < 2; i++) {
        relative(from, largest(normal), corners->at[i + 1], turned);
        for (int k = 0; k < 2; k++)
            edge[i][k] = turned[k + 1];
    }
    for (; longest(edge) > NUM_LENGTH_ONE; v[0] /= 2, v[1] /= 2)
        for (int i = 0; i < 4; i++)
            edge[i / 2][i % 2] /= 2;
    for (; longest(edge) > 0 && longest(edge) < NUM_LENGTH_ONE / 2; v[0] *= 2, v[1] *= 2)
        for (int i = 0; i < 4; i++)
            edge[i / 2][i % 2] *= 2;
}

/* With the edges b and c from the first corner, projected along the normal's main axis, the vector is p b + q c, where
 * p = (v x c)/(b x c) and q = (b x v)/(b x c). */
void triangle_change(const struct triangle_corners *corners, struct num_dir normal, struct num_point vector,
                     num_length parts[2])
{
    const num_length most = 4096 * NUM_LENGTH_ONE;
    num_length edge[2][2], v[2];

    flatten(corners, normal, vector, edge, v);
    num_length area = cross(edge[0], edge[1]);
    parts[0] = parts[1] = 0;
    if (area == 0)
        return;
    parts[0] = num_length_clamp(num_ratio(cross(v, edge[1]), area), -most, most);
    parts[1] = num_length_clamp(num_ratio(cross(edge[0], v), area), -most, most);
}

static struct triangle_corners corners_of(const struct shape *shape)
{
    const struct tia_vec3 *corner = shape->triangle.corner;

    return (struct triangle_corners){{corner[0], corner[1], corner[2]}};
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection)
{
    struct triangle_corners corners = corners_of(shape);
    struct triangle_ray start;

    triangle_ray_prepare(&start, ray);
    intersection->element = 0;
    return triangle_intersect(&start, &corners, limit, &intersection->t);
}

static void surface_at(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface)
{
    struct triangle_corners corners = corners_of(shape);

    (void)point;
    (void)element;
    (void)triangle_normal(&corners, &surface->normal);
    surface->smooth = surface->normal;
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2])
{
    struct triangle_corners corners = corners_of(shape);
    struct num_dir normal;
    num_unit parts[3];

    (void)element;
    (void)triangle_normal(&corners, &normal);
    triangle_barycentric(&corners, normal, point, parts);
    uv[0] = num_length_of_unit(parts[1]);
    uv[1] = num_length_of_unit(parts[2]);
}

void triangle_uv_change(const struct shape *shape, uint32_t element, struct num_point vector, num_length uv[2])
{
    struct triangle_corners corners = corners_of(shape);
    struct num_dir normal;

    (void)element;
    (void)triangle_normal(&corners, &normal);
    triangle_change(&corners, normal, vector, uv);
}

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    (void)scene;
    shape->triangle = given->triangle;
}

const struct shape_kind SHAPE_KIND(triangle) = {prepare, intersect, shape_occludes, surface_at, uv_at, NULL};
