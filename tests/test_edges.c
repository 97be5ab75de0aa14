/* Scenes at the edges of what is accepted, q16 and f64 against the oracle: the eye or a light inside a ball, the
 * smallest and the farthest objects, the narrowest and the widest view, ties, many lights, and small pictures of
 * thousands of scenes drawn from all magnitudes. */
#include "against.h"
#include "check.h"
#include "common/thread_pool.h"
#include "random.h"

#include <stdlib.h>

#define SPHERES 64
#define LIGHTS 40

static struct threads *pool;
static unsigned wild_scenes = 1000;

static struct tia_material materials[4] = {
    {.colour = TIA_RGB(0.6, 0.6, 0.6)},
    {.colour = TIA_RGB(1, 0.5, 0.25), .transmission = TIA_RGB(0.75, 0.5, 0)},
    {.colour = TIA_RGB(0.25, 0.75, 0.5), .emission = TIA_RGB(0.125, 0, 0.25)},
    {.colour = TIA_RGB(0.5, 1, 0.5), .transmission = TIA_RGB(0, 0.5, 1), .emission = TIA_RGB(0, 0.25, 0)}};

/* Arrays of the scene, which each case fills in. */
static struct tia_sphere spheres[SPHERES];
static struct tia_light lights[LIGHTS];
static struct tia_scene scene;

static void start(double fov)
{
    scene = (struct tia_scene){.camera = {.fov = TIA_Q16(fov)},
                               .background = TIA_RGB(0.3, 0.5, 0.7),
                               .materials = materials,
                               .spheres = spheres,
                               .lights = lights,
                               .material_count = 4};
}

static void ball(double x, double y, double z, double radius, uint32_t material)
{
    spheres[scene.sphere_count++] = (struct tia_sphere){TIA_VEC3(x, y, z), TIA_Q16(radius), material};
}

static void light(double x, double y, double z, double radius, double bright)
{
    lights[scene.light_count++] =
        (struct tia_light){TIA_VEC3(x, y, z), TIA_Q16(radius), TIA_RGB(bright, bright, bright)};
}

/* Compares pictures: every pixel must be the oracle's, except those on an outline, where the oracle is undecided. */
static void compare(const struct tia_core *core, unsigned width, unsigned height)
{
    struct against a;
    const struct tally *t = &a.tally;

    CHECK_EQ(tia_scene_check(&scene, NULL), TIA_OK);
    CHECK_EQ(against_oracle(core, &scene, width, height, false, threads_workers(pool), &a), TIA_OK);
    against_list(core->name, &a);
    CHECK_MSG(t->pixels - t->identical <= a.undecided, "%s: %ju pixels differ", core->name,
              (uintmax_t)(t->pixels - t->identical));
    CHECK_MSG(t->flips == a.undecided, "%s: %ju flips", core->name, (uintmax_t)t->flips);
}

static void compare_both(unsigned width, unsigned height)
{
    compare(&tia_core_q16, width, height);
#ifdef TIA_HAVE_F64
    compare(&tia_core_f64, width, height);
#endif
}

TEST(eye_inside_a_ball)
{
    start(90);
    ball(1, 0, -2, 5, 0);
    ball(0, 0.5, -3, 1, 2);
    light(-1, 1, 1, 0, 1);
    light(20, 10, 5, 1, 1);
    compare_both(160, 120);
}

/* The ball's centre is behind some of the rays: those pass through its wall, as in step 2 of the algorithm. */
TEST(eye_inside_a_ball_whose_centre_is_behind)
{
    start(120);
    ball(1, 0.5, 2, 5, 0);
    ball(0, 0, -10, 4, 2);
    light(5, 5, 0, 0, 1);
    compare_both(160, 120);
}

TEST(eye_inside_two_overlapping_balls)
{
    start(100);
    ball(2, 0, -1, 4, 0);
    ball(-2, 0, -1, 4, 1);
    ball(0, 1, -1.5, 4, 3);
    light(1, 6, -3, 0, 1);
    light(-9, 0, 2, 0, 1);
    compare_both(160, 120);
}

TEST(light_inside_a_ball)
{
    start(60);
    ball(0, -1004, -20, 1000, 0);
    ball(0, 0, -20, 3, 1);
    ball(4, 0, -22, 3, 0);
    light(0.5, 1, -19, 1, 1);
    light(2.5, 0, -20.5, 0.25, 1);
    compare_both(160, 120);
}

