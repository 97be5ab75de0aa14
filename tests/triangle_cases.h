/* triangle_cases.h - tests src/render/geometry/triangle.c, in the arithmetic for which it is compiled, against long
 * doubles. */
#include "math/wide.h"
#include "ray_cases.h"
#include "render/geometry/triangle.h"

/* Bound of the error of coordinates up to `size`. */
#ifdef TIA_NUM_F64
#define ERROR(size) (8 * 0x1p-52L * (size))
#else
#define ERROR(size) (4 * 0x1p-45L + 8 * 0x1p-59L * (size))
#endif

struct wanted {
    long double t, facing; /* facing: |N.D| */
    long double aside;     /* distance of the ray from the nearest edge, negative outside the triangle */
    long double parts[3];
};

static bool is_flat(const struct triangle_corners *c)
{
    int64_t a[3] = {c->at[1].x - (int64_t)c->at[0].x, c->at[1].y - (int64_t)c->at[0].y,
                    c->at[1].z - (int64_t)c->at[0].z};
    int64_t b[3] = {c->at[2].x - (int64_t)c->at[0].x, c->at[2].y - (int64_t)c->at[0].y,
                    c->at[2].z - (int64_t)c->at[0].z};

    for (int i = 0; i < 3; i++) {
        int k = (i + 1) % 3;
        wide off = wide_difference(wide_product(a[i], b[k]), wide_product(a[k], b[i]));
        if (wide_high(off) || wide_low(off))
            return false;
    }
    return true;
}

/* Intersects the triangle's plane by its equation, and tests the edges by D.(A x B). */
static struct wanted meet(const struct triangle_corners *c, const struct ray *ray)
{
    real3 o = real3_of(ray->origin), d = real3_dir(ray->direction), v[3];
    struct wanted w = {.aside = INFINITY};
    long double areas[3], sum = 0;

    for (int i = 0; i < 3; i++)
        v[i] = minus(real3_vec(c->at[i]), o);
    real3 n = cross(minus(v[1], v[0]), minus(v[2], v[0]));
    w.facing = fabsl(dot(n, d)) / length(n);
    w.t = dot(n, v[0]) / dot(n, d);
    for (int i = 0; i < 3; i++) {
        real3 a = v[(i + 1) % 3], edge = minus(v[(i + 2) % 3], a);
        areas[i] = dot(d, cross(a, edge));
        long double seen = length(cross(d, edge));
        long double aside = areas[i] / seen * (dot(n, d) < 0 ? -1 : 1);
        w.aside = aside < w.aside ? aside : w.aside;
        sum += areas[i];
    }
    for (int i = 0; i < 3; i++)
        w.parts[i] = areas[i] / sum;
    return w;
}

/* Returns a point of the triangle's plane, inside the triangle or beside it. */
static real3 point_near(const struct triangle_corners *c)
{
    long double u = (random_real() + 0.8L) / 1.4L, v = (random_real() + 0.8L) / 1.4L;
    real3 a = real3_vec(c->at[0]), b = real3_vec(c->at[1]), d = real3_vec(c->at[2]);

    return plus(plus(a, minus(b, a), u), minus(d, a), v);
}

static void check_ray(const struct triangle_corners *c, const struct ray *ray, long double limit, unsigned hits[2])
{
    struct triangle_ray start;
    struct wanted w = meet(c, ray);
    real3 o = real3_of(ray->origin);
    long double size = fabsl(o.x) + fabsl(o.y) + fabsl(o.z), error;
    num_length t = 0;

    for (int i = 0; i < 3; i++)
        size += length(real3_vec(c->at[i]));
    error = ERROR(size);
    if (w.facing < 1e-6L || fabsl(w.aside) < error || fabsl(w.t) * w.facing < error ||
        fabsl(w.t - limit) * w.facing < error)
        return;
    triangle_ray_prepare(&start, ray);
    bool met = triangle_intersect(&start, c, num_of(limit), &t), wanted = w.aside > 0 && w.t > 0 && w.t <= limit;
    CHECK_MSG(met == wanted, "%d, not %d: aside by %Lg, t %Lg", met, wanted, w.aside, w.t);
    hits[wanted]++;
    if (met && wanted)
        CHECK_MSG(fabsl(real_of(t) - w.t) * w.facing < error, "off the plane by %Lg, not %Lg; t %Lg",
                  (real_of(t) - w.t) * w.facing, error, w.t);
}

