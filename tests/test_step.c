/* Lockstep: steps against tia_scene_at and closed forms, saved states, hashes. */
#include <tia/step.h>

#include "arch/frames_play.h"
#include "arch/frames_steps.h"
#include "fall_world.h"
#include "random.h"

#define BALLS 4

static const char room[] =
    "box min -5 -1 -5 max 5 0 5 material m\nbox min -5 0 -5 max -4 9 5 rotate 0 0 3 material m\n"
    "box min 4 0 -5 max 5 9 5 material m\nplane point 0 0 -4 normal 0 0 1 material m\n"
    "plane point 0 0 4 normal 0 0 -1 material m\nplane point 0 9 0 normal 0 -1 0 material m\n"
    "sphere name a centre -2 3 0 radius 0.5 material m\nsphere name b centre 0.25 5 0 radius 0.5 material m\n"
    "sphere name c centre 2 6 0.125 radius 0.75 material m\nsphere name d centre 1 2 1 radius 0.4 material m\n"
    "fall a restitution 1\nfall b velocity -3 1 2 restitution 0.75\nfall c restitution 0.875 mass 0.5\n"
    "fall d velocity 5 0 9 restitution 1 mass 3\ngravity 0 -9.8 0 until 20\n";

static uint64_t steps_memory[4096], other_memory[4096], scene_memory[8192];

static void start(struct tia_steps *steps, const struct tia_scene *scene, void *at)
{
    CHECK(tia_steps_size(scene) <= sizeof steps_memory);
    CHECK_EQ(tia_steps_init(steps, at, sizeof steps_memory, scene), TIA_OK);
}

static bool same_places(const struct tia_scene *a, const struct tia_scene *b)
{
    return !memcmp(a->transforms, b->transforms, a->transform_count * sizeof *a->transforms) &&
           !memcmp(a->shapes, b->shapes, a->shape_count * sizeof *a->shapes) &&
           (a->materials == b->materials ||
            !memcmp(a->materials, b->materials, a->material_count * sizeof *a->materials)) &&
           !memcmp(&a->camera, &b->camera, sizeof a->camera);
}

/* Compares each step with tia_scene_at, which computes all from the beginning. */
static void compare_steps(const struct tia_scene *scene, uint32_t count, uint32_t interval)
{
    struct tia_steps steps;
    struct tia_scene here, there;

    start(&steps, scene, steps_memory);
    for (uint32_t n = 0; n <= count; n++) {
        if (n % interval == 0) {
            CHECK_EQ(tia_steps_scene(&steps, &here, scene_memory, sizeof scene_memory, NULL), TIA_OK);
            CHECK_EQ(tia_scene_at(&there, memory, sizeof memory, scene, (tia_q16)n * 256, NULL), TIA_OK);
            CHECK_MSG(same_places(&here, &there), "step %u", (unsigned)n);
            CHECK(!here.falling && !here.tracks && !here.bvh);
        }
        CHECK_EQ(tia_scene_step(&steps, NULL, 0), TIA_OK);
    }
}

TEST(steps_are_the_scene_at_times)
{
    const struct tia_scene play = frames_play_scene();

    compare_steps(&play, 800, 1);
    open_world(room);
    compare_steps(&world.scene, 1500, 100);
    read_end(&world);
}

/* The end of falling is within a step; a scene without balls has only its number of steps. */
TEST(ends_and_tracks)
{
    struct tia_steps steps;

    open_world("sphere name a centre 0 9 0 radius 0.5 material m\ngravity 0 -8 0 until 0.50390625\nfall a\n");
    compare_steps(&world.scene, 140, 1);
    read_end(&world);
    open_world("sphere name a centre 0 9 0 radius 0.5 material m\nanimate a at 0: 0 9 0  1: 0 0 0\n");
    compare_steps(&world.scene, 300, 7);
    CHECK_EQ(tia_steps_size(&world.scene), 0);
    CHECK_EQ(tia_steps_init(&steps, NULL, 0, &world.scene), TIA_OK);
    CHECK_EQ(tia_steps_saved_size(&steps), TIA_STEPS_HEAD);
    read_end(&world);
}

