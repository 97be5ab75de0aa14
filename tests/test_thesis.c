/* The built-in scene after each of its keys, q16 and f64, against the oracle's picture of the scene
 * as it is written below: typed in once more, so that the built-in one is tested too. */
#include "check.h"
#include "common/corpus.h"
#include "common/threads.h"
#include "oracle/against.h"

#define WIDTH 640
#define HEIGHT 480

static const struct tia_material materials[2] = {{.colour = TIA_RGB(0.6, 0.6, 0.6)}, {.colour = TIA_RGB(1, 1, 1)}};
static const struct tia_sphere spheres[2] = {{TIA_VEC3(0, -10004, -20), TIA_Q16(10000), 0},
                                             {TIA_VEC3(0, -1, -20), TIA_Q16(3), 1}};

static const struct {
    char key;
    struct tia_vec3 light;
} lit[] = {{'a', TIA_VEC3(-20, 20, -20)},
           {'d', TIA_VEC3(20, 20, -20)},
           {'s', TIA_VEC3(0, 20, -8)},
           {'w', TIA_VEC3(0, 20, -32)}};

static struct threads *pool;

static void compare(const struct tia_core *core, const char *keys, const struct tia_light *light, unsigned wrong,
                    unsigned flips)
{
    struct tia_scene truth = {.camera = {.fov = TIA_Q16(25)},
                              .background = TIA_RGB(0.8, 0.8, 0.8),
                              .materials = materials,
                              .spheres = spheres,
                              .lights = light,
                              .material_count = 2,
                              .sphere_count = 2,
                              .light_count = light != NULL};
    struct corpus_scene c;
    struct against a;

    CHECK_EQ(corpus_thesis(&c, keys, WIDTH, HEIGHT), TIA_OK);
    CHECK_EQ(against_oracle(core, &c.scene, &truth, WIDTH, HEIGHT, false, &threads_workers, pool, &a), TIA_OK);
    CHECK_EQ(a.pixels, WIDTH * HEIGHT);
    CHECK_MSG(a.pixels - a.identical <= wrong, "%ju pixels differ", (uintmax_t)(a.pixels - a.identical));
    CHECK_MSG(a.flips <= flips, "%ju flips", (uintmax_t)a.flips);
    CHECK_EQ(a.stray, 0);
}

static void compare_lit(const struct tia_core *core, char key, unsigned wrong, unsigned flips)
{
    char keys[2] = {key, '\0'};

    for (size_t i = 0; i < sizeof lit / sizeof lit[0]; i++) {
        struct tia_light light = {lit[i].light, TIA_Q16(3), TIA_RGB(1, 1, 1)};
        if (lit[i].key == key)
            compare(core, keys, &light, wrong, flips);
    }
}

TEST(q16_without_light)
{
    compare(&tia_core_q16, "", NULL, 0, 0);
}
TEST(q16_light_above_left)
{
    compare_lit(&tia_core_q16, 'a', 0, 0);
}
TEST(q16_light_above_right)
{
    compare_lit(&tia_core_q16, 'd', 0, 0);
}
TEST(q16_light_near_the_eye)
{
    compare_lit(&tia_core_q16, 's', 0, 0);
}
TEST(q16_light_far_from_the_eye)
{
    compare_lit(&tia_core_q16, 'w', 2, 0);
}

#ifdef TIA_HAVE_F64
TEST(f64_without_light)
{
    compare(&tia_core_f64, "", NULL, 0, 0);
}
TEST(f64_light_above_left)
{
    compare_lit(&tia_core_f64, 'a', 0, 0);
}
TEST(f64_light_above_right)
{
    compare_lit(&tia_core_f64, 'd', 0, 0);
}
TEST(f64_light_near_the_eye)
{
    compare_lit(&tia_core_f64, 's', 0, 0);
}
TEST(f64_light_far_from_the_eye)
{
    compare_lit(&tia_core_f64, 'w', 0, 0);
}
#endif

int main(void)
{
    pool = threads_create(threads_processors());
    RUN(q16_without_light);
    RUN(q16_light_above_left);
    RUN(q16_light_above_right);
    RUN(q16_light_near_the_eye);
    RUN(q16_light_far_from_the_eye);
#ifdef TIA_HAVE_F64
    RUN(f64_without_light);
    RUN(f64_light_above_left);
    RUN(f64_light_above_right);
    RUN(f64_light_near_the_eye);
    RUN(f64_light_far_from_the_eye);
#endif
    threads_destroy(pool);
    return check_status();
}