/* Checks triangles from all directions. Their edges are about `size` long, and their centres up to `far` away. */
static void check_size(long double size, long double far, unsigned hits[2])
{
    for (int i = 0; i < 3000; i++) {
        struct tia_vec3 centre = random_vec(far);
        struct triangle_corners c;
        for (int k = 0; k < 3; k++) {
            struct tia_vec3 aside = random_vec(size);
            c.at[k] = (struct tia_vec3){centre.x + aside.x, centre.y + aside.y, centre.z + aside.z};
        }
        if (is_flat(&c))
            continue;
        long double away = powl(2, 16 * (random_real() - 0.5L)) * size;
        real3 from = plus(real3_vec(centre), random_real3(1), away < 32000 ? away : 32000);
        struct ray ray = ray_towards(from, point_near(&c));
        check_ray(&c, &ray, 30000, hits);
    }
}

TEST(triangles_are_met_where_they_are)
{
    static const long double sizes[] = {0x1p-10L, 0x1p-8L, 0.1L, 1, 30, 1000, 15000};
    unsigned hits[2] = {0, 0};

    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        check_size(sizes[i], 0, hits);
        check_size(sizes[i], 30000 - sizes[i], hits);
    }
    CHECK_MSG(hits[0] > 4000 && hits[1] > 4000, "%u missed, %u met", hits[0], hits[1]);
}

/* The largest possible floor, which surrounds the world, is hit a short way in front of the eye. */
TEST(a_floor_as_large_as_the_world_is_met_nearby)
{
    struct triangle_corners c = {{{-TIA_Q16(30000), 12345, -TIA_Q16(30000)},
                                  {TIA_Q16(30000), -4321, -TIA_Q16(29000)},
                                  {TIA_Q16(1000), 77777, TIA_Q16(30000)}}};
    unsigned hits[2] = {0, 0};

    for (int i = 0; i < 3000; i++) {
        struct ray ray = ray_towards(plus((real3){0, 1, 0}, random_real3(1), 4), random_real3(1));
        check_ray(&c, &ray, 30000, hits);
    }
    CHECK(hits[1] > 500);
}

TEST(normals_are_exact_and_lines_have_none)
{
    for (int i = 0; i < 20000; i++) {
        long double size = powl(2, 14.9L - (long double)(random_bits() % 30));
        struct triangle_corners c = {{random_vec(size), random_vec(size), random_vec(size)}};
        struct num_dir got;
        bool any = triangle_normal(&c, &got);
        CHECK_EQ(any, !is_flat(&c));
        real3 a = real3_vec(c.at[0]), n = cross(minus(real3_vec(c.at[1]), a), minus(real3_vec(c.at[2]), a));
        if (any && length(n) > size * size * 1e-3L) /* otherwise long doubles cancel */
            CHECK(length(minus(real3_dir(got), plus((real3){0, 0, 0}, n, 1 / length(n)))) < 0x1p-50L);
    }
}

TEST(corners_on_one_line_are_never_met)
{
    for (int i = 0; i < 20000; i++) {
        struct tia_vec3 a = random_vec(3), s = random_vec(2);
        int32_t k = 1 + (int32_t)(random_bits() % 7), l = (int32_t)(random_bits() % 7) - 3;
        struct triangle_corners c = {
            {a, {a.x + k * s.x, a.y + k * s.y, a.z + k * s.z}, {a.x + l * s.x, a.y + l * s.y, a.z + l * s.z}}};
        real3 on = plus(real3_vec(a), real3_vec(s), random_real() * 3);
        struct ray ray = ray_towards(random_real3(30), on);
        struct triangle_ray start;
        num_length t;
        triangle_ray_prepare(&start, &ray);
        CHECK(!triangle_intersect(&start, &c, NUM_LENGTH_MAX, &t));
    }
}

