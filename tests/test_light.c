/* The light of sampling integrators, compared with formulas. */
#include "light_scene.h"

/* ---- irradiance below lights: form factors ---- */

TEST(below_a_disc)
{
    floor_below(TIA_PATHS);
    world_light(TIA_DISC_LIGHT, 0, 0, 2)->radius = TIA_Q16(1.5);
    CHECK_LIGHT(0.5 * 1.5 * 1.5 / (1.5 * 1.5 + 2 * 2));
}

TEST(below_a_sphere_light)
{
    floor_below(TIA_PATHS);
    world_light(TIA_SPHERE_LIGHT, 0, 0, 3)->radius = TIA_Q16(1.25);
    CHECK_LIGHT(0.5 * 1.25 * 1.25 / (3 * 3));
}

/* The sphere is at the side, entirely above the floor, so its irradiance has the factor of a cosine. The material's
 * emission is 2^2 times as large. */
TEST(beside_an_emitting_sphere)
{
    floor_below(TIA_PATHS);
    world_materials[1].emission = GREY(0.75);
    world_materials[1].emission_bits = 2;
    world_spheres[0] = (struct tia_sphere){{TIA_Q16(2), 0, TIA_Q16(2)}, TIA_Q16(1), 1};
    world.sphere_count = 1;
    CHECK_LIGHT(0.5 * 3 * 1 / 8.0 * sqrt(0.5));
}

/* Returns the form factor of a rectangle above one of its corners, seen from below. */
static double corner(double a, double b)
{
    double p = sqrt(1 + a * a), q = sqrt(1 + b * b);

    return (a / p * atan(b / p) + b / q * atan(a / q)) / (2 * pi);
}

static void rectangle(void)
{
    struct tia_light *l = world_light(TIA_RECTANGLE_LIGHT, 0.5, 0, 2);

    l->side[0].x = TIA_Q16(1.5);
    l->side[1].y = TIA_Q16(1);
}

static double rectangle_factor(void)
{
    return 2 * (corner(1, 0.5) + corner(0.5, 0.5));
}

TEST(below_a_rectangle)
{
    floor_below(TIA_PATHS);
    rectangle();
    CHECK_LIGHT(0.5 * rectangle_factor());
}

TEST(below_a_rectangle_by_lights_alone)
{
    floor_below(TIA_PATHS);
    rectangle();
    world.integration.without = TIA_STRATEGY_SCATTERING;
    CHECK_LIGHT(0.5 * rectangle_factor());
}

TEST(below_a_rectangle_by_scattering_alone)
{
    floor_below(TIA_PATHS);
    rectangle();
    world.integration.without = TIA_STRATEGY_LIGHTS;
    CHECK_LIGHT(0.5 * rectangle_factor());
}

/* With several lights, one is chosen at a time. */
TEST(below_a_disc_and_a_rectangle_and_a_point)
{
    floor_below(TIA_PATHS);
    rectangle();
    world_light(TIA_DISC_LIGHT, 0, 0, 1)->radius = TIA_Q16(0.25);
    world_lights[1].emission_bits = 3;
    world_light(TIA_POINT_LIGHT, -3, 0, 4);
    /* The disc is before the rectangle and hides a part of it: the disc of radius 1/2 at the rectangle's height. */
    double disc = 0.0625 / (0.0625 + 1);
    CHECK_LIGHT(0.5 * (8 * disc + rectangle_factor() - disc + 0.8));
}

/* A light without a surface is always the same: E times the cosine and the attenuation. */
TEST(below_a_point)
{
    floor_below(TIA_PATHS);
    struct tia_light *l = world_light(TIA_POINT_LIGHT, 3, 0, 4);
    l->quadratic = TIA_Q16(0.125);
    CHECK(fabs(world_mean(1, 16) - 0.5 * 0.8 / (0.125 * 25)) < 1e-6);
}

/* Attenuation has no effect at an infinite distance, and paths ignore ambient lights. */
TEST(below_the_sun)
{
    floor_below(TIA_PATHS);
    struct tia_light *l = world_light(TIA_DIRECTIONAL_LIGHT, 0, 0, 0);
    l->direction = (struct tia_dir3){TIA_Q30(-0.6), 0, TIA_Q30(-0.8)};
    l->constant = TIA_Q16(4);
    world_light(TIA_AMBIENT_LIGHT, 0, 0, 0);
    CHECK(fabs(world_mean(1, 16) - 0.5 * 0.8) < 1e-6);
}