/* x + v t + g t^2 / 2, and from the push on w (t - s) more. */
TEST(a_push_is_a_change_of_velocity)
{
    const struct tia_push push = {0, TIA_VEC3(-8, 16.5, 1)};
    struct tia_steps steps;
    struct tia_scene now;

    open_world("sphere name a centre 1 100 -2 radius 0.5 material m\ngravity 0.5 -9.75 0.25 until 5\n"
               "fall a velocity 3 2.5 -1\n");
    start(&steps, &world.scene, steps_memory);
    for (uint32_t n = 0; n < 1280; n++) {
        double t = n / 256., s = n > 300 ? t - 300 / 256. : 0;
        CHECK_EQ(tia_steps_scene(&steps, &now, scene_memory, sizeof scene_memory, NULL), TIA_OK);
        struct tia_vec3 c = centre(&now, 0);
        CHECK(fabs(c.x / 65536. - (1 + 3 * t + 0.25 * t * t - 8 * s)) < ULP &&
              fabs(c.y / 65536. - (100 + 2.5 * t - 4.875 * t * t + 16.5 * s)) < ULP &&
              fabs(c.z / 65536. - (-2 - t + 0.125 * t * t + s)) < ULP);
        CHECK_EQ(tia_scene_step(&steps, &push, n == 300), TIA_OK);
    }
    read_end(&world);
}

/* FNV-1a of 64 bits, http://www.isthe.com/chongo/tech/comp/fnv/. */
static uint64_t fnv(const uint8_t *bytes, size_t size)
{
    uint64_t sum = UINT64_C(14695981039346656037);

    for (size_t i = 0; i < size; i++)
        sum = (sum ^ bytes[i]) * UINT64_C(1099511628211);
    return sum;
}

static uint64_t little(const uint8_t *bytes, int count)
{
    return count ? bytes[0] + 256 * little(bytes + 1, count - 1) : 0;
}

/* The bytes are those that step.h lists, and their hash is that of the published algorithm. */
TEST(bytes_and_hash)
{
    static const double places[3] = {1, 100, -2}, velocities[3] = {3, 2.5, -1};
    struct tia_steps steps;
    uint8_t bytes[TIA_STEPS_HEAD + TIA_STEPS_BALL];

    CHECK(fnv((const uint8_t *)"foobar", 6) == UINT64_C(0x85944171f73967e8));
    open_world("sphere name a centre 1 100 -2 radius 0.5 material m\ngravity 0 0 -256 until 5\n"
               "fall a velocity 3 2.5 -1\n");
    start(&steps, &world.scene, steps_memory);
    for (int n = 0; n < 2; n++) {
        CHECK_EQ(tia_steps_saved_size(&steps), sizeof bytes);
        CHECK_EQ(tia_steps_save(&steps, bytes, sizeof bytes), TIA_OK);
        CHECK(!memcmp(bytes, "tis1", 4));
        CHECK_EQ(little(bytes + 4, 4), n);
        CHECK_EQ(little(bytes + 8, 4), 1);
        CHECK_EQ(bytes[12], 0);
        for (int i = 0; i < 3; i++) {
            double g = i == 2 ? -256 : 0, t = n / 256.;
            CHECK_EQ((int64_t)little(bytes + 13 + 8 * i, 8),
                     (int64_t)((places[i] + velocities[i] * t + g * t * t / 2) * 1099511627776.));
            CHECK_EQ((int64_t)little(bytes + 37 + 8 * i, 8), (int64_t)((velocities[i] + g * t) * 4294967296.));
        }
        CHECK(tia_steps_hash(&steps) == fnv(bytes, sizeof bytes));
        CHECK_EQ(tia_scene_step(&steps, NULL, 0), TIA_OK);
    }
    read_end(&world);
}

static tia_q16 kick(void)
{
    return (tia_q16)(random_u32() % (16 * 65536)) - 8 * 65536;
}

static uint32_t make_pushes(struct tia_push pushes[BALLS])
{
    uint32_t count = random_u32() % 40 < BALLS ? random_u32() % (BALLS + 1) : 0;

    for (uint32_t i = 0; i < count; i++)
        pushes[i] = (struct tia_push){random_u32() % BALLS, {kick(), kick(), kick()}};
    return count;
}

