/* The pixels of src/exact: against the definition's formulas in 113 bits, and ties, whose pixels follow from the page
 * by hand.
 *
 *     test_exact_pixel [N]    N edge scenes, by default 1200, and as many of span_regimes.h */
#include "check.h"
#include "common/corpus/corpus.h"
#include "exact_truth.h"
#include "random.h"
#include "render/core/dither.h"
#include "span_regimes.h"

static unsigned scenes = 1200;

#if TRUTH_KNOWN

static unsigned long tried, open, wide;

/* Compares every `step`th pixel of a picture. */
static void compare(const char *what, unsigned number, const struct tia_scene *scene, unsigned width, unsigned height,
                    bool dither, unsigned step)
{
    struct exact_picture picture = {.scene = scene,
                                    .lights = scene->lights,
                                    .light_count = scene->light_count,
                                    .width = (int)width,
                                    .height = (int)height};
    struct truth_pixel truth;

    tia_exact_depth(&picture.depth, height, scene->camera.fov);
    truth_picture(&picture, &truth);
    for (unsigned i = number % step; i < width * height; i += step) {
        int x = (int)(i % width), y = (int)(i / width);
        struct exact_cost cost = {0, false};
        num_u threshold[8];
        dither_thresholds(dither, y, threshold);
        tia_q30 half = (tia_q30)threshold[x & 7];
        tia_rgb565 got = tia_exact_pixel(&picture, x, y, half, &cost), want = truth_pixel_at(&truth, x, y, half);
        tried++;
        open += truth.open;
        CHECK_MSG(got == want || truth.open, "%s %u (%d, %d): %04x, not %04x", what, number, x, y, got, want);
        CHECK_MSG(truth.open || cost.words <= 4, "%s %u (%d, %d): %d words", what, number, x, y, cost.words);
        wide += cost.words > 2;
    }
}

static void compare_some(const char *what, unsigned number, const struct tia_scene *scene, unsigned width,
                         unsigned height, bool dither)
{
    compare(what, number, scene, width, height, dither, 1 + width * height / 60);
}

TEST(scenes_of_any_magnitude)
{
    regimes_each(check_count(scenes), compare_some);
}

TEST(random_corpus)
{
    static struct corpus_scene s;

    for (unsigned i = 0; i < 12; i++) {
        corpus_random(&s, 7, i);
        compare("random", i, &s.scene, s.width, s.height, i & 1, 4999);
    }
}

TEST(the_built_in_scene)
{
    static const char *const keys[] = {"", "a", "d", "s", "w"};
    struct corpus_scene s;

    for (unsigned k = 0; k < 5; k++) {
        CHECK_EQ(corpus_thesis(&s, keys[k], 640, 480), TIA_OK);
        compare("thesis", k, &s.scene, 640, 480, k & 1, 311);
    }
}

/* 113 bits leave few pixels open, and 64 bits decide most. */
TEST(few_pixels_are_hard)
{
    printf("# %lu pixels, %lu open in 113 bits, %lu by more than 64 bits\n", tried, open, wide);
    CHECK(tried > 10000 && open * 200 < tried && wide * 10 < tried);
}

#endif

/* ---- ties ---- */

#define UNIT(x) ((int32_t)(65536 * (x)))

/* A picture of odd sizes: its middle pixel looks along the axis -z. */
static struct tia_material materials[3];
static struct tia_sphere spheres[3];
static struct tia_light lights[2];
static struct tia_scene scene;
static struct exact_cost cost;

static void start(void)
{
    materials[0] = (struct tia_material){.colour = TIA_RGB(1, 1, 1), .emission = TIA_RGB(0, 0, 0)};
    materials[1] = (struct tia_material){.emission = TIA_RGB(1, 0, 0)};
    materials[2] = (struct tia_material){.emission = TIA_RGB(0, 1, 0)};
    scene = (struct tia_scene){.materials = materials,
                               .spheres = spheres,
                               .lights = lights,
                               .material_count = 3,
                               .camera = {.fov = TIA_Q16(90)}};
}

static void ball(int32_t x, int32_t y, int32_t z, int32_t radius, uint32_t material)
{
    spheres[scene.sphere_count++] = (struct tia_sphere){{x, y, z}, radius, material};
}

static void light(int32_t x, int32_t y, int32_t z)
{
    lights[scene.light_count++] = (struct tia_light){{x, y, z}, 0, TIA_RGB(1, 1, 1)};
}

static struct exact_picture picture_of(int width, int height)
{
    struct exact_picture picture = {
        .scene = &scene, .lights = lights, .light_count = scene.light_count, .width = width, .height = height};

    CHECK_EQ(tia_scene_check(&scene, NULL), TIA_OK);
    tia_exact_depth(&picture.depth, (uint32_t)height, scene.camera.fov);
    cost = (struct exact_cost){0, false};
    return picture;
}

static tia_rgb565 middle(void)
{
    struct exact_picture picture = picture_of(41, 31);

    return tia_exact_pixel(&picture, 20, 15, TIA_Q30_ONE / 2, &cost);
}

