/* The random scenes: the properties that their header states, and the same scenes on every machine. */
#include "check.h"
#include "common/corpus/corpus.h"
#include "common/corpus/corpus_hard.h"
#include "common/corpus/corpus_ties.h"

#define SCENES 2000

static void within(int64_t value, int64_t low, int64_t high, const char *what, unsigned index)
{
    CHECK_MSG(value >= low && value <= high, "scene %u: %s is %jd", index, what, (intmax_t)value);
}

TEST(values_are_in_their_ranges)
{
    struct corpus_scene c;

    for (unsigned i = 0; i < SCENES; i++) {
        corpus_random(&c, 7, i);
        const struct tia_scene *s = &c.scene;
        within(s->sphere_count, 2, 9, "sphere count", i);
        within(s->light_count, 1, 3, "light count", i);
        within(s->camera.fov, TIA_Q16(10), TIA_Q16(90), "field of view", i);
        within(s->camera.eye.y, TIA_Q16(0.5), TIA_Q16(60), "height of the eye", i);
        within((int64_t)c.width * c.height, 320 * 240, 1920 * 1080, "size", i);
        CHECK_EQ(s->spheres[0].radius, TIA_Q16(10000));
        for (uint32_t k = 1; k < s->sphere_count; k++)
            within(s->spheres[k].radius, TIA_Q16(0.25), TIA_Q16(6), "radius", i);
    }
}

TEST(every_scene_is_accepted)
{
    static void (*const series[])(struct corpus_scene *, uint64_t, unsigned) = {corpus_random, corpus_ties,
                                                                                corpus_hard};
    struct corpus_scene c;
    struct tia_fault fault = {0};

    for (unsigned i = 0; i < 3 * SCENES; i++) {
        series[i % 3](&c, i, i / 3);
        CHECK_MSG(!tia_scene_check(&c.scene, &fault), "scene %u: %s %u: %s: %s", i, fault.thing, fault.index,
                  fault.field, fault.rule);
    }
}

/* True if two balls touch exactly or overlap: (r1 + r2)^2 >= |C1 - C2|^2. */
static bool meet(const struct tia_sphere *a, const struct tia_sphere *b)
{
    int64_t x = (int64_t)a->centre.x - b->centre.x, y = (int64_t)a->centre.y - b->centre.y;
    int64_t z = (int64_t)a->centre.z - b->centre.z, reach = (int64_t)a->radius + b->radius;

    return x * x + y * y + z * z <= reach * reach;
}

TEST(ties_and_hard_scenes_have_the_sizes_of_their_header)
{
    struct corpus_scene c;

    for (unsigned i = 0; i < SCENES; i++) {
        corpus_ties(&c, 3, i);
        within(c.width, 30, 63, "width", i);
        within(c.height, 28, 53, "height", i);
        corpus_hard(&c, 3, i);
        within(c.width, 30, 320, "width", i);
        within(c.height, 28, 240, "height", i);
        within(c.scene.sphere_count, 1, CORPUS_BALLS, "sphere count", i);
        within(c.scene.light_count, 0, CORPUS_LIGHTS, "light count", i);
    }
}

TEST(scenes_have_variety)
{
    struct corpus_scene c;
    unsigned meeting = 0, clear = 0, glowing = 0, hidden_lights = 0;

    for (unsigned i = 0; i < 100; i++) {
        corpus_random(&c, 1, i);
        for (uint32_t k = 1; k < c.scene.sphere_count; k++) {
            meeting += k > 1 && meet(&c.spheres[k], &c.spheres[k - 1]);
            clear += c.materials[k].transmission.r > 0;
            glowing += c.materials[k].emission.r > 0;
        }
        for (uint32_t k = 0; k < c.scene.light_count; k++)
            hidden_lights += c.lights[k].radius == 0;
    }
    CHECK_MSG(meeting > 50, "%u pairs meet", meeting);
    CHECK_MSG(clear > 20, "%u balls let light through", clear);
    CHECK_MSG(glowing > 20, "%u balls glow", glowing);
    CHECK_MSG(hidden_lights > 20, "%u lights cannot be seen", hidden_lights);
}

/* Continues an FNV-1a hash by a value's four bytes, the lowest first. */
static uint32_t hash(uint32_t h, int32_t value)
{
    for (int shift = 0; shift < 32; shift += 8)
        h = (h ^ ((uint32_t)value >> shift & 255)) * 16777619u;
    return h;
}

static uint32_t hash_scene(uint32_t h, const struct corpus_scene *c)
{
    h = hash(hash(hash(h, (int32_t)c->width), (int32_t)c->height), c->scene.camera.fov);
    for (uint32_t k = 0; k < c->scene.sphere_count; k++) {
        h = hash(hash(h, c->spheres[k].centre.x), c->spheres[k].centre.z);
        h = hash(hash(h, c->spheres[k].radius), c->materials[k].transmission.g);
        h = hash(hash(h, c->materials[k].colour.b), c->materials[k].emission.r);
    }
    for (uint32_t k = 0; k < c->scene.light_count; k++)
        h = hash(hash(h, c->lights[k].centre.y), c->lights[k].emission.g);
    return h;
}

static uint32_t hash_series(void (*make)(struct corpus_scene *out, uint64_t seed, unsigned index))
{
    struct corpus_scene c;
    uint32_t h = 2166136261u;

    for (unsigned i = 0; i < 100; i++) {
        make(&c, 1, i);
        h = hash_scene(h, &c);
    }
    return h;
}

/* The hashes of these scenes when the accuracy tables were made. */
TEST(scenes_are_the_same_everywhere)
{
    CHECK_EQ(hash_series(corpus_random), 0xae83ad27);
    CHECK_EQ(hash_series(corpus_ties), 860946059);
    CHECK_EQ(hash_series(corpus_hard), 2242033418);
}

TEST(keys_place_and_move_the_light)
{
    struct corpus_scene c;

    CHECK_EQ(corpus_thesis(&c, "", 640, 480), TIA_OK);
    CHECK_EQ(c.scene.light_count, 0);
    CHECK_EQ(corpus_thesis(&c, "ad", 640, 480), TIA_OK);
    CHECK_EQ(c.scene.light_count, 1);
    CHECK_EQ(c.scene.lights[0].centre.x, TIA_Q16(20));
    CHECK(corpus_thesis(&c, "aq", 640, 480) < 0);
}

int main(void)
{
    RUN(values_are_in_their_ranges);
    RUN(every_scene_is_accepted);
    RUN(ties_and_hard_scenes_have_the_sizes_of_their_header);
    RUN(scenes_have_variety);
    RUN(scenes_are_the_same_everywhere);
    RUN(keys_place_and_move_the_light);
    return check_status();
}
