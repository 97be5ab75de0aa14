/* sphere_cases.h - tests src/render/geometry/sphere.c, in the arithmetic for which it is compiled, against the sphere's
 * equation in long double. */
#include "ray_cases.h"

/* Bound of the error of a coordinate at distances up to `size`; in floating point, the coordinates' own size counts as
 * well. */
#ifdef TIA_NUM_F64
#define ERROR(size) (16 * 0x1p-52L * ((size) + 30000))
#else
#define ERROR(size) (4 * 0x1p-45L + 8 * 0x1p-59L * (size))
#endif

#define PI 3.14159265358979323846264338327950288L

struct ball {
    struct tia_vec3 centre;
    tia_q16 radius;
};

/* The parameter of the ray's point nearest to the centre, and that point's distance from the centre. */
struct pass {
    long double tca, aside;
};

static struct pass pass_of(const struct ball *b, const struct ray *ray)
{
    real3 l = minus(real3_vec(b->centre), real3_of(ray->origin)), d = unit(real3_dir(ray->direction));
    struct pass p = {dot(l, d), 0};

    p.aside = length(plus(l, d, -p.tca));
    return p;
}

static void check_ray(const struct ball *b, const struct ray *ray, num_length limit, unsigned hits[2])
{
    struct pass p = pass_of(b, ray);
    real3 centre = real3_vec(b->centre), d = real3_dir(ray->direction), o = real3_of(ray->origin);
    long double r = b->radius / 65536.0L, error = ERROR(fabsl(p.tca) + p.aside + r);
    long double thc = sqrtl(fmaxl(r * r - p.aside * p.aside, 0)), blur = error * (thc > 0 ? 1 + r / thc : 1);
    num_length t;

    bool met = sphere_intersect(num_point_of(b->centre), num_length_of(b->radius), ray, limit, &t);
    if (met) {
        real3 at = minus(plus(o, d, real_of(t)), centre);
        bool inside = p.tca - thc < 0;
        CHECK_MSG(fabsl(length(at) - r) < error, "off the sphere by %Lg, not %Lg", length(at) - r, error);
        CHECK(t >= 0 && t <= limit);
        if (thc > 4 * blur && fabsl(p.tca - thc) > blur) /* a front hit from outside, a back hit from inside */
            CHECK_MSG((dot(at, d) > 0) == inside, "the other side: t %Lg of %Lg, %Lg", real_of(t), p.tca, thc);
    }
    long double wanted = p.tca - thc < 0 ? p.tca + thc : p.tca - thc;
    if (fabsl(p.aside - r) < error || fabsl(p.tca + thc) < blur || fabsl(p.tca - thc) < blur ||
        fabsl(wanted - real_of(limit)) < blur)
        return;
    bool want = p.aside < r && wanted >= 0 && wanted < real_of(limit);
    CHECK_MSG(met == want, "%d, not %d: aside by %Lg of %Lg, tca %Lg", met, want, p.aside, r, p.tca);
    hits[want]++;
}

static const long double radii[] = {0x1p-10L, 0.01L, 0.5L, 3, 200, 10000, 30000};

static struct ball random_ball(long double far)
{
    long double r = radii[random_bits() % (sizeof radii / sizeof radii[0])];

    return (struct ball){random_vec(far), (tia_q16)(r * 65536)};
}

static num_length random_limit(void)
{
    return random_bits() % 4 ? NUM_LENGTH_MAX : num_of(fabsl(random_real()) * 100);
}

TEST(spheres_are_met_where_they_are)
{
    unsigned hits[2] = {0, 0};

    for (int i = 0; i < 40000; i++) {
        struct ball b = random_ball(30000);
        long double r = b.radius / 65536.0L;
        real3 to = plus(real3_vec(b.centre), random_real3(1), 1.2L * r);
        struct ray ray = ray_towards(random_real3(30000), to);
        check_ray(&b, &ray, random_limit(), hits);
    }
    CHECK(hits[0] > 5000 && hits[1] > 5000);
}