#define RED (31 << 11)
#define GREEN (63 << 5)
#define WHITE 0xffff

/* The axis touches a ball beside it, also with a field of view whose K is irrational. */
TEST(a_ray_that_touches_a_ball_meets_it)
{
    for (int fov = 25; fov < 100; fov += 65) {
        start();
        scene.camera.fov = TIA_Q16(fov);
        ball(UNIT(3), 0, UNIT(-20), UNIT(3), 1);
        CHECK_EQ(middle(), RED);
        spheres[0].radius--;
        CHECK_EQ(middle(), 0);
        spheres[0].radius += 2;
        CHECK_EQ(middle(), RED);
        spheres[0] = (struct tia_sphere){{0, UNIT(-3), 0}, UNIT(3), 1}; /* the eye is on it, and b = 0 */
        CHECK_EQ(middle(), RED);
        spheres[0].centre.z = 1; /* behind the eye */
        CHECK_EQ(middle(), 0);
    }
}

/* Along v = (3, 3, -4), the pixel (3, 0) of 4x4, with the centre s v + p (1, -1, 0), D is 34 (r^2 - 2 p^2), of which
 * b^2 = (34 s)^2 has more than 64 bits: r = 1393 and p = 985 give -34, r = 577 and p = 408 give 34. */
TEST(a_ray_that_almost_touches_a_ball_is_decided)
{
    const int32_t s = 366000001;

    for (int met = 0; met < 2; met++) {
        int32_t p = met ? 408 : 985, r = met ? 577 : 1393;
        start();
        ball(3 * s + p, 3 * s - p, -4 * s, r, 1);
        struct exact_picture picture = picture_of(4, 4);
        CHECK_EQ(tia_exact_pixel(&picture, 3, 0, TIA_Q30_ONE / 2, &cost), met ? RED : 0);
        CHECK_EQ(cost.words, 4);
    }
}

TEST(the_first_of_equally_near_balls_is_visible)
{
    for (int first = 0; first < 2; first++)
        for (int fov = 25; fov < 100; fov += 65) {
            start();
            scene.camera.fov = TIA_Q16(fov);
            for (int i = 0; i < 2; i++)
                ball(0, 0, UNIT(i == first ? -20 : -22), UNIT(i == first ? 3 : 5), 1 + (uint32_t)i);
            CHECK_EQ(middle(), RED);
            spheres[1].centre.z++;
            CHECK_EQ(middle(), GREEN);
            scene.sphere_count = 1; /* a light comes after all balls */
            lights[0] = (struct tia_light){{0, 0, UNIT(-27)}, UNIT(10), TIA_RGB(0, 1, 0)};
            scene.light_count = 1;
            CHECK_EQ(middle(), RED);
            lights[0].radius++;
            CHECK_EQ(middle(), GREEN);
        }
    start();
    ball(UNIT(1), 0, UNIT(-20), UNIT(3), 1); /* at 20 - sqrt(8), both */
    ball(UNIT(-1), 0, UNIT(-20), UNIT(3), 2);
    CHECK_EQ(middle(), RED);
    CHECK_EQ(cost.words, 2);
}

/* Where the light is at the eye, N.w/|w| is 1 in the middle. */
TEST(halves_are_rounded_up)
{
    start();
    ball(0, 0, UNIT(-20), UNIT(3), 0);
    light(0, 0, 0);
    CHECK_EQ(middle(), WHITE);
    lights[0].emission = (struct tia_rgb){TIA_Q30(.5), TIA_Q30(.5), TIA_Q30(.5)};
    CHECK_EQ(middle(), 16 << 11 | 32 << 5 | 16);
    lights[0].emission.r--;
    CHECK_EQ(middle(), 15 << 11 | 32 << 5 | 16);
    lights[0].emission = (struct tia_rgb){TIA_Q30(.25), TIA_Q30(.25), TIA_Q30(.25)};
    lights[1] = lights[0]; /* two lights make the same */
    scene.light_count = 2;
    CHECK_EQ(middle(), 16 << 11 | 32 << 5 | 16);
    scene.light_count = 0; /* a channel without light */
    materials[0].emission = (struct tia_rgb){TIA_Q30(.5), TIA_Q30(.5) - 1, TIA_Q30(.5)};
    CHECK_EQ(middle(), 16 << 11 | 31 << 5 | 16);
    CHECK_EQ(cost.words, 2);
}

TEST(a_light_in_the_tangent_plane_does_not_light)
{
    start();
    ball(0, 0, UNIT(-20), UNIT(3), 0);
    light(UNIT(5), 0, UNIT(-17));
    CHECK_EQ(middle(), 0);
    lights[0].centre.z += 3000; /* N.w/|w| is about .009: half a level of green */
    CHECK_EQ(middle(), 1 << 5);
    lights[0].centre = (struct tia_vec3){0, 0, UNIT(-17)}; /* at the point itself */
    CHECK_EQ(middle(), 0);
}