TEST(light_below_the_ground_and_behind_the_eye)
{
    start(60);
    ball(0, -1004, -20, 1000, 0);
    ball(0, 0, -20, 3, 3);
    light(0, -10, -20, 3, 1);
    light(1, 1, 30, 3, 1);
    compare_both(160, 120);
}

TEST(eye_inside_a_light)
{
    start(60);
    ball(0, 0, -3, 2, 0);
    light(0, 0.5, -1, 3, 0.5);
    compare_both(160, 120);
}

/* A ball of 2^-10, the smallest radius, is visible with its shadow and one pixel. */
TEST(smallest_balls)
{
    start(30);
    ball(0, 0, -0.0078125, 0.0009765625, 2);
    ball(0.001953125, 0, -0.01171875, 0.0009765625, 0);
    ball(1, 1, -3, 0.0009765625, 2);
    light(0.0625, 0.03125, 0, 0.0009765625, 1);
    compare_both(160, 120);
}

TEST(farthest_things)
{
    start(50);
    ball(0, 0, -30000, 2000, 0);
    ball(3000, 0, -24000, 2500, 2);
    ball(0, -10000, -9000, 9990, 1);
    light(-8000, 9000, -20000, 1000, 1);
    light(0, 0, 32000, 0, 1);
    compare_both(160, 120);
}

/* A light like the sun: seen from its position, a ball's outline lies in the last bits of an angle. */
TEST(distant_light)
{
    start(25);
    ball(0, -10004, -20, 10000, 0);
    ball(0, -1, -20, 3, 2);
    light(-600, 700, -300, 0, 1);
    compare_both(320, 240);
    lights[0].centre = (struct tia_vec3)TIA_VEC3(-2400, 2800, -1200);
    compare_both(320, 240);
    lights[0].centre = (struct tia_vec3)TIA_VEC3(-12000, 14000, -6000);
    compare_both(320, 240);
}

TEST(narrowest_and_widest_view)
{
    start(1);
    ball(0, -10004, -20, 10000, 0);
    ball(0, 0, -200, 1, 2);
    light(10, 10, -180, 3, 1);
    compare_both(160, 120);
    scene.camera.fov = TIA_FOV_MAX;
    compare_both(160, 120);
}

/* The same ball three times, two balls with one centre, a light at a ball's position. */
TEST(equal_balls)
{
    start(40);
    ball(-3, 0, -20, 2, 3);
    ball(-3, 0, -20, 2, 0);
    ball(-3, 0, -20, 2, 1);
    ball(3, 0, -20, 2, 0);
    ball(3, 0, -20, 3, 1);
    light(3, 0, -20, 3, 1);
    light(0, 5, -10, 0, 0.5);
    compare_both(160, 120);
}

/* Two equal lights, and one that covers them: the nearest is visible, and of equal ones that of the lower index. */
TEST(lights_in_sight)
{
    start(40);
    ball(0, -10004, -20, 10000, 0);
    ball(0, 0, -20, 2, 2);
    light(1, 1, -18, 1, 0.25);
    light(1, 1, -18, 1, 0.5);
    light(2, 1.5, -17, 1, 0.75);
    light(-2, 1.5, -21, 2, 1);
    compare_both(160, 120);
}

/* There are more lights than bits in `path_hash`, and together they are brighter than white. */
TEST(forty_lights)
{
    start(40);
    ball(0, -10004, -20, 10000, 0);
    ball(0, 0, -20, 3, 2);
    ball(4, -2, -16, 1, 1);
    for (int i = 0; i < LIGHTS; i++)
        light(i * 2 - 39, 10 + i % 5, -10 - i % 7, 0, i % 3 == 0 ? 0.01 : 0.06);
    compare_both(160, 120);
}

/* 4 x 4 x 4 balls, each touching its neighbours. */
TEST(lattice_of_touching_balls)
{
    start(60);
    scene.camera.eye = (struct tia_vec3)TIA_VEC3(1, 2, 3);
    for (int i = 0; i < SPHERES; i++)
        ball((i & 3) * 2 - 3, (i >> 2 & 3) * 2 - 3, (i >> 4) * 2 - 12, 1, (uint32_t)i % 4);
    light(-6, 9, 2, 1, 1);
    light(0, 0, -9, 0, 0.5);
    compare_both(160, 120);
}

