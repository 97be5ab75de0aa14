/* test_orbit.c - camera movement: its results, computed by trigonometry in double precision. */
#include <math.h>

#include <tia/orbit.h>

#include "check.h"
#include "random.h"

#define DEGREE (acos(-1) / 180)
#define ONE TIA_Q16_ONE

static struct tia_camera looking(double x, double y, double z)
{
    return (struct tia_camera){.eye = {(tia_q16)(x * ONE), (tia_q16)(y * ONE), (tia_q16)(z * ONE)},
                               .fov = TIA_Q16(56),
                               .reference = {2 * ONE, -ONE, 3 * ONE},
                               .up = {0, ONE, 0}};
}

static double distance(const struct tia_camera *c)
{
    return sqrt(pow((double)c->eye.x - c->reference.x, 2) + pow((double)c->eye.y - c->reference.y, 2) +
                pow((double)c->eye.z - c->reference.z, 2)) /
           ONE;
}

static void check_place(const char *what, struct tia_vec3 got, double x, double y, double z, double slack)
{
    CHECK_MSG(fabs(got.x / 65536.0 - x) <= slack && fabs(got.y / 65536.0 - y) <= slack &&
                  fabs(got.z / 65536.0 - z) <= slack,
              "%s: %g %g %g, not %g %g %g", what, got.x / 65536.0, got.y / 65536.0, got.z / 65536.0, x, y, z);
}

/* The eye starts 10 before the point and moves around it on circles. */
TEST(around_a_point)
{
    for (int right = -180; right <= 180; right += 7)
        for (int up = -85; up <= 85; up += 17) {
            struct tia_camera c = looking(2, -1, 13);
            double a = right * DEGREE, b = up * DEGREE;
            tia_camera_orbit(&c, right * ONE, up * ONE);
            check_place("the eye", c.eye, 2 + 10 * sin(a) * cos(b), -1 + 10 * sin(b), 3 + 10 * cos(a) * cos(b), 1e-4);
        }
}

/* After many steps of a full turn, the eye is back, and as far away as before. */
TEST(many_steps)
{
    for (int i = 0; i < 200; i++) {
        struct tia_camera c = looking((double)(random_u32() % 2000) / 10 - 100, (double)(random_u32() % 100) / 10,
                                      (double)(random_u32() % 2000) / 10 + 10),
                          before = c;
        for (int step = 0; step < 72; step++)
            tia_camera_orbit(&c, 5 * ONE, 0);
        check_place("after a turn", c.eye, before.eye.x / 65536.0, before.eye.y / 65536.0, before.eye.z / 65536.0,
                    2e-3);
        for (int step = 0; step < 100; step++)
            tia_camera_orbit(&c, (tia_q16)(random_u32() % (90u * ONE)),
                             (tia_q16)(random_u32() % (60u * ONE)) - 30 * ONE);
        CHECK(fabs(distance(&c) - distance(&before)) < 2e-3);
        CHECK_EQ(c.reference.x, 2 * ONE);
    }
}

/* The eye does not pass the pole, nor come nearer to it than 3 degrees; around the up vector it still turns. */
TEST(the_pole)
{
    struct tia_camera c = looking(2, -1, 13);

    for (int step = 0; step < 60; step++)
        tia_camera_orbit(&c, 0, 2 * ONE);
    double y = (c.eye.y / 65536.0 + 1) / 10;
    CHECK(y < cos(2.99 * DEGREE) && y > cos(5.1 * DEGREE) && c.eye.z > 3 * ONE);
    for (int step = 0; step < 120; step++)
        tia_camera_orbit(&c, ONE, -2 * ONE);
    y = (c.eye.y / 65536.0 + 1) / 10;
    CHECK(y > -cos(2.99 * DEGREE) && y < -cos(5.1 * DEGREE));
}

