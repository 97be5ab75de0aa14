/* triangle.c - watertight triangles, after Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection",
 * JCGT 2013.
 *
 * Relative to the ray's origin, and with the axes turned so that the largest component of D is the last, a
 * corner (x, y, z) is slid along the ray to where it is seen:
 *
 *     x' = x - z Dx/Dz,   y' = y - z Dy/Dz.
 *
 * The ray passes the triangle where the areas that the origin makes with each edge,
 *
 *     a' x b' = ax' by' - ay' bx',
 *
 * do not differ in sign; 0 is of either. Over their sum they are the barycentric coordinates, and t is the mean
 * of the corners' z, weighted with those, over Dz.
 *
 * Why nothing leaks: x' and y' are rounded, but they are made of the corner and the ray alone, so all triangles
 * at a corner see the same, and a b' that is a little off moves all of them. In that slightly moved mesh
 * the decision is exact in q16: 128 bits hold the area. In floating point each of the two products is rounded;
 * rounding keeps their order, so the sign is right or 0, and 0 excludes nothing. Both see the edge from its
 * other end as exactly the negative.
 *
 * How exact t is: x' is within 2^-46 and the error of a slope, 2^-59 |z|. A corner that is aside by e puts the
 * intersection off the plane by e at most, wherever the corners are: no large numbers are subtracted. Areas:
 * corners are nearer to each other than 2^16 in each coordinate, so x' by 2^17, and the sum of the areas stays
 * below 2^34, 2^124 as num_area has it. */
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

/* The components in the order main, next, the one after. */
static void from(int main, num_length x, num_length y, num_length z, num_length v[3])
{
    v[0] = main == 0 ? x : main == 1 ? y : z;
    v[1] = main == 0 ? y : main == 1 ? z : x;
    v[2] = main == 0 ? z : main == 1 ? x : y;
}

static void relative(struct num_point origin, int main, struct tia_vec3 corner, num_length v[3])
{
    struct num_point p = num_point_sub(num_point_of(corner), origin);

    from(main, p.x, p.y, p.z, v);
}

void triangle_ray_prepare(struct triangle_ray *start, const struct ray *ray)
{
    num_unit d[3];

    start->origin = ray->origin;
    start->main = largest(ray->direction);
    from(start->main, ray->direction.x, ray->direction.y, ray->direction.z, d);
    start->along = d[0];
    start->slope[0] = num_fraction(d[1], d[0]);
    start->slope[1] = num_fraction(d[2], d[0]);
}

/* Where a corner is seen: v[0] along the main axis, v[1] and v[2] beside the ray. Not inlined, so that what its
 * products leave on a small processor's stack is gone in deeper calls. */
__attribute__((noinline)) static void seen(const struct triangle_ray *ray, struct tia_vec3 corner, num_length v[3])
{
    relative(ray->origin, ray->main, corner, v);
    v[1] -= num_times(v[0], ray->slope[0]);
    v[2] -= num_times(v[0], ray->slope[1]);
}

/* The areas that the origin makes with the edges: each belongs to the corner that it does not touch. */
static void span_areas(num_length v[3][3], num_area areas[3])
{
    for (int i = 0; i < 3; i++) {
        const num_length *a = v[(i + 1) % 3], *b = v[(i + 2) % 3];
        areas[i] = num_cross2(a[1], a[2], b[1], b[2]);
    }
}

static bool is_inside(const num_area areas[3])
{
    int a = num_area_sign(areas[0]), b = num_area_sign(areas[1]), c = num_area_sign(areas[2]);

    return a * b >= 0 && b * c >= 0 && c * a >= 0 && (a || b || c);
}

/* The product of two edges, exact: corners are 2^33 units of 2^-16 apart at most, so it has up to 67 bits. Returns
 * how many bits its largest component has: 0 where the corners lie on one line. */
static int edge_product(const struct triangle_corners *corners, wide product[3])
{
    struct tia_vec3 a = corners->at[0], b = corners->at[1], c = corners->at[2];
    const int64_t ab[3] = {(int64_t)b.x - a.x, (int64_t)b.y - a.y, (int64_t)b.z - a.z};
    const int64_t ac[3] = {(int64_t)c.x - a.x, (int64_t)c.y - a.y, (int64_t)c.z - a.z};
    int bits = 0;

    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        product[i] = wide_difference(wide_product(ab[j], ac[k]), wide_product(ab[k], ac[j]));
        int length = wide_bits(wide_size(product[i]));
        bits = length > bits ? length : bits;
    }
    return bits;
}

static bool has_area(const struct triangle_corners *corners)
{
    wide product[3];

    return edge_product(corners, product) > 0;
}

bool triangle_intersect(const struct triangle_ray *ray, const struct triangle_corners *corners, num_length limit,
                        num_length *t)
{
    num_length v[3][3];
    num_area areas[3];
    num_unit parts[3];

    for (int i = 0; i < 3; i++)
        seen(ray, corners->at[i], v[i]);
    span_areas(v, areas);
    if (!is_inside(areas))
        return false;
    num_barycentric(areas, parts);
    *t = num_div(num_dot3(v[0][0], v[1][0], v[2][0], parts[0], parts[1], parts[2]), ray->along);
    /* Rounding may give corners on one line an area. */
    return *t >= 0 && *t <= limit && *t < NUM_LENGTH_MAX && has_area(corners);
}

/* In integers, exact but for the last rounding. */
bool triangle_normal(const struct triangle_corners *corners, struct num_dir *normal)
{
    wide product[3];
    int64_t n[3], d[3];
    int bits = edge_product(corners, product);

    for (int i = 0; i < 3; i++)
        n[i] = bits > 61 ? wide_round(product[i], (unsigned)(bits - 61)) : (int64_t)wide_low(product[i]);
    (void)wide_normalise(n, d);
    *normal = (struct num_dir){num_unit_of_q62(d[0]), num_unit_of_q62(d[1]), num_unit_of_q62(d[2])};
    return bits > 0;
}

/* Projected along the normal's main axis; a point that rounding has put outside counts as on the edge. */
void triangle_barycentric(const struct triangle_corners *corners, struct num_dir normal, struct num_point point,
                          num_unit parts[3])
{
    num_length v[3][3];
    num_area areas[3];

    for (int i = 0; i < 3; i++)
        relative(point, largest(normal), corners->at[i], v[i]);
    span_areas(v, areas);
    num_barycentric(areas, parts);
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

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    (void)scene;
    shape->triangle = given->triangle;
}

const struct shape_kind SHAPE_KIND(triangle) = {prepare, intersect, shape_occludes, surface_at, uv_at};