TEST(odd_sizes)
{
    static const unsigned sizes[][2] = {{1, 1}, {1, 480}, {641, 1}, {7, 3}, {257, 129}, {8192, 2}, {2, 8192}};

    start(25);
    ball(0, -10004, -20, 10000, 0);
    ball(0, -1, -20, 3, 2);
    light(-20, 20, -20, 3, 1);
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        compare_both(sizes[i][0], sizes[i][1]);
}

/* Returns a value of any magnitude from 2^-16 to 2^bits, either sign. */
static tia_q16 any(unsigned bits)
{
    int32_t size = (int32_t)(random_bits() >> 33 >> (random_bits() % (15 + bits) + 15 - bits));

    return random_bits() & 1 ? -size : size;
}

static void wild_scene(unsigned index)
{
    random_state = index;
    start(1 + (double)(random_bits() % 169));
    scene.camera.eye = (struct tia_vec3){any(12), any(12), any(12)};
    scene.sphere_count = 1 + (uint32_t)(random_bits() % 8);
    for (uint32_t i = 0; i < scene.sphere_count; i++) {
        struct tia_vec3 c = {any(11), any(11), any(11)};
        tia_q16 away = any(12), radius = any(12);
        spheres[i].centre = (struct tia_vec3){scene.camera.eye.x + c.x, scene.camera.eye.y + c.y,
                                              scene.camera.eye.z - (away < 0 ? -away : away)};
        spheres[i].radius = TIA_RADIUS_MIN + (radius < 0 ? -radius : radius);
        spheres[i].material = random_bits() % 4;
    }
    scene.light_count = (uint32_t)(random_bits() % 4);
    for (uint32_t i = 0; i < scene.light_count; i++) {
        tia_q16 radius = any(8);
        lights[i] = (struct tia_light){
            {scene.camera.eye.x + any(12), scene.camera.eye.y + any(12), scene.camera.eye.z + any(12)},
            radius < TIA_RADIUS_MIN ? 0 : radius,
            TIA_RGB(0.5, 1, 1.75)};
    }
}

/* Compares small pictures by their sums. */
static void compare_wild(const struct tia_core *core)
{
    struct against sum = {0}, a;
    const struct tally *t = &sum.tally;
    char name[32];

    for (unsigned i = 0; i < wild_scenes; i++) {
        wild_scene(i);
        CHECK_MSG(!tia_scene_check(&scene, NULL), "scene %u is refused", i);
        CHECK_EQ(against_oracle(core, &scene, 64, 48, false, threads_workers(pool), &a), TIA_OK);
        (void)snprintf(name, sizeof name, "%s scene %u", core->name, i);
        against_list(name, &a);
        against_add(&sum, &a);
    }
    printf("%s: %u scenes, %ju pixels, %ju identical, %ju flips (%ju undecided), %ju stray\n", core->name, wild_scenes,
           (uintmax_t)t->pixels, (uintmax_t)t->identical, (uintmax_t)t->flips, (uintmax_t)sum.undecided,
           (uintmax_t)t->stray);
    CHECK_MSG(t->pixels - t->identical <= sum.undecided, "%ju pixels differ", (uintmax_t)(t->pixels - t->identical));
    CHECK_MSG(t->flips <= sum.undecided, "%ju flips", (uintmax_t)t->flips);
    CHECK_EQ(t->stray, 0);
}

/* Balls are not much larger than the bias, 2^-13, and lit from thousands of units away. */
TEST(wild_scenes_in_q16)
{
    compare_wild(&tia_core_q16);
}

#ifdef TIA_HAVE_F64
TEST(wild_scenes_in_f64)
{
    compare_wild(&tia_core_f64);
}
#endif

int main(int argc, char **argv)
{
    wild_scenes = (unsigned)check_number(argc, argv, 1, wild_scenes);
    pool = threads_create(threads_processors());
    RUN(eye_inside_a_ball);
    RUN(eye_inside_a_ball_whose_centre_is_behind);
    RUN(eye_inside_two_overlapping_balls);
    RUN(light_inside_a_ball);
    RUN(light_below_the_ground_and_behind_the_eye);
    RUN(eye_inside_a_light);
    RUN(smallest_balls);
    RUN(farthest_things);
    RUN(distant_light);
    RUN(narrowest_and_widest_view);
    RUN(equal_balls);
    RUN(lights_in_sight);
    RUN(forty_lights);
    RUN(lattice_of_touching_balls);
    RUN(odd_sizes);
    RUN_LONG(wild_scenes_in_q16);
#ifdef TIA_HAVE_F64
    RUN_LONG(wild_scenes_in_f64);
#endif
    threads_destroy(pool);
    return check_status();
}
