/* The lens of a camera: where its rays start and meet, in each projection, and pictures by each arithmetic and by the
 * vector units. */
#include "check.h"
#include "common/corpus/corpus_rays.h"
#include "random.h"
#include "render/trace/ray_camera.h"
#include "simd_frames_all.h"

#include <math.h>

#ifdef TIA_HAVE_F64
#include "common/corpus/measure.h"
#include "common/thread_pool.h"
#endif

#define RAYS 1024

static const struct tia_camera cameras[] = {{.eye = TIA_VEC3(1, 2, 3), .fov = TIA_Q16(40), .samples = 16},
                                            {.eye = TIA_VEC3(1, 2, 3),
                                             .fov = TIA_Q16(90),
                                             .reference = TIA_VEC3(-3, 0, 1),
                                             .up = TIA_VEC3(0, 1, 0.5),
                                             .samples = 16},
                                            {.eye = TIA_VEC3(0, 0, 5),
                                             .projection = TIA_FRUSTUM,
                                             .reference = TIA_VEC3(0, 1, 0),
                                             .up = TIA_VEC3(0, 1, 0),
                                             .window = {TIA_Q16(-1), TIA_Q16(2), TIA_Q16(-1), TIA_Q16(0.5), TIA_Q16(2)},
                                             .samples = 16},
                                            {.eye = TIA_VEC3(0, 0, 5),
                                             .projection = TIA_ORTHOGRAPHIC,
                                             .window = {TIA_Q16(-3), TIA_Q16(3), TIA_Q16(-2), TIA_Q16(2), 0},
                                             .samples = 16}};

static long double length_of(num_length x)
{
    return (long double)x / 0x1p45L;
}

static long double dot(struct num_point p, struct num_dir d)
{
    return length_of(p.x) * d.x / 0x1p62L + length_of(p.y) * d.y / 0x1p62L + length_of(p.z) * d.z / 0x1p62L;
}

/* A ray in the camera's axes, relative to its eye: the point at a distance along the line of sight. */
static void point_at(const struct ray_camera *c, const struct ray *ray, long double distance, long double p[2])
{
    const struct num_point from = num_point_sub(ray->origin, c->eye);
    const struct num_point to = {ray->direction.x >> 17, ray->direction.y >> 17, ray->direction.z >> 17};
    long double t = (distance + dot(from, c->n)) / -dot(to, c->n);

    p[0] = dot(from, c->u) + t * dot(to, c->u);
    p[1] = dot(from, c->v) + t * dot(to, c->v);
}

/* Both of x and x^2 of a uniform disc of radius 1 have known means: 0 and 1/4. RAYS points of a Sobol sequence are
 * nearer to these than the tolerance. */
static void check_disc(long double places[RAYS][2], long double radius, int camera)
{
    long double sum[2] = {0, 0}, square[2] = {0, 0};

    for (int i = 0; i < RAYS; i++) {
        CHECK_MSG(hypotl(places[i][0], places[i][1]) <= radius * (1 + 1e-9L), "camera %d: outside of the lens", camera);
        for (int k = 0; k < 2; k++) {
            sum[k] += places[i][k] / radius / RAYS;
            square[k] += places[i][k] * places[i][k] / radius / radius / RAYS;
        }
    }
    for (int k = 0; k < 2; k++)
        CHECK_MSG(fabsl(sum[k]) < 0.01L && fabsl(square[k] - 0.25L) < 0.01L, "camera %d: means %Lg and %Lg", camera,
                  sum[k], square[k]);
}

/* The rays of a pixel's point meet where the pinhole's ray meets the plane in focus. At another distance d they are in
 * a disc of the radius |1 - d/focus| times that of the lens. */