TEST(parts_are_barycentric)
{
    for (int i = 0; i < 20000; i++) {
        long double size = powl(2, 14 - (long double)(random_bits() % 20));
        struct triangle_corners c = {{random_vec(size), random_vec(size), random_vec(size)}};
        struct num_dir normal;
        num_unit parts[3];
        if (!triangle_normal(&c, &normal))
            continue;
        long double u = (random_real() + 1) / 2, v = (random_real() + 1) / 2 * (1 - u);
        real3 a = real3_vec(c.at[0]), ab = minus(real3_vec(c.at[1]), a), ac = minus(real3_vec(c.at[2]), a);
        if (length(cross(ab, ac)) < size * size * 0.01L)
            continue;
        triangle_barycentric(&c, normal, point_of(plus(plus(a, ab, u), ac, v)), parts);
        long double error = 200 * ERROR(size) / size;
        CHECK(fabsl((long double)parts[1] / (long double)NUM_UNIT_ONE - u) < error);
        CHECK(fabsl((long double)parts[2] / (long double)NUM_UNIT_ONE - v) < error);
        CHECK(fabsl((long double)parts[0] / (long double)NUM_UNIT_ONE - (1 - u - v)) < error);
    }
}

TEST(a_point_beside_a_triangle_counts_as_on_its_edge)
{
    struct triangle_corners c = {{{0, 0, 0}, {TIA_Q16_ONE, 0, 0}, {0, TIA_Q16_ONE, 0}}};
    struct num_dir normal;
    num_unit parts[3];

    CHECK(triangle_normal(&c, &normal));
    triangle_barycentric(&c, normal, point_of((real3){0.5L, -0.25L, 0}), parts);
    CHECK(parts[2] == 0 && parts[0] >= 0 && parts[1] > 0);
    CHECK(parts[0] + parts[1] == NUM_UNIT_ONE);
}

TEST(a_triangle_as_a_shape)
{
    struct tia_triangle triangle = {{{0, 0, 0}, {TIA_Q16(2), 0, 0}, {0, TIA_Q16(4), 0}}};
    struct ray ray = {.origin = {num_of(0.5L), num_of(1), num_of(3)}, .direction = {0, 0, -NUM_UNIT_ONE}};
    struct intersection intersection;
    struct surface surface;
    struct shape shape;
    num_length uv[2];

    PREPARE(&shape, TIA_TRIANGLE, triangle, triangle);
    CHECK(shape.kind->intersect(&shape, &ray, NUM_LENGTH_MAX, &intersection));
    CHECK(intersection.t == num_of(3) && intersection.element == 0);
    CHECK(shape.kind->intersect(&shape, &ray, num_of(3), &intersection));
    CHECK(!shape.kind->intersect(&shape, &ray, num_of(2.999L), &intersection));
    CHECK(shape.kind->occluded(&shape, &ray, num_of(3)));
    CHECK(!shape.kind->occluded(&shape, &ray, num_of(2.999L)));
    shape.kind->surface(&shape, (struct num_point){num_of(0.5L), num_of(1), 0}, 0, &surface);
    CHECK(surface.normal.x == 0 && surface.normal.y == 0 && fabsl(real3_dir(surface.normal).z - 1) < 0x1p-50L);
    CHECK(!memcmp(&surface.normal, &surface.smooth, sizeof surface.normal));
    shape.kind->uv(&shape, (struct num_point){num_of(0.5L), num_of(1), 0}, 0, uv);
    CHECK(fabsl(real_of(uv[0]) - 0.25L) < 1e-12L && fabsl(real_of(uv[1]) - 0.25L) < 1e-12L);
    ray.direction.z = NUM_UNIT_ONE;
    CHECK(!shape.kind->intersect(&shape, &ray, NUM_LENGTH_MAX, &intersection));
}

int main(void)
{
    RUN(triangles_are_met_where_they_are);
    RUN(a_floor_as_large_as_the_world_is_met_nearby);
    RUN(normals_are_exact_and_lines_have_none);
    RUN(corners_on_one_line_are_never_met);
    RUN(parts_are_barycentric);
    RUN(a_point_beside_a_triangle_counts_as_on_its_edge);
    RUN(a_triangle_as_a_shape);
    return check_status();
}
