/* The built-in scene: its contents, and its pictures after each of its keys, by q16 and f64, against those of the
 * oracle. */
#include "against.h"
#include "check.h"
#include "common/corpus/corpus.h"
#include "common/thread_pool.h"

static struct threads *pool;
static unsigned width = 640, height = 480; /* or the two arguments */

static bool is_grey(struct tia_rgb c, tia_q30 level)
{
    return c.r == level && c.g == level && c.b == level;
}

static bool is_at(struct tia_vec3 v, int x, int y, int z)
{
    return v.x == x * TIA_Q16_ONE && v.y == y * TIA_Q16_ONE && v.z == z * TIA_Q16_ONE;
}

static const struct tia_material *material_of(uint32_t sphere)
{
    return &tia_thesis_scene.materials[tia_thesis_scene.spheres[sphere].material];
}

TEST(the_scene)
{
    const struct tia_scene *s = &tia_thesis_scene;

    CHECK(is_at(s->camera.eye, 0, 0, 0));
    CHECK_EQ(s->camera.fov, 25 * TIA_Q16_ONE);
    CHECK(is_grey(s->background, TIA_Q30(0.8)));
    CHECK_EQ(s->sphere_count, 2);
    CHECK_EQ(s->light_count, 0);
    CHECK(is_at(s->spheres[0].centre, 0, -10004, -20));
    CHECK(is_at(s->spheres[1].centre, 0, -1, -20));
    CHECK_EQ(s->spheres[0].radius, 10000 * TIA_Q16_ONE);
    CHECK_EQ(s->spheres[1].radius, 3 * TIA_Q16_ONE);
    CHECK(is_grey(material_of(0)->colour, TIA_Q30(0.6)));
    CHECK(is_grey(material_of(1)->colour, TIA_Q30(1)));
    for (uint32_t i = 0; i < 2; i++)
        CHECK(is_grey(material_of(i)->transmission, 0) && is_grey(material_of(i)->emission, 0));
}

static void tia_check_light(const char *key, int x, int y, int z)
{
    struct corpus_scene c;

    CHECK_EQ(corpus_thesis(&c, key, width, height), TIA_OK);
    CHECK_EQ(c.scene.light_count, 1);
    CHECK_MSG(is_at(c.lights[0].centre, x, y, z), "%s", key);
    CHECK_EQ(c.lights[0].radius, 3 * TIA_Q16_ONE);
    CHECK(is_grey(c.lights[0].emission, TIA_Q30(1)));
}

TEST(its_keys)
{
    tia_check_light("a", -20, 20, -20);
    tia_check_light("d", 20, 20, -20);
    tia_check_light("s", 0, 20, -8);
    tia_check_light("w", 0, 20, -32);
}

/* Compares with the oracle: all pixels are the same. */
static void compare(const struct tia_core *core, const char *keys)
{
    struct corpus_scene c;
    struct against a;
    const struct tally *t = &a.tally;

    CHECK_EQ(corpus_thesis(&c, keys, width, height), TIA_OK);
    CHECK_EQ(against_oracle(core, &c.scene, width, height, false, threads_workers(pool), &a), TIA_OK);
    against_list(core->name, &a);
    CHECK_EQ(t->pixels, width * height);
    CHECK_MSG(t->identical == t->pixels, "%ju pixels differ", (uintmax_t)(t->pixels - t->identical));
    CHECK_EQ(t->flips, 0);
    CHECK_EQ(t->stray, 0);
}

TEST(q16_without_light)
{
    compare(&tia_core_q16, "");
}
TEST(q16_light_above_left)
{
    compare(&tia_core_q16, "a");
}
TEST(q16_light_above_right)
{
    compare(&tia_core_q16, "d");
}
TEST(q16_light_near_the_eye)
{
    compare(&tia_core_q16, "s");
}
/* The exact values of two pixels, mirror images of each other, are within 1.6e-7 of a level of a boundary. */
TEST(q16_light_far_from_the_eye)
{
    compare(&tia_core_q16, "w");
}

#ifdef TIA_HAVE_F64
TEST(f64_without_light)
{
    compare(&tia_core_f64, "");
}
TEST(f64_light_above_left)
{
    compare(&tia_core_f64, "a");
}
TEST(f64_light_above_right)
{
    compare(&tia_core_f64, "d");
}
TEST(f64_light_near_the_eye)
{
    compare(&tia_core_f64, "s");
}
TEST(f64_light_far_from_the_eye)
{
    compare(&tia_core_f64, "w");
}
#endif

int main(int argc, char **argv)
{
    if (argc > 2) {
        width = (unsigned)check_number(argc, argv, 1, width);
        height = (unsigned)check_number(argc, argv, 2, height);
    }
    pool = threads_create(threads_processors());
    RUN(the_scene);
    RUN(its_keys);
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