TEST(rays_meet_in_focus)
{
    static long double starts[RAYS][2];
    const struct tia_lens lens = {TIA_Q16(0.25), TIA_Q16(6)};
    const uint32_t place[2] = {UINT32_C(0x80000000), UINT32_C(0x20000000)};

    for (int n = 0; n < 4; n++) {
        struct tia_scene scene = {.camera = cameras[n]};
        const struct light_pixel pixel = ray_pixel_at(17, 5 * n);
        struct ray_camera pinhole, camera;
        long double want[2], near[2], got[2];
        struct ray ray;
        ray_camera_prepare(&pinhole, &scene, 64, 48);
        scene.lens = &lens;
        ray_camera_prepare(&camera, &scene, 64, 48);
        ray_camera_ray_within(&pinhole, &pixel, 0, place, &ray);
        const struct num_point middle = ray.origin;
        point_at(&pinhole, &ray, 6, want);
        point_at(&pinhole, &ray, 1.5, near);
        for (uint32_t i = 0; i < RAYS; i++) {
            ray_camera_ray_within(&camera, &pixel, i, place, &ray);
            point_at(&camera, &ray, 6, got);
            CHECK_MSG(fabsl(got[0] - want[0]) < 1e-11L && fabsl(got[1] - want[1]) < 1e-11L,
                      "camera %d, ray %u: %Lg, %Lg off", n, (unsigned)i, got[0] - want[0], got[1] - want[1]);
            point_at(&camera, &ray, 1.5, got);
            CHECK(hypotl(got[0] - near[0], got[1] - near[1]) <= 0.25L * 0.75L + 1e-11L);
            const struct num_point aside = num_point_sub(ray.origin, middle);
            CHECK(fabsl(dot(aside, camera.n)) < 1e-12L);
            starts[i][0] = dot(aside, camera.u);
            starts[i][1] = dot(aside, camera.v);
        }
        check_disc(starts, 0.25L, n);
    }
}

/* The samples of a pixel, and the same sample of two pixels, have different points of the lens. */
TEST(points_of_the_lens_differ)
{
    const struct tia_lens lens = {TIA_Q16(0.25), TIA_Q16(6)};
    const struct tia_scene scene = {.camera = cameras[0], .lens = &lens};
    struct ray_camera camera;
    struct num_point last = {0, 0, 0};

    ray_camera_prepare(&camera, &scene, 64, 48);
    for (int i = 0; i < 64; i++) {
        const struct light_pixel pixel = ray_pixel_at(i / 16, 7);
        struct ray ray;
        ray_camera_ray(&camera, &pixel, i % 16, &ray);
        CHECK(ray.origin.x != last.x && ray.origin.y != last.y);
        last = ray.origin;
    }
}

static void some_scene(struct corpus_rays *c, struct tia_lens *lens, unsigned i)
{
    corpus_random_rays(c, 9, i);
    lens->focus = TIA_Q16(3) + (tia_q16)(i * 65536);
    lens->radius = TIA_Q16(0.02) << i % 4;
    c->scene.lens = lens;
}

TEST(vector_units_draw_the_same)
{
    for (unsigned i = 0; i < 3; i++) {
        struct corpus_rays c;
        struct tia_lens lens;
        some_scene(&c, &lens, i);
        simd_frames_check_all(&c.scene, 40, 30, i);
    }
}

#ifdef TIA_HAVE_F64
TEST(pictures_are_those_in_double_precision)
{
    struct threads *pool = threads_create(threads_processors());
    struct tally sum = {0}, tally;

    for (unsigned i = 0; i < 8; i++) {
        struct corpus_rays c;
        struct tia_lens lens;
        some_scene(&c, &lens, i);
        const struct measure what = {.scene = &c.scene,
                                     .width = 48,
                                     .height = 36,
                                     .reference = &tia_core_f64,
                                     .cores = {&tia_core_q16},
                                     .core_count = 1,
                                     .workers = threads_workers(pool)};
        CHECK_EQ(measure(&what, &tally), TIA_OK);
        CHECK_MSG(tally.astray <= 2, "scene %u: %ju levels off on the same path", i, (uintmax_t)tally.astray);
        tally_add(&sum, &tally);
    }
    CHECK_MSG(tally_percent(&sum) >= 99.9, "%.5f %% identical", tally_percent(&sum));
    threads_destroy(pool);
}
#endif

int main(void)
{
    RUN(rays_meet_in_focus);
    RUN(points_of_the_lens_differ);
    RUN(vector_units_draw_the_same);
#ifdef TIA_HAVE_F64
    RUN(pictures_are_those_in_double_precision);
#endif
    return check_status();
}