/* At random steps the state moves to other memory, which had another state; both continue with the same hashes. */
TEST(saved_at_any_step)
{
    uint8_t bytes[TIA_STEPS_HEAD + BALLS * TIA_STEPS_BALL];
    struct tia_steps one, other;
    unsigned moves = 0;

    open_world(room);
    start(&one, &world.scene, steps_memory);
    start(&other, &world.scene, other_memory);
    for (uint32_t n = 0; n < check_count(5000); n++) {
        struct tia_push pushes[BALLS];
        uint32_t count = make_pushes(pushes);
        if (random_u32() % 8 == 0) {
            moves++;
            memset(bytes, (int)n, sizeof bytes);
            CHECK_EQ(tia_steps_save(&one, bytes, sizeof bytes), TIA_OK);
            memset(other_memory, (int)n, sizeof other_memory);
            start(&other, &world.scene, other_memory);
            for (uint32_t i = random_u32() % 4; i > 0; i--)
                CHECK_EQ(tia_scene_step(&other, pushes, count), TIA_OK);
            CHECK_EQ(tia_steps_restore(&other, bytes, sizeof bytes), TIA_OK);
        }
        CHECK_EQ(tia_scene_step(&one, pushes, count), TIA_OK);
        CHECK_EQ(tia_scene_step(&other, pushes, count), TIA_OK);
        CHECK_MSG(tia_steps_hash(&one) == tia_steps_hash(&other), "step %u", (unsigned)n);
    }
    CHECK(moves > 100);
    read_end(&world);
}

/* A ball that is gone stays gone, whatever pushes it, and after it has been restored; its shape is hidden. */
TEST(a_ball_that_is_gone)
{
    const struct tia_push out = {0, TIA_VEC3(1000, 0, 0)}, back = {0, TIA_VEC3(-1000, 0, 0)};
    uint8_t bytes[TIA_STEPS_HEAD + TIA_STEPS_BALL];
    struct tia_steps steps;
    struct tia_scene now;

    open_world("sphere name a centre 1 0 -2 radius 0.5 material m\ngravity 0 0 0 until 90\nfall a\n");
    start(&steps, &world.scene, steps_memory);
    for (int n = 0; n < 32; n++) /* 32000 a second, 125 a step */
        CHECK_EQ(tia_scene_step(&steps, &out, 1), TIA_OK);
    for (int n = 0; n < 200; n++)
        CHECK_EQ(tia_scene_step(&steps, NULL, 0), TIA_OK);
    CHECK_EQ(tia_steps_save(&steps, bytes, sizeof bytes), TIA_OK);
    CHECK_EQ(bytes[TIA_STEPS_HEAD], 1);
    start(&steps, &world.scene, other_memory);
    CHECK_EQ(tia_steps_restore(&steps, bytes, sizeof bytes), TIA_OK);
    for (int n = 0; n < 9; n++)
        CHECK_EQ(tia_scene_step(&steps, &back, 1), TIA_OK);
    CHECK_EQ(tia_steps_scene(&steps, &now, scene_memory, sizeof scene_memory, NULL), TIA_OK);
    CHECK_EQ(now.shapes[world.scene.falling->balls[0].shape].kind, TIA_MESH);
    CHECK_EQ(tia_steps_save(&steps, bytes, sizeof bytes), TIA_OK);
    CHECK_EQ(little(bytes + 37, 8) >> 32, 32000);
    read_end(&world);
}

/* Tries a saved state with one byte changed; the state must stay. */
static void refuse_bytes(struct tia_steps *steps, const uint8_t *bytes, size_t size, size_t at, int value)
{
    uint8_t wrong[TIA_STEPS_HEAD + BALLS * TIA_STEPS_BALL];
    uint64_t before = tia_steps_hash(steps);

    memcpy(wrong, bytes, sizeof wrong);
    wrong[at] = (uint8_t)value;
    CHECK_MSG(tia_steps_restore(steps, wrong, size) == TIA_ERR_RANGE, "byte %zu as %d", at, value);
    CHECK(tia_steps_hash(steps) == before);
}

TEST(states_that_are_refused)
{
    uint8_t bytes[TIA_STEPS_HEAD + BALLS * TIA_STEPS_BALL];
    struct tia_steps steps;

    open_world(room);
    start(&steps, &world.scene, steps_memory);
    CHECK_EQ(tia_steps_save(&steps, bytes, sizeof bytes), TIA_OK);
    CHECK_EQ(tia_scene_step(&steps, NULL, 0), TIA_OK);
    for (size_t i = 0; i < 4; i++)
        refuse_bytes(&steps, bytes, sizeof bytes, i, bytes[i] + 1);
    refuse_bytes(&steps, bytes, sizeof bytes, 6, 128);       /* 2^23 steps, one too many */
    refuse_bytes(&steps, bytes, sizeof bytes, 8, BALLS + 1); /* balls */
    refuse_bytes(&steps, bytes, sizeof bytes, 11, 1);
    refuse_bytes(&steps, bytes, sizeof bytes, 12, 2);        /* gone */
    refuse_bytes(&steps, bytes, sizeof bytes, 13 + 7, 0x03); /* a centre */
    refuse_bytes(&steps, bytes, sizeof bytes, 13 + 7, 0x80);
    refuse_bytes(&steps, bytes, sizeof bytes, 61 + 24 + 15, 0x7f); /* the next ball's velocity */
    for (size_t size = 0; size < sizeof bytes; size += 7)
        refuse_bytes(&steps, bytes, size, 4, 0);
    bytes[4] = 255, bytes[5] = 255, bytes[6] = 127; /* the last step that there is */
    CHECK_EQ(tia_steps_restore(&steps, bytes, sizeof bytes), TIA_OK);
    CHECK_EQ(tia_scene_step(&steps, NULL, 0), TIA_ERR_RANGE);
    read_end(&world);
}

