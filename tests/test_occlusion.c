/* Ambient occlusion, as an integrator and for ambient lights, against formulas. */
#include "light_scene.h"

/* Returns the part of the unit disc to the right of x = c: cosines around the normal are areas of the disc below
 * (Nusselt). */
static double segment(double c)
{
    return (acos(c) - c * sqrt(1 - c * c)) / pi;
}

static void wall(double a)
{
    floor_below(TIA_OCCLUSION);
    world.integration.distance = TIA_Q16(1);
    world_plane(-a, 0, 0, 1, 0, 0);
}

TEST(beside_a_wall)
{
    wall(0.5);
    CHECK_LIGHT(1 - segment(0.5));
}

TEST(close_beside_a_wall)
{
    wall(1.0 / 64);
    CHECK_LIGHT(1 - segment(1.0 / 64));
}

/* Returns the part of the disc beyond both x = c and y = c. */
static double beyond_both(double c)
{
    double s = sqrt(1 - c * c);

    return ((s * c + asin(s) - c * s - asin(c)) / 2 - c * (s - c)) / pi;
}

TEST(in_a_corner)
{
    wall(0.25);
    world_plane(0, -0.25, 0, 0, 1, 0);
    CHECK_LIGHT(1 - 2 * segment(0.25) + beyond_both(0.25));
}

TEST(just_below_a_disc)
{
    const double height = 128 / 65536.0, radius = 128 / 65536.0;

    floor_below(TIA_OCCLUSION);
    world.camera.eye.z = 64;
    world_shape(TIA_DISC, 0)->disc = (struct tia_disc){{0, 0, 128}, {0, 0, TIA_Q30(1)}, 128};
    CHECK_LIGHT(1 - radius * radius / (radius * radius + height * height));
}

/* Returns the green of an ambient light, white on half grey, in Whitted's integrator: the openness times 63/2
 * levels. */
static unsigned ambient_green(tia_q16 distance)
{
    tia_rgb565 pixel;

    wall(0.5);
    world.integration.integrator = TIA_WHITTED;
    world_light(TIA_AMBIENT_LIGHT, 0, 0, 0)->radius = distance;
    world_lights[0].samples = TIA_LIGHT_SAMPLES_MAX;
    world_materials[0].colour = GREY(1);
    struct world_view v = world_open(&tia_core_q16, &tia_estimator_q16, 1, 1);
    world_draw(&tia_core_q16, &v, 1, 1, &pixel, NULL);
    world_close(&v);
    return pixel >> 5 & 63;
}

TEST(ambient_light_is_hindered)
{
    double want = 63 * (1 - segment(0.5));

    CHECK_EQ(ambient_green(0), 63);
    CHECK_EQ(ambient_green(TIA_Q16(0.25)), 63);
    CHECK_MSG(fabs(ambient_green(TIA_Q16(1)) - want) < 1, "%u, not %.1f", ambient_green(TIA_Q16(1)), want);
}

/* ---- a surface does not shadow itself ---- */

static void check_open(void)
{
    enum { SIDE = 32, COUNT = 16 };
    static struct tia_sum sums[SIDE * SIDE];

    world.camera =
        (struct tia_camera){.eye = {TIA_Q16(3), TIA_Q16(2), TIA_Q16(5)}, .up = {0, TIA_Q16(1), 0}, .fov = TIA_Q16(30)};
    struct world_view v = world_open(&tia_core_q16, &tia_estimator_q16, SIDE, SIDE);
    memset(sums, 0, sizeof sums);
    CHECK_EQ(v.estimator->sample(v.view, (struct tia_tile){0, 0, SIDE, SIDE}, 0, COUNT, sums, SIDE), TIA_OK);
    for (int i = 0; i < SIDE * SIDE; i++)
        CHECK_EQ(sums[i].rgb[0], COUNT * (INT64_C(1) << 24));
    world_close(&v);
}

static const struct tia_transform turned = {.scale = {TIA_Q16(1.5), TIA_Q16(0.75), TIA_Q16(1)},
                                            .rotation = {TIA_Q16(31), TIA_Q16(17), TIA_Q16(5)},
                                            .position = {TIA_Q16(0.25), TIA_Q16(-0.125), 0}};

TEST(convex_shapes_are_open)
{
    static const struct tia_shape shapes[] = {
        {.kind = TIA_SPHERE, .sphere = {{0, 0, 0}, TIA_Q16(1)}},
        {.kind = TIA_PLANE, .plane = {{0, -TIA_Q16(1), 0}, {TIA_Q30(0.6), TIA_Q30(0.8), 0}}},
        {.kind = TIA_BOX, .box = {{-TIA_Q16(1), -TIA_Q16(1), -TIA_Q16(1)}, {TIA_Q16(1), TIA_Q16(0.7), TIA_Q16(1)}}},
        {.kind = TIA_CYLINDER, .cylinder = {{0, -TIA_Q16(1), 0}, {0, TIA_Q16(1), TIA_Q16(0.5)}, TIA_Q16(0.8), true}},
        {.kind = TIA_CONE,
         .cone = {{0, -TIA_Q16(1), 0}, {0, TIA_Q16(1), TIA_Q16(0.5)}, TIA_Q16(0.9), TIA_Q16(0.3), true}},
        {.kind = TIA_DISC, .disc = {{0, 0, 0}, {TIA_Q30(0.6), 0, TIA_Q30(0.8)}, TIA_Q16(1)}},
        {.kind = TIA_TRIANGLE,
         .triangle = {{{-TIA_Q16(1), -TIA_Q16(1), 0}, {TIA_Q16(1), -TIA_Q16(0.7), 0}, {0, TIA_Q16(1), TIA_Q16(1)}}}},
    };

    for (unsigned i = 0; i < 2 * sizeof shapes / sizeof *shapes; i++) {
        world_begin(TIA_OCCLUSION);
        world_shapes[0] = shapes[i / 2];
        world.shape_count = 1;
        world.transforms = &turned;
        world.transform_count = 1;
        world_shapes[0].transform = i & 1;
        if (world_shapes[0].kind != TIA_PLANE || !(i & 1))
            check_open();
    }
}

int main(void)
{
    RUN(beside_a_wall);
    RUN(close_beside_a_wall);
    RUN(in_a_corner);
    RUN(just_below_a_disc);
    RUN(ambient_light_is_hindered);
    RUN(convex_shapes_are_open);
    return check_status();
}
