/* instance_cases.h - tests src/render/geometry/instance.c and sphere.c, in the arithmetic for which they are compiled,
 * against matrices and quadratics in long double. */
#include "ray_cases.h"
#include "render/geometry/instance.h"

/* ERROR: bound of the error of a coordinate in the world, for coordinates up to `size`. ANGLE: bound of the error of a
 * direction. */
#ifdef TIA_NUM_F64
#define ERROR(size) (16 * 0x1p-52L * (size))
#define ANGLE 0x1p-49L
#else
#define ERROR(size) (8 * 0x1p-45L + 16 * 0x1p-59L * (size))
#define ANGLE 0x1p-54L
#endif

/* A transform as a matrix whose columns are the axes, and a box in these axes. */
struct matrix {
    struct tia_transform transform;
    real3 axes[3], position;
    long double scale[3];
    struct bounds_wide box;
    struct instance instance;
};

static real3 turned(real3 v, tia_q16 degrees, int about)
{
    long double angle = degrees / 65536.0L * 3.14159265358979323846264338327950288L / 180, c = cosl(angle),
                s = sinl(angle);

    if (about == 0)
        return (real3){v.x, c * v.y - s * v.z, s * v.y + c * v.z};
    if (about == 1)
        return (real3){c * v.x + s * v.z, v.y, c * v.z - s * v.x};
    return (real3){c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

static void make(struct matrix *m, const tia_q16 scale[3], long double reach)
{
    static const real3 units[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const struct tia_vec3 r = random_bits() % 8 ? random_vec(400) : (struct tia_vec3){0, 0, TIA_Q16(90)};

    m->transform = (struct tia_transform){random_vec(15000), r, {scale[0], scale[1], scale[2]}};
    m->position = real3_vec(m->transform.position);
    for (int i = 0; i < 3; i++) {
        m->axes[i] = turned(turned(turned(units[i], r.x, 0), r.y, 1), r.z, 2);
        m->scale[i] = scale[i] / 65536.0L;
        long double most = reach / m->scale[i] < 32767 ? reach / m->scale[i] : 32767;
        int64_t a = (int64_t)(random_real() * most * 65536), b = (int64_t)(random_real() * most * 65536);
        m->box.min[i] = a < b ? a : b;
        m->box.max[i] = (a < b ? b : a) + 1;
    }
    instance_prepare(&m->instance, &m->transform, &m->box);
}

/* Makes a random transform with scales of all magnitudes, often the smallest or the largest. */
static void make_random(struct matrix *m)
{
    tia_q16 scale[3];
    bool even = random_bits() % 3 == 0;

    for (int i = 0; i < 3; i++) {
        scale[i] = even && i ? scale[0] : (tia_q16)powl(2, 16 + 10 * random_real());
        if (!even && random_bits() % 4 == 0)
            scale[i] = random_bits() % 2 ? TIA_SCALE_MIN : TIA_SCALE_MAX;
        scale[i] = scale[i] < TIA_SCALE_MIN ? TIA_SCALE_MIN : scale[i];
    }
    make(m, scale, powl(2, 13 - (long double)(random_bits() % 14)));
}

static real3 to_world(const struct matrix *m, real3 q)
{
    real3 p = plus(m->position, m->axes[0], q.x * m->scale[0]);

    return plus(plus(p, m->axes[1], q.y * m->scale[1]), m->axes[2], q.z * m->scale[2]);
}

/* Transforms a vector from the world to the shape's axes. */
static real3 to_shape(const struct matrix *m, real3 v)
{
    return (real3){dot(v, m->axes[0]) / m->scale[0], dot(v, m->axes[1]) / m->scale[1],
                   dot(v, m->axes[2]) / m->scale[2]};
}

static long double between(int64_t a, int64_t b)
{
    return ((long double)a + (long double)(b - a) * (random_real() + 1) / 2) / 65536;
}

/* Returns a point in the shape's axes: in the box, or outside it by up to `beyond` times the box's size. */
static real3 in_box(const struct matrix *m, int64_t beyond)
{
    int64_t out[3];

    for (int i = 0; i < 3; i++)
        out[i] = beyond * (m->box.max[i] - m->box.min[i]);
    return (real3){between(m->box.min[0] - out[0], m->box.max[0] + out[0]),
                   between(m->box.min[1] - out[1], m->box.max[1] + out[1]),
                   between(m->box.min[2] - out[2], m->box.max[2] + out[2])};
}

static bool is_seen(real3 p)
{
    return fabsl(p.x) < 32768 && fabsl(p.y) < 32768 && fabsl(p.z) < 32768;
}

static struct ray ray_at(real3 target)
{
    long double away = powl(2, 15 - (long double)(random_bits() % 20));
    real3 from;

    do {
        from = plus(random_bits() % 4 ? target : (real3){0, 0, 0}, random_real3(1), away < 30000 ? away : 30000);
        away /= 2;
    } while (!is_seen(from));
    return ray_towards(from, target);
}

/* True if |a_i - b_i| <= error/scale_i for a and b in the shape's axes; `error` is a length in the world. */
static bool is_near(const struct matrix *m, real3 a, real3 b, long double error)
{
    return fabsl(a.x - b.x) <= error / m->scale[0] && fabsl(a.y - b.y) <= error / m->scale[1] &&
           fabsl(a.z - b.z) <= error / m->scale[2];
}

/* Checks a ray that meets the point q of the box. */
static void tia_check_placed(const struct matrix *m, const struct ray *ray, real3 q)
{
    struct instance_ray placed;
    real3 o = real3_of(ray->origin), d = real3_dir(ray->direction), along = to_shape(m, d);
    long double t = dot(minus(to_world(m, q), o), d), k = length(along), least = fminl(m->scale[0], m->scale[1]);
    long double error = ERROR(65536);

    least = fminl(least, m->scale[2]);
    instance_transform_ray(&m->instance, ray, &placed);
    long double start = real_of(placed.start);
    CHECK_MSG(start <= t + 1e-9L, "starts at %Lg, beyond %Lg", start, t);
    if (start > t + 1e-9L)
        return;
    real3 moved = to_shape(m, minus(plus(o, d, start), m->position)), local = real3_of(placed.ray.origin);
    CHECK_MSG(is_near(m, local, moved, error + 0x1p-44L * 1024), "%Lg %Lg %Lg", local.x - moved.x, local.y - moved.y,
              local.z - moved.z);
    long double off = length(minus(real3_dir(placed.ray.direction), unit(along)));
    CHECK_MSG(off < ANGLE * (1 + 1 / least / k), "direction off by %Lg", off);
    long double there = real_of(instance_distance(&placed, num_of(t))), wanted = (t - start) * k;
    if (t > start)
        CHECK_MSG(fabsl(there - wanted) < k * error + 1e-12L * (1 + wanted), "%Lg there, not %Lg", there, wanted);
    long double back = real_of(instance_distance_back(&placed, num_of(wanted)));
    CHECK_MSG(t <= start || fabsl(back - t) < error + 4 * 0x1p-45L / k, "%Lg back, not %Lg", back, t);
    /* a transformed ray whose start was moved forward starts near the box, so that its coordinates stay as large as the
     * shape's */
    for (int i = 0; i < 3; i++) {
        long double x = i == 0   ? local.x
                        : i == 1 ? local.y
                                 : local.z,
                    slack = (0.0001L + 1e-3L * (t - start)) / m->scale[i];
        if (start > 0)
            CHECK_MSG(x > m->box.min[i] / 65536.0L - slack && x < m->box.max[i] / 65536.0L + slack, "starts at %Lg", x);
    }
}

TEST(rays_are_placed_as_matrices_say)
{
    struct matrix m;

    for (int i = 0; i < 4000; i++) {
        make_random(&m);
        for (int k = 0; k < 5; k++) {
            real3 q = in_box(&m, 0);
            struct ray ray = ray_at(to_world(&m, q));
            tia_check_placed(&m, &ray, q);
        }
    }
}

/* Returns near - far of the slab test with the box enlarged by `grown`: negative if the ray meets the box. */
static long double passes(const struct matrix *m, const struct ray *ray, long double grown)
{
    real3 o = to_shape(m, minus(real3_of(ray->origin), m->position)), d = to_shape(m, real3_dir(ray->direction));
    const long double from[3] = {o.x, o.y, o.z}, along[3] = {d.x, d.y, d.z};
    long double near = 0, far = 131072;

    for (int i = 0; i < 3; i++) {
        long double a = (m->box.min[i] / 65536.0L - grown / m->scale[i] - from[i]) / along[i];
        long double b = (m->box.max[i] / 65536.0L + grown / m->scale[i] - from[i]) / along[i];
        near = fmaxl(near, fminl(a, b));
        far = fminl(far, fmaxl(a, b));
    }
    return near - far;
}

TEST(rays_beside_the_box_miss)
{
    unsigned met = 0, missed = 0;

    for (int i = 0; i < 20000; i++) {
        struct matrix m;
        struct instance_ray placed;
        make_random(&m);
        real3 target = to_world(&m, in_box(&m, 1));
        if (!is_seen(target))
            continue;
        struct ray ray = ray_at(target);
        instance_transform_ray(&m.instance, &ray, &placed);
        bool misses = instance_distance(&placed, NUM_LENGTH_MAX) < 0;
        if (passes(&m, &ray, 0.01L) > 1e-3L) {
            CHECK(misses);
            missed++;
        } else if (passes(&m, &ray, 0) < 0) {
            CHECK(!misses);
            met++;
        }
    }
    CHECK_MSG(met > 2000 && missed > 2000, "%u met, %u missed", met, missed);
}

/* A ray that rises by 2^-21 of its way, whose reciprocal num_reciprocal clamps, starts `gap` below the plane of a box's
 * top. It leaves that plane's side after 2^21 gap, beyond the box's front, 29999 away. */
TEST(nearly_level_rays_meet_boxes_below_their_planes)
{
    const struct tia_transform transform = {{TIA_Q16(15000), 0, 0}, {0, 0, 0}, {65536, 65536, 65536}};
    const struct bounds_wide box = {{-65536, -65536, -65536}, {65536, 65536, 65536}};
    const struct num_dir along = {NUM_UNIT_ONE, NUM_UNIT_ONE / 2097152, 0};
    struct instance instance;

    instance_prepare(&instance, &transform, &box);
    for (int i = 15; i <= 64; i++) {
        long double gap = i / 1024.0L;
        struct instance_ray placed;
        const struct ray ray = {point_of((real3){-15000, 1 - gap, 0}), along};
        instance_transform_ray(&instance, &ray, &placed);
        CHECK_MSG(placed.start <= NUM_LENGTH_MAX, "%Lg below the plane", gap);
    }
}

TEST(points_are_placed_as_matrices_say)
{
    struct matrix m;

    for (int i = 0; i < 20000; i++) {
        make_random(&m);
        real3 q = in_box(&m, 0), got = real3_of(instance_point(&m.instance, point_of(to_world(&m, q))));
        CHECK_MSG(is_near(&m, got, q, ERROR(65536) + 0x1p-45L * 1024), "%Lg %Lg %Lg", got.x - q.x, got.y - q.y,
                  got.z - q.z);
    }
}

/* Tangents of the surface stay at right angles to the normal. */
TEST(normals_are_placed_by_the_inverse_transpose)
{
    struct matrix m;

    for (int i = 0; i < 20000; i++) {
        make_random(&m);
        real3 n = unit(random_real3(1)), wanted = {0, 0, 0};
        struct num_dir given = {(num_unit)(n.x * (long double)NUM_UNIT_ONE),
                                (num_unit)(n.y * (long double)NUM_UNIT_ONE),
                                (num_unit)(n.z * (long double)NUM_UNIT_ONE)};
        real3 got = real3_dir(instance_normal(&m.instance, given));
        n = real3_dir(given);
        const long double along[3] = {n.x, n.y, n.z};
        for (int k = 0; k < 3; k++)
            wanted = plus(wanted, m.axes[k], along[k] / m.scale[k]);
        CHECK_MSG(length(minus(got, unit(wanted))) < ANGLE, "off by %Lg", length(minus(got, unit(wanted))));
    }
}

/* A sphere of radius 2 around (1, 2, 3) becomes an ellipsoid. */
TEST(ellipsoids_are_met_where_they_are)
{
    static const struct tia_vec3 centre = TIA_VEC3(1, 2, 3);
    static const struct tia_scene scene;
    const struct tia_shape sphere = {.transform = 1, .sphere = {centre, TIA_Q16(2)}};
    unsigned hits[2] = {0, 0};

    for (int i = 0; i < 20000; i++) {
        struct matrix m;
        struct instance_ray placed;
        struct shape shape;
        struct intersection intersection;
        make_random(&m);
        tia_bounds_in_own_axes(&scene, &sphere, NULL, &m.box);
        CHECK(m.box.min[1] == -1 && m.box.max[2] == TIA_Q16(5) + 1);
        instance_prepare(&m.instance, &m.transform, &m.box);
        PREPARE(&shape, TIA_SPHERE, sphere, {centre, TIA_Q16(2)});
        struct ray ray = ray_at(to_world(&m, in_box(&m, 0)));
        instance_transform_ray(&m.instance, &ray, &placed);
        num_length limit = instance_distance(&placed, NUM_LENGTH_MAX);
        bool met = limit >= 0 && shape.kind->intersect(&shape, &placed.ray, limit, &intersection);

        /* a t^2 - 2 b t + c = 0 in the shape's axes */
        real3 o = minus(to_shape(&m, minus(real3_of(ray.origin), m.position)), real3_vec(centre));
        real3 d = to_shape(&m, real3_dir(ray.direction));
        long double tca = -dot(o, d) / dot(d, d), aside = length(plus(o, d, tca)), error = 0x1p-26L;
        long double thc = sqrtl(fmaxl(4 - aside * aside, 0)) / length(d);
        if (fabsl(aside - 2) < error || fabsl(tca + thc) < 1e-3L || fabsl(tca - thc) < 1e-3L)
            continue;
        CHECK_EQ(met, aside < 2 && tca + thc > 0);
        hits[met]++;
        if (!met || aside > 2)
            continue;
        long double t = real_of(instance_distance_back(&placed, intersection.t));
        real3 at = plus(o, d, t);
        CHECK_MSG(fabsl(length(at) - 2) < error, "off by %Lg", length(at) - 2);
        CHECK_MSG((dot(at, d) < 0) == (tca > thc), "the farther side");
    }
    CHECK_MSG(hits[0] > 1000 && hits[1] > 1000, "%u missed, %u met", hits[0], hits[1]);
}

int main(void)
{
    RUN(rays_are_placed_as_matrices_say);
    RUN(rays_beside_the_box_miss);
    RUN(nearly_level_rays_meet_boxes_below_their_planes);
    RUN(points_are_placed_as_matrices_say);
    RUN(normals_are_placed_by_the_inverse_transpose);
    RUN(ellipsoids_are_met_where_they_are);
    return check_status();
}