TEST(misuse)
{
    uint8_t bytes[TIA_STEPS_HEAD + BALLS * TIA_STEPS_BALL];
    const struct tia_push beyond = {BALLS, TIA_VEC3(0, 0, 0)},
                          fast[] = {{0, TIA_VEC3(1, 0, 0)}, {1, TIA_VEC3(0, 0, -1025)}};
    struct tia_steps steps = {0};
    struct tia_scene out;

    open_world(room);
    size_t size = tia_steps_size(&world.scene);
    CHECK(tia_steps_size(NULL) == SIZE_MAX && tia_steps_hash(NULL) == 0 && tia_steps_saved_size(NULL) == SIZE_MAX);
    CHECK_EQ(tia_scene_step(&steps, NULL, 0), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_steps_init(&steps, NULL, size, &world.scene), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_steps_init(&steps, (char *)steps_memory + 1, size, &world.scene), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_steps_init(&steps, steps_memory, size - 1, &world.scene), TIA_ERR_MEMORY);
    CHECK_EQ(tia_steps_init(&steps, steps_memory, size, NULL), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_steps_init(NULL, steps_memory, size, &world.scene), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_steps_init(&steps, steps_memory, size, &world.scene), TIA_OK);
    uint64_t before = tia_steps_hash(&steps);
    CHECK_EQ(tia_scene_step(&steps, NULL, 1), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_scene_step(&steps, &beyond, 1), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_scene_step(&steps, fast, 2), TIA_ERR_RANGE);
    CHECK_EQ(tia_steps_save(&steps, bytes, sizeof bytes - 1), TIA_ERR_MEMORY);
    CHECK_EQ(tia_steps_save(&steps, NULL, sizeof bytes), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_steps_restore(&steps, NULL, sizeof bytes), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_steps_scene(&steps, &out, scene_memory, 1, NULL), TIA_ERR_MEMORY);
    CHECK_EQ(tia_steps_scene(&steps, &out, NULL, sizeof scene_memory, NULL), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_steps_scene(&steps, NULL, scene_memory, sizeof scene_memory, NULL), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_steps_scene(NULL, &out, scene_memory, sizeof scene_memory, NULL), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_steps_scene(&steps, &world.scene, scene_memory, sizeof scene_memory, NULL), TIA_ERR_ARGUMENT);
    CHECK(tia_steps_hash(&steps) == before);
    read_end(&world);
}

#define GOLDEN "tests/golden/steps.hash"

/* Compares with the next line of the file that is no comment. */
static void compare_hash(void *file, uint32_t step, uint64_t hash)
{
    char line[100], want[100];

    do
        CHECK(fgets(line, sizeof line, (FILE *)file) != NULL);
    while (!check_failed && line[0] == '#');
    (void)snprintf(want, sizeof want, "%lu %016llx\n", (unsigned long)step, (unsigned long long)hash);
    CHECK_MSG(!strcmp(line, want), "%s is not %s", want, line);
}

/* As on every processor of tests/slow/arch. */
TEST(pinned_hashes)
{
    FILE *file = fopen(GOLDEN, "r");

    CHECK(file != NULL);
    if (!file)
        return;
    steps_all(compare_hash, file);
    CHECK(fgetc(file) == EOF);
    (void)fclose(file);
}

int main(void)
{
    RUN(steps_are_the_scene_at_times);
    RUN(ends_and_tracks);
    RUN(a_push_is_a_change_of_velocity);
    RUN(bytes_and_hash);
    RUN(saved_at_any_step);
    RUN(a_ball_that_is_gone);
    RUN(states_that_are_refused);
    RUN(misuse);
    RUN(pinned_hashes);
    return check_status();
}
