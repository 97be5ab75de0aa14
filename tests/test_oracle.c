/* The oracle against values worked out by hand, on which the trust in it rests. */
#include "check.h"
#include "oracle/oracle.h"
#include "random.h"

#include <math.h>

#define NEAR(got, want)                                                                                                \
    CHECK_MSG(fabs((got) - (want)) < 1e-12, "%s is %.17g, not %.17g", #got, (double)(got), (double)(want))

static const struct tia_material grey = {.colour = TIA_RGB(0.5, 0.5, 0.5)};

static double q16_unit(tia_q16 v)
{
    return v / 65536.0;
}

/* Returns a scene of one ball of radius 3 at (0, 0, -10), all else black, for one pixel at fov 90. */
static struct tia_scene one_ball(const struct tia_sphere *ball, const struct tia_light *lights, uint32_t count)
{
    return (struct tia_scene){.camera = {.fov = TIA_Q16(90)},
                              .materials = &grey,
                              .spheres = ball,
                              .lights = lights,
                              .material_count = 1,
                              .sphere_count = 1,
                              .light_count = count};
}

static const struct tia_sphere ball = {TIA_VEC3(0, 0, -10), TIA_Q16(3), 0};

TEST(primary_ray_of_a_single_pixel_leads_straight_ahead)
{
    struct tia_camera camera = {.fov = TIA_Q16(25)};
    struct oracle_vec d = oracle_direction(&camera, 1, 1, 0, 0);

    NEAR(d.x, 0);
    NEAR(d.y, 0);
    NEAR(d.z, -1);
}

/* Fov 90 makes a = 1. Pixel (0, 0) of 4x2 is at (-3/4 * 2, 1/2, -1) = (-1.5, 0.5, -1), length sqrt(3.5). */
TEST(primary_ray_of_a_corner)
{
    struct tia_camera camera = {.fov = TIA_Q16(90)};
    struct oracle_vec d = oracle_direction(&camera, 4, 2, 0, 0);

    NEAR(d.x, -1.5 / sqrt(3.5));
    NEAR(d.y, 0.5 / sqrt(3.5));
    NEAR(d.z, -1 / sqrt(3.5));
    d = oracle_direction(&camera, 4, 2, 3, 1);
    NEAR(d.x, 1.5 / sqrt(3.5));
    NEAR(d.y, -0.5 / sqrt(3.5));
}

/* Fov 60 in a 2x2 image makes a = 1/sqrt(3) and pixel (0, 1) at (-a/2, -a/2, -1). */
TEST(primary_ray_depends_on_the_field_of_view)
{
    struct tia_camera camera = {.fov = TIA_Q16(60)};
    struct oracle_vec d = oracle_direction(&camera, 2, 2, 0, 1);

    NEAR(d.x / d.z, 0.5 / sqrt(3));
    NEAR(d.y / d.z, 0.5 / sqrt(3));
    NEAR(d.x * d.x + d.y * d.y + d.z * d.z, 1);
}

/* By the 3-4-5 triangle, a ray 4 beside the centre of a sphere of radius 5 meets it 3 before and after the nearest
 * point. */
TEST(geometric_hits_by_pencil)
{
    struct oracle_vec ahead = {0, 0, -1}, centre = {4, 0, -20};
    double t = 0;

    CHECK(oracle_sphere_geometric((struct oracle_vec){0, 0, 0}, ahead, centre, 5, &t));
    NEAR(t, 17);
    CHECK(oracle_sphere_geometric((struct oracle_vec){0, 0, -18}, ahead, centre, 5, &t)); /* from inside */
    NEAR(t, 5);
    CHECK(!oracle_sphere_geometric((struct oracle_vec){0, 0, -21}, ahead, centre, 5, &t)); /* the centre is behind */
    CHECK(!oracle_sphere_geometric((struct oracle_vec){0, 0, 0}, ahead, centre, 3.999, &t));
    CHECK(oracle_sphere_geometric((struct oracle_vec){0, 0, 0}, ahead, centre, 4, &t)); /* a graze is a hit */
    NEAR(t, 20);
    CHECK(!oracle_sphere_geometric((struct oracle_vec){0, 0, 0}, (struct oracle_vec){0, 0, 1}, centre, 5, &t));
}

TEST(analytic_hits_by_pencil)
{
    struct oracle_vec ahead = {0, 0, -1}, centre = {4, 0, -20};
    double t = 0;

    CHECK(oracle_sphere_analytic((struct oracle_vec){0, 0, 0}, ahead, centre, 5, &t));
    NEAR(t, 17);
    CHECK(oracle_sphere_analytic((struct oracle_vec){0, 0, -18}, ahead, centre, 5, &t));
    NEAR(t, 5);
    CHECK(oracle_sphere_analytic((struct oracle_vec){0, 0, -21}, ahead, centre, 5, &t)); /* the ray leaves a sphere */
    NEAR(t, 2);
    CHECK(!oracle_sphere_analytic((struct oracle_vec){0, 0, 0}, ahead, centre, 3.999, &t));
    CHECK(!oracle_sphere_analytic((struct oracle_vec){0, 0, -26}, ahead, centre, 5, &t));
}

static struct oracle_vec random_direction(void)
{
    struct oracle_vec d = {random_double(), random_double(), random_double()};
    double length = sqrt(d.x * d.x + d.y * d.y + d.z * d.z);

    return (struct oracle_vec){d.x / length, d.y / length, d.z / length};
}

/* Compares a million rays to a sphere of radius r from outside: both forms hit or both miss, at the same point, except
 * for rays that graze within the rounding errors of the quadratic (c = L.L - r^2 of L.L). */
static void compare_forms(double distance, double radius, double tolerance)
{
    unsigned hits = 0, differ = 0;

    for (int i = 0; i < 1000000; i++) {
        struct oracle_vec d = random_direction(), l = random_direction(), o = {0, 0, 0};
        struct oracle_vec c = {l.x * distance, l.y * distance, l.z * distance};
        double g = 0, a = 0;
        bool hit = oracle_sphere_geometric(o, d, c, radius, &g);
        differ += hit != oracle_sphere_analytic(o, d, c, radius, &a);
        hits += hit;
        if (hit)
            CHECK_MSG(fabs(a - g) < tolerance, "%.17g and %.17g", g, a);
    }
    CHECK_MSG(hits > 100000, "only %u hits", hits);
    CHECK_MSG(differ == 0, "%u rays differ", differ);
}

TEST(both_forms_agree_on_a_ball)
{
    random_state = 2024;
    compare_forms(5, 3, 1e-7);
}

/* b^2 - 4ac loses 2^-53 of 4e8 each, and the root of a small number doubles its relative error: sqrt(1e-7) = 3e-4 in t
 * is the worst error of a graze. */
TEST(both_forms_agree_on_the_ground)
{
    random_state = 2025;
    compare_forms(10004, 10000, 1e-3);
}

/* The matrix follows from M(4) = [0 8 2 10; 12 4 14 6; 3 11 1 9; 15 7 13 5]: row 0 and column 0 of M(8), as printed in
 * textbooks, and each value once. */
TEST(bayer_matrix)
{
    static const unsigned row[8] = {0, 32, 8, 40, 2, 34, 10, 42}, column[8] = {0, 48, 12, 60, 3, 51, 15, 63};
    uint64_t seen = 0;

    for (unsigned i = 0; i < 8; i++) {
        CHECK_EQ(oracle_bayer(i, 0), row[i]);
        CHECK_EQ(oracle_bayer(0, i), column[i]);
        for (unsigned j = 0; j < 8; j++)
            seen |= UINT64_C(1) << oracle_bayer(i, j);
    }
    CHECK(seen == UINT64_MAX);
    CHECK_EQ(oracle_bayer(9, 18), oracle_bayer(1, 2));
}

TEST(background_is_quantised_to_nearest)
{
    struct tia_scene scene = {.camera = {.fov = TIA_Q16(90)}, .background = TIA_RGB(0.8, 0.5, 0.25)};
    struct oracle_pixel p = oracle_pixel(&scene, 1, 1, 0, 0, false);

    CHECK_EQ(p.object, TIA_NO_OBJECT);
    CHECK_EQ(p.sphere, TIA_NO_OBJECT);
    CHECK_EQ(p.colour >> 11, 25);     /* 24.8 */
    CHECK_EQ(p.colour >> 5 & 63, 32); /* 31.5: halves go up */
    CHECK_EQ(p.colour & 31, 8);       /* 7.75 */
}

/* A channel of 0.3 is 9.3 levels of 31: a threshold (b + 0.5)/64 > 0.7 gives 10, that is b >= 45, in 19 of the 64
 * cells. */
TEST(dithering_shares_out_the_fraction)
{
    struct tia_scene scene = {.camera = {.fov = TIA_Q16(90)}, .background = TIA_RGB(0.3, 1, 0)};
    unsigned up = 0;

    for (unsigned i = 0; i < 64; i++) {
        tia_rgb565 colour = oracle_pixel(&scene, 8, 8, i & 7, i >> 3, true).colour;
        up += colour >> 11 == 10;
        CHECK_EQ(colour >> 11, oracle_bayer(i & 7, i >> 3) >= 45 ? 10 : 9);
        CHECK_EQ(colour >> 5 & 63, 63);
        CHECK_EQ(colour & 31, 0);
    }
    CHECK_EQ(up, 19);
}

/* With the light at the eye, the ball's nearest point faces it, so the colour is the surface's own. */
TEST(light_from_the_front)
{
    struct tia_light light = {TIA_VEC3(0, 0, 0), 0, TIA_RGB(1, 1, 1)};
    struct tia_scene scene = one_ball(&ball, &light, 1);
    struct oracle_pixel p = oracle_pixel(&scene, 1, 1, 0, 0, false);

    CHECK_EQ(p.object, 0);
    CHECK_EQ(p.path_hash, 1);
    NEAR(p.depth, 7);
    NEAR(p.linear[0], 0.5);
    CHECK_EQ(p.colour, 16 << 11 | 32 << 5 | 16);
}

/* At P = (0, 0, -7) the normal is (0, 0, 1). A light at P + (3, 0, 4) arrives at cosine 4/5, one at P + (1, 0, 0) at 0,
 * one behind the ball not at all. */
TEST(lambert_cosine)
{
    struct tia_light lights[3] = {{TIA_VEC3(3, 0, -3), 0, TIA_RGB(1, 0.5, 0.25)},
                                  {TIA_VEC3(1, 0, -7), 0, TIA_RGB(1, 1, 1)},
                                  {TIA_VEC3(0, 0, -30), 0, TIA_RGB(1, 1, 1)}};
    struct tia_scene scene = one_ball(&ball, lights, 3);
    struct oracle_pixel p = oracle_pixel(&scene, 1, 1, 0, 0, false);

    CHECK_EQ(p.path_hash, 1);
    NEAR(p.linear[0], 0.4);
    NEAR(p.linear[1], 0.2);
    NEAR(p.linear[2], 0.1);
}

/* Two lights and the surface's own emission add up, and are clamped. */
TEST(lights_and_emission_add_up)
{
    struct tia_material bright = {.colour = TIA_RGB(0.5, 0.5, 1), .emission = TIA_RGB(0.25, 0, 0.5)};
    struct tia_light lights[2] = {{TIA_VEC3(3, 0, -3), 0, TIA_RGB(1, 1, 1)}, {TIA_VEC3(0, 4, -4), 0, TIA_RGB(1, 1, 1)}};
    struct tia_scene scene = one_ball(&ball, lights, 2);

    scene.materials = &bright;
    struct oracle_pixel p = oracle_pixel(&scene, 1, 1, 0, 0, false);
    CHECK_EQ(p.path_hash, 3);
    NEAR(p.linear[0], 0.5 * (0.8 + 0.6) + 0.25);
    NEAR(p.linear[1], 0.5 * (0.8 + 0.6));
    NEAR(p.linear[2], 0.8 + 0.6 + 0.5);
    CHECK_EQ(p.colour & 31, 31);
}

/* A half transparent ball transmits half of the light, two of them a quarter, an opaque one nothing. */
TEST(shadows_and_transmission)
{
    struct tia_material materials[2] = {{.colour = TIA_RGB(1, 1, 1)}, {.transmission = TIA_RGB(0.5, 0, 0.25)}};
    struct tia_sphere spheres[3] = {
        {TIA_VEC3(0, 0, -10), TIA_Q16(1), 0}, {TIA_VEC3(3, 0, -6), TIA_Q16(1), 1}, {TIA_VEC3(6, 0, -3), TIA_Q16(1), 1}};
    struct tia_light light = {TIA_VEC3(9, 0, 0), 0, TIA_RGB(1, 1, 1)}; /* P = (0, 0, -9), the vector to the light is (9,
                                                                          0, 9) */
    struct tia_scene scene = {.camera = {.fov = TIA_Q16(90)},
                              .materials = materials,
                              .spheres = spheres,
                              .lights = &light,
                              .material_count = 2,
                              .sphere_count = 1,
                              .light_count = 1};
    double cosine = sqrt(0.5);

    NEAR(oracle_pixel(&scene, 1, 1, 0, 0, false).linear[0], cosine);
    scene.sphere_count = 3;
    struct oracle_pixel p = oracle_pixel(&scene, 1, 1, 0, 0, false);
    CHECK_EQ(p.path_hash, 1 | (2 + 3) << 16); /* past spheres 1 and 2 */
    NEAR(p.linear[0], cosine / 4);
    NEAR(p.linear[1], 0);
    NEAR(p.linear[2], cosine / 16);
    spheres[2].material = 0; /* now an opaque sphere */
    p = oracle_pixel(&scene, 1, 1, 0, 0, false);
    CHECK_EQ(p.path_hash, 0);
    NEAR(p.linear[0], 0);
}

/* With P = (0, 0, -9) and the light at (9, 0, 0), a ball behind the light casts no shadow, nor does a ball of radius 1
 * whose centre is 1.01 from the segment. */
TEST(only_what_lies_before_the_light_shadows)
{
    struct tia_sphere spheres[2] = {{TIA_VEC3(0, 0, -10), TIA_Q16(1), 0}, {TIA_VEC3(12, 0, 3), TIA_Q16(1), 0}};
    struct tia_light light = {TIA_VEC3(9, 0, 0), 0, TIA_RGB(1, 1, 1)};
    struct tia_scene scene = one_ball(spheres, &light, 1);

    scene.sphere_count = 2;
    CHECK_EQ(oracle_pixel(&scene, 1, 1, 0, 0, false).path_hash, 1);
    spheres[1].centre = (struct tia_vec3)TIA_VEC3(4.5, 1.01, -4.5);
    CHECK_EQ(oracle_pixel(&scene, 1, 1, 0, 0, false).path_hash, 1);
    spheres[1].centre = (struct tia_vec3)TIA_VEC3(4.5, 0.99, -4.5);
    CHECK_EQ(oracle_pixel(&scene, 1, 1, 0, 0, false).path_hash, 0);
}

/* Two equal spheres are a tie, which the first wins. A light in the same position loses to the sphere. */
TEST(ties_go_to_the_lower_index)
{
    struct tia_sphere spheres[2] = {ball, ball};
    struct tia_light light = {ball.centre, ball.radius, TIA_RGB(1, 1, 1)};
    struct tia_scene scene = one_ball(spheres, &light, 1);

    scene.sphere_count = 2;
    CHECK_EQ(oracle_pixel(&scene, 1, 1, 0, 0, false).object, 0);
}

TEST(lights_are_seen)
{
    struct tia_light lights[2] = {{TIA_VEC3(0, 0, -20), TIA_Q16(1), TIA_RGB(1, 1, 1)},
                                  {TIA_VEC3(0, 0, -4), TIA_Q16(1), TIA_RGB(1, 0, 1.5)}};
    struct tia_scene scene = one_ball(&ball, lights, 1);

    CHECK_EQ(oracle_pixel(&scene, 1, 1, 0, 0, false).object, 0);
    scene.light_count = 2;
    struct oracle_pixel p = oracle_pixel(&scene, 1, 1, 0, 0, false);
    CHECK_EQ(p.object, 2);
    CHECK_EQ(p.sphere, 0);
    CHECK_EQ(p.path_hash, UINT32_C(0xffff0001));
    CHECK_EQ(p.colour, 0xf81f);
    lights[1].radius = 0;
    CHECK_EQ(oracle_pixel(&scene, 1, 1, 0, 0, false).object, 0);
}

/* A scene and its eye, moved together, give the same picture. */
TEST(the_eye_moves)
{
    struct tia_sphere moved = {TIA_VEC3(5, -7, -1), TIA_Q16(3), 0};
    struct tia_scene scene = one_ball(&moved, NULL, 0);

    scene.camera.eye = (struct tia_vec3)TIA_VEC3(5, -7, 9);
    struct oracle_pixel p = oracle_pixel(&scene, 1, 1, 0, 0, false);
    CHECK_EQ(p.object, 0);
    NEAR(p.depth, 10 - q16_unit(moved.radius));
}

int main(void)
{
    RUN(primary_ray_of_a_single_pixel_leads_straight_ahead);
    RUN(primary_ray_of_a_corner);
    RUN(primary_ray_depends_on_the_field_of_view);
    RUN(geometric_hits_by_pencil);
    RUN(analytic_hits_by_pencil);
    RUN(both_forms_agree_on_a_ball);
    RUN(both_forms_agree_on_the_ground);
    RUN(bayer_matrix);
    RUN(background_is_quantised_to_nearest);
    RUN(dithering_shares_out_the_fraction);
    RUN(light_from_the_front);
    RUN(lambert_cosine);
    RUN(lights_and_emission_add_up);
    RUN(shadows_and_transmission);
    RUN(only_what_lies_before_the_light_shadows);
    RUN(ties_go_to_the_lower_index);
    RUN(lights_are_seen);
    RUN(the_eye_moves);
    return check_status();
}