/* The shadow ray starts at S = (0, 0, -17 + 2^-13) and runs along w = (12, 0, 16), |w| = 20, to a light beside the eye.
 * Across it is the direction (.8, 0, -.6). */
#define BIAS 8
static void aim(int32_t x, int32_t z, int32_t radius, bool black)
{
    start();
    ball(0, 0, UNIT(-20), UNIT(3), 0);
    ball(x, 0, z, radius, 1);
    materials[1].emission = (struct tia_rgb){0, 0, 0};
    light(UNIT(12), 0, UNIT(-1));
    CHECK_EQ(middle(), black ? 0 : (25 << 11 | 50 << 5 | 25)); /* the cosine is .8: 24.8 and 50.4 */
}

TEST(a_shadow_ray_that_touches_a_ball_is_blocked)
{
    aim(UNIT(10), UNIT(-12) + BIAS, UNIT(5), true); /* S + w/2 + 5 across */
    aim(UNIT(10), UNIT(-12) + BIAS, UNIT(5) - 1, false);
    aim(UNIT(10), UNIT(-12) + BIAS, UNIT(5) + 1, true);
}

TEST(a_shadow_ray_that_ends_beside_the_centre_is_not_blocked)
{
    aim(UNIT(8), UNIT(2) + BIAS, UNIT(5), false); /* S + w - 5 across: w.w is a, and the light outside by 2^-13 */
    aim(UNIT(8), UNIT(2) + BIAS - 1, UNIT(5), true);
    aim(UNIT(8), UNIT(2) + BIAS + 1, UNIT(5) + 1, false);
    aim(UNIT(8), UNIT(2) + BIAS, UNIT(5) + BIAS, true); /* the light is in the ball */
}

/* A light on a ball whose centre is beyond the light: it counts as in the ball, which blocks it. */
TEST(a_light_on_a_ball_is_in_it)
{
    aim(UNIT(15), UNIT(3), UNIT(5), true); /* Q + w/4 */
    aim(UNIT(15), UNIT(3), UNIT(5) - 1, false);
}

/* The eye is in a ball and sees its wall in front, with N pointing inwards. A light in the ball or on it arrives, one
 * outside is filtered. */
TEST(inside_a_ball)
{
    for (int side = -1; side < 2; side += 2) {
        start();
        materials[0].transmission = (struct tia_rgb){TIA_Q30(.5), 0, TIA_Q30_ONE};
        ball(0, 0, UNIT(side), UNIT(5), 0);
        light(0, 0, UNIT(1));
        CHECK_EQ(middle(), WHITE);
        lights[0].centre.z = UNIT(5 + side);
        CHECK_EQ(middle(), WHITE);
        lights[0].centre.z++;
        CHECK_EQ(middle(), 16 << 11 | 31);
        lights[0].centre.z = UNIT(-6); /* behind the wall: N.w is below 0 */
        CHECK_EQ(middle(), 0);
    }
}

/* A path has the lights that reach its point, black ones as well, see tia/debug.h. */
TEST(a_black_light_is_in_the_path)
{
    uint32_t hash = 0;

    start();
    ball(0, 0, UNIT(-20), UNIT(3), 0);
    light(0, 0, 0);
    lights[0].emission = (struct tia_rgb){0, 0, 0};
    struct exact_picture picture = picture_of(41, 31);
    CHECK_EQ(tia_exact_shade(&picture, 20, 15, 0, TIA_Q30_ONE / 2, NULL, &hash), 0);
    CHECK_EQ(hash & 0xffff, 1);
}

TEST(costs_of_ties)
{
    start();
    ball(UNIT(3), 0, UNIT(-20), UNIT(3), 1);
    (void)middle();
    CHECK_EQ(cost.words, 2); /* exact in integers */
    aim(UNIT(10), UNIT(-12) + BIAS, UNIT(5), true);
    CHECK(cost.words <= 16);
    printf("# a shadow ray that touches a ball: %d words, %s\n", cost.words, cost.tie ? "a tie" : "decided");
}

int main(int argc, char **argv)
{
    scenes = (unsigned)check_number(argc, argv, 1, scenes);
#if TRUTH_KNOWN
    RUN(scenes_of_any_magnitude);
    RUN(random_corpus);
    RUN(the_built_in_scene);
    RUN(few_pixels_are_hard);
#endif
    RUN(a_ray_that_touches_a_ball_meets_it);
    RUN(a_ray_that_almost_touches_a_ball_is_decided);
    RUN(the_first_of_equally_near_balls_is_visible);
    RUN(halves_are_rounded_up);
    RUN(a_light_in_the_tangent_plane_does_not_light);
    RUN(a_shadow_ray_that_touches_a_ball_is_blocked);
    RUN(a_shadow_ray_that_ends_beside_the_centre_is_not_blocked);
    RUN(a_light_on_a_ball_is_in_it);
    RUN(inside_a_ball);
    RUN(a_black_light_is_in_the_path);
    RUN(costs_of_ties);
    return check_status();
}