/* The cosine is half-way between those of the cones, within the accuracy of their degrees in Q16.16. */
TEST(below_a_spot)
{
    floor_below(TIA_PATHS);
    struct tia_light *l = world_light(TIA_SPOT_LIGHT, 0, 0, 2);
    l->direction = (struct tia_dir3){TIA_Q30(0.8), 0, TIA_Q30(-0.6)};
    l->inner = TIA_Q16(45.572996); /* cosine 0.7 */
    l->outer = TIA_Q16(60);
    CHECK(fabs(world_mean(1, 16) - 0.5 * 0.5) < 1e-5);
}

/* ---- furnaces and cavities ---- */

/* Checks that every sample of a scene surrounded by radiance 1 is 1. */
static void check_furnace(void)
{
    enum { SIDE = 24, COUNT = 16 };
    static struct tia_sum sums[SIDE * SIDE];

    world.background = GREY(1);
    world.camera = (struct tia_camera){.eye = {0, 0, TIA_Q16(5)}, .fov = TIA_Q16(40)};
    struct world_view v = world_open(&tia_core_q16, &tia_estimator_q16, SIDE, SIDE);
    memset(sums, 0, sizeof sums);
    CHECK_EQ(v.estimator->sample(v.view, (struct tia_tile){0, 0, SIDE, SIDE}, 0, COUNT, sums, SIDE), TIA_OK);
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int c = 0; c < 3; c++)
            CHECK_EQ(sums[i].rgb[c], COUNT * (INT64_C(1) << 24));
    world_close(&v);
}

static void ball(void)
{
    world_begin(TIA_PATHS);
    world_spheres[0] = (struct tia_sphere){{0, 0, 0}, TIA_Q16(1), 1};
    world.sphere_count = 1;
}

TEST(furnace_with_lambert)
{
    ball();
    world_materials[1].colour = GREY(1);
    check_furnace();
    world_shape(TIA_BOX, 1)->box = (struct tia_box){{-TIA_Q16(2), -TIA_Q16(2), -TIA_Q16(1)}, {0, TIA_Q16(2), 0}};
    check_furnace();
}

TEST(furnace_with_a_mirror)
{
    ball();
    world_materials[1].mirror = GREY(1);
    check_furnace();
}

TEST(furnace_with_glass)
{
    for (int fresnel = 0; fresnel < 2; fresnel++) {
        ball();
        world_materials[1].refraction = GREY(1);
        world_materials[1].index = TIA_Q16(1.5);
        world_materials[1].fresnel = fresnel;
        check_furnace();
    }
}

/* Checks Phong's lobe for a viewer along the normal: its integral with the cosine is 1. */
static void lobe(double exponent)
{
    floor_below(TIA_PATHS);
    world_materials[0].colour = GREY(0);
    world_materials[0].specular = GREY(0.75);
    world_materials[0].exponent = TIA_Q16(exponent);
    world.background = GREY(1);
}

TEST(furnace_with_a_wide_lobe)
{
    lobe(1);
    CHECK_LIGHT(0.75);
}

TEST(furnace_with_a_narrow_lobe)
{
    lobe(1000);
    CHECK_LIGHT(0.75);
}

TEST(furnace_with_a_lobe_on_lambert)
{
    lobe(20);
    world_materials[0].colour = GREY(0.25);
    CHECK_LIGHT(1);
}

/* Checks a closed sphere that emits e and reflects r. */
static void cavity(double e, double r)
{
    world_begin(TIA_PATHS);
    world.camera.eye = (struct tia_vec3){0, 0, 0};
    world.camera.reference.z = -TIA_Q16(1);
    world_materials[1].emission = GREY(e);
    world_materials[1].colour = GREY(r);
    world_spheres[0] = (struct tia_sphere){{TIA_Q16(0.25), 0, 0}, TIA_Q16(1), 1};
    world.sphere_count = 1;
}

TEST(cavity_of_a_half)
{
    cavity(0.25, 0.5);
    CHECK_LIGHT(0.25 / 0.5);
}

TEST(cavity_of_nine_tenths)
{
    cavity(0.25, 0.9);
    CHECK_LIGHT(0.25 / 0.1);
}

TEST(cavity_of_nineteen_twentieths)
{
    cavity(0.25, 0.95);
    CHECK_LIGHT(0.25 / 0.05);
}

/* ---- sums ---- */