TEST(another_up)
{
    struct tia_camera c = {.eye = {10 * ONE, 0, 0}, .up = {0, 0, -3 * ONE}};

    tia_camera_orbit(&c, 90 * ONE, 0);
    check_place("about -z", c.eye, 0, -10, 0, 1e-4);
}

/* Each step is along u, v, -n of camera.h, by a 32nd of the distance. */
TEST(along_its_axes)
{
    struct tia_camera c = looking(2, -1, 35), d = c;

    tia_camera_walk(&d, 3, 0, 0);
    check_place("right", d.eye, 5, -1, 35, 1e-4);
    check_place("right", d.reference, 5, -1, 3, 1e-4);
    d = c;
    tia_camera_walk(&d, -1, 2, 5);
    check_place("left, up, ahead", d.eye, 1, 1, 30, 1e-4);
    d = looking(2, 31, 3);
    d.up = (struct tia_vec3){0, 0, -ONE};
    tia_camera_walk(&d, 1, 1, 1);
    check_place("from above", d.eye, 3, 30, 2, 1e-4);
    d = looking(2, -1, 32767);
    d.eye.z = INT32_MAX;
    tia_camera_walk(&d, 0, 0, -1);
    CHECK(d.eye.z == INT32_MAX && d.reference.z == 3 * ONE);
}

TEST(nearer)
{
    struct tia_camera c = looking(0, 0, 9);

    tia_camera_zoom(&c, true);
    CHECK_EQ(c.fov, TIA_Q16(49));
    tia_camera_zoom(&c, false);
    CHECK_EQ(c.fov, TIA_Q16(56));
    for (int i = 0; i < 100; i++)
        tia_camera_zoom(&c, true);
    CHECK(c.fov >= TIA_FOV_MIN && c.fov < TIA_Q16(1.2));
    for (int i = 0; i < 100; i++)
        tia_camera_zoom(&c, false);
    CHECK(c.fov <= TIA_Q16(120) && c.fov > TIA_Q16(100));
    c.projection = TIA_ORTHOGRAPHIC;
    c.window = (struct tia_window){-8 * ONE, 16 * ONE, -32 * ONE, 24 * ONE, 0};
    tia_camera_zoom(&c, true);
    CHECK(c.window.left == -7 * ONE && c.window.right == 14 * ONE && c.window.bottom == -28 * ONE &&
          c.window.top == 21 * ONE);
}

/* The reference is as far away as the ball nearest to the line of sight among the objects ahead; planes have no
 * middle. */
TEST(what_a_camera_along_z_looks_at)
{
    static const struct tia_material materials[] = {{.colour = {0, 0, 0}}};
    static const struct tia_sphere spheres[] = {{.centre = {4 * ONE, 0, 0}, .radius = ONE},
                                                {.centre = {2 * ONE, ONE, -7 * ONE}, .radius = ONE},
                                                {.centre = {0, 0, 20 * ONE}, .radius = ONE}};
    struct tia_scene scene = {.materials = materials, .material_count = 1, .spheres = spheres, .sphere_count = 3};
    struct tia_camera c = {.eye = {0, 0, 5 * ONE}, .fov = TIA_Q16(60)};

    tia_camera_aim(&c, &scene);
    check_place("the ball", c.reference, 0, 0, -7, 1e-4);
    CHECK(c.up.y == ONE && c.eye.z == 5 * ONE);
    c.eye.z = 30 * ONE; /* the camera has a reference point already */
    tia_camera_aim(&c, &scene);
    CHECK_EQ(c.reference.z, -7 * ONE);
    c = (struct tia_camera){.eye = {0, 0, 5 * ONE}};
    scene.sphere_count = 0;
    tia_camera_aim(&c, &scene);
    check_place("nothing", c.reference, 0, 0, -5, 1e-4);
}

int main(void)
{
    RUN(around_a_point);
    RUN(many_steps);
    RUN(the_pole);
    RUN(another_up);
    RUN(along_its_axes);
    RUN(nearer);
    RUN(what_a_camera_along_z_looks_at);
    return check_status();
}