TEST(spheres_are_met_from_within_and_from_close_by)
{
    unsigned hits[2] = {0, 0};

    for (int i = 0; i < 40000; i++) {
        struct ball b = random_ball(30000);
        real3 c = real3_vec(b.centre);
        long double r = b.radius / 65536.0L;
        real3 from = plus(c, random_real3(1), r);
        struct ray ray = ray_towards(from, plus(from, random_real3(1), 1));
        check_ray(&b, &ray, random_limit(), hits);
    }
    CHECK(hits[0] > 3000 && hits[1] > 5000);
}

/* Rays that pass the outline at the smallest distances that can be distinguished. */
TEST(spheres_are_met_at_grazing_angles)
{
    unsigned hits[2] = {0, 0};

    for (int i = 0; i < 40000; i++) {
        struct ball b = random_ball(20000);
        real3 c = real3_vec(b.centre), from = random_real3(30000), n = cross(minus(c, from), random_real3(1));
        long double r = b.radius / 65536.0L, away = length(minus(c, from)), s = r / away;
        if (s >= 1)
            continue;
        /* A point of the outline as seen from the ray's origin: nearer than the centre by r s, and beside it by r
         * cos. */
        real3 rim = plus(plus(c, unit(minus(from, c)), r * s), unit(n),
                         r * sqrtl(1 - s * s) *
                             (1 + powl(2, -20 - (long double)(random_bits() % 24)) * (random_bits() % 2 ? 1 : -1)));
        struct ray ray = ray_towards(from, rim);
        check_ray(&b, &ray, NUM_LENGTH_MAX, hits);
    }
    CHECK_MSG(hits[0] > 3000 && hits[1] > 3000, "%u missed, %u met", hits[0], hits[1]);
}

static void check_uv(real3 n, const num_length uv[2], long double error)
{
    long double u = 0.5L - atan2l(n.z, n.x) / (2 * PI), v = 1 - acosl(n.y) / PI;
    long double off = fabsl(real_of(uv[0]) - u);

    CHECK_MSG(fminl(off, 1 - off) < error, "u %Lg, not %Lg", real_of(uv[0]), u);
    CHECK_MSG(fabsl(real_of(uv[1]) - v) < error, "v %Lg, not %Lg", real_of(uv[1]), v);
}

TEST(normals_and_uv_are_those_of_the_direction)
{
    for (int i = 0; i < 20000; i++) {
        struct ball b = random_ball(30000);
        long double r = b.radius / 65536.0L, error = 0x1p-49L + ERROR(30000 + r) / r;
        real3 n = unit(random_real3(1));
        struct num_point at = point_of(plus(real3_vec(b.centre), n, r));
        struct surface surface;
        num_length uv[2];
        sphere_surface(num_point_of(b.centre), at, &surface);
        CHECK(length(minus(real3_dir(surface.normal), n)) < error);
        CHECK(!memcmp(&surface.normal, &surface.smooth, sizeof surface.normal));
        sphere_uv(num_point_of(b.centre), at, uv);
        if (fabsl(n.y) < 0.999L)
            check_uv(n, uv, 20 * error);
    }
}

TEST(poles_and_the_seam_have_uv)
{
    static const real3 at[] = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, -1}, {0.6L, 0.8L, 0}};
    const struct num_point centre = {NUM_LENGTH_ONE, NUM_LENGTH_ONE, NUM_LENGTH_ONE};
    num_length uv[2];

    for (size_t i = 0; i < sizeof at / sizeof at[0]; i++) {
        sphere_uv(centre, point_of(plus((real3){1, 1, 1}, at[i], 3)), uv);
        check_uv(at[i], uv, 1e-11L);
    }
    sphere_uv(centre, point_of((real3){-2, 1, 1}), uv);
    CHECK(fabsl(real_of(uv[1]) - 0.5L) < 1e-11L);
    CHECK(fminl(fabsl(real_of(uv[0])), fabsl(real_of(uv[0]) - 1)) < 1e-11L);
}

int main(void)
{
    RUN(spheres_are_met_where_they_are);
    RUN(spheres_are_met_from_within_and_from_close_by);
    RUN(spheres_are_met_at_grazing_angles);
    RUN(normals_and_uv_are_those_of_the_direction);
    RUN(poles_and_the_seam_have_uv);
    return check_status();
}