/* Checks that the sums do not depend on tiles, on ranges of samples, or on their order. */
static void check_parts(enum tia_integrator integrator)
{
    enum { SIDE = 17, COUNT = 16 };
    static struct tia_sum whole[SIDE * SIDE], parts[SIDE * SIDE];
    static const uint32_t ranges[][2] = {{5, 11}, {11, 16}, {0, 1}, {1, 5}};

    floor_below(integrator);
    rectangle();
    world_materials[1].mirror = GREY(0.5);
    world_materials[1].colour = GREY(0.25);
    world_spheres[0] = (struct tia_sphere){{0, 0, TIA_Q16(0.5)}, TIA_Q16(0.25), 1};
    world.sphere_count = 1;
    world.camera =
        (struct tia_camera){.eye = {0, -TIA_Q16(4), TIA_Q16(1)}, .up = {0, 0, TIA_Q16(1)}, .fov = TIA_Q16(40)};
    struct world_view v = world_open(&tia_core_q16, &tia_estimator_q16, SIDE, SIDE);
    memset(whole, 0, sizeof whole);
    memset(parts, 0, sizeof parts);
    CHECK_EQ(v.estimator->sample(v.view, (struct tia_tile){0, 0, SIDE, SIDE}, 0, COUNT, whole, SIDE), TIA_OK);
    for (unsigned r = 0; r < 4; r++)
        for (int i = 8; i >= 0; i--) { /* tiles of 7, 7 and 3 */
            uint16_t x = (uint16_t)(i % 3 * 7), y = (uint16_t)(i / 3 * 7);
            struct tia_tile tile = {x, y, i % 3 < 2 ? 7 : 3, i / 3 < 2 ? 7 : 3};
            CHECK_EQ(v.estimator->sample(v.view, tile, ranges[r][0], ranges[r][1], &parts[y * SIDE + x], SIDE), TIA_OK);
        }
    CHECK(memcmp(whole, parts, sizeof whole) == 0);
    CHECK_EQ(v.estimator->sample(v.view, (struct tia_tile){0, 0, SIDE + 1, 1}, 0, 1, parts, SIDE), TIA_ERR_ARGUMENT);
    CHECK_EQ(v.estimator->sample(v.view, (struct tia_tile){0, 0, 1, 1}, 0, TIA_SPP_MAX + 1, parts, SIDE),
             TIA_ERR_ARGUMENT);
    CHECK_EQ(v.estimator->sample(v.view, (struct tia_tile){0, 0, 1, 1}, 2, 1, parts, SIDE), TIA_ERR_ARGUMENT);
    world_close(&v);
}

TEST(parts_make_the_whole)
{
    check_parts(TIA_OCCLUSION);
    check_parts(TIA_PATHS);
}

/* A picture takes at most 16 bytes a pixel beside the view, which does not grow with it. */
TEST(memory_of_a_picture)
{
    static const enum tia_integrator integrators[] = {TIA_OCCLUSION, TIA_PATHS};
    const struct tia_tile small = {0, 0, 1, 1}, large = {0, 0, 4096, 2048};

    for (unsigned i = 0; i < 2; i++) {
        world_room();
        world.integration.integrator = integrators[i];
        CHECK(tia_hits_size(&world, large) - tia_hits_size(&world, small) <= 16 * 4096 * 2048);
        struct world_view v = world_open(&tia_core_q16, &tia_estimator_q16, 4096, 2048);
        world_close(&v);
    }
}

TEST(whitted_has_no_samples)
{
    struct tia_sum sum;

    floor_below(TIA_WHITTED);
    struct world_view v = world_open(&tia_core_q16, &tia_estimator_q16, 1, 1);
    CHECK_EQ(v.estimator->sample(v.view, (struct tia_tile){0, 0, 1, 1}, 0, 1, &sum, 1), TIA_ERR_UNSUPPORTED);
    world_close(&v);
}

int main(void)
{
    RUN(below_a_disc);
    RUN(below_a_sphere_light);
    RUN(beside_an_emitting_sphere);
    RUN(below_a_rectangle);
    RUN(below_a_rectangle_by_lights_alone);
    RUN(below_a_rectangle_by_scattering_alone);
    RUN(below_a_disc_and_a_rectangle_and_a_point);
    RUN(below_a_point);
    RUN(below_the_sun);
    RUN(below_a_spot);
    RUN(furnace_with_lambert);
    RUN(furnace_with_a_mirror);
    RUN(furnace_with_glass);
    RUN(furnace_with_a_wide_lobe);
    RUN(furnace_with_a_narrow_lobe);
    RUN(furnace_with_a_lobe_on_lambert);
    RUN(cavity_of_a_half);
    RUN_LONG(cavity_of_nine_tenths);
    RUN_LONG(cavity_of_nineteen_twentieths);
    RUN(parts_make_the_whole);
    RUN(memory_of_a_picture);
    RUN(whitted_has_no_samples);
    return check_status();
}
