/* Seals: each changed bit of a view, its seal and its scene is an error before anything is drawn. All changes of a
 * region are made in one process, which the test outlives.
 *
 *     TRUST_FULL=yes build/tests/test_seal     also changes each bit of a view without a check, a process each */
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <tia/debug.h>
#include <tia/tia.h>
#include <tia/trust.h>

#include "check.h"
#include "common/scene/scene_load.h"

enum { WIDTH = 16, HEIGHT = 12, FULL_WIDTH = 320, FULL_HEIGHT = 240, VIEW_WORDS = 320 };

/* A scene in memory that can change, and its picture. */
static struct tia_scene scene;
static struct tia_material materials[4];
static struct tia_sphere spheres[4];
static struct tia_binding bindings[8];
static uint64_t view_memory[VIEW_WORDS], hits_memory[FULL_WIDTH * FULL_HEIGHT + 64];
static tia_rgb565 pixels[FULL_WIDTH * FULL_HEIGHT];
static struct tia_seal seal;
static struct tia_sealed sealed = {.view = view_memory,
                                   .view_size = sizeof view_memory,
                                   .hits = hits_memory,
                                   .hits_size = sizeof hits_memory,
                                   .seal = &seal};
static struct tia_tile frame;
static struct tia_surface surface;

static int prepare(uint16_t width, uint16_t height)
{
    struct tia_view *view;

    scene = tia_thesis_scene;
    memcpy(materials, scene.materials, scene.material_count * sizeof *materials);
    memcpy(spheres, scene.spheres, scene.sphere_count * sizeof *spheres);
    memcpy(bindings, scene.bindings, scene.binding_count * sizeof *bindings);
    scene.materials = materials;
    scene.spheres = spheres;
    scene.bindings = bindings;
    frame = (struct tia_tile){0, 0, width, height};
    surface = (struct tia_surface){.pixels = pixels, .step = 2, .pitch = 2 * (ptrdiff_t)width};
    sealed.view_size = tia_view_size(&scene, 1);
    int status = sealed.view_size > sizeof view_memory ? TIA_ERR_MEMORY : TIA_OK;
    if (!status)
        status = tia_view_init(&view, view_memory, sizeof view_memory, &scene, 1, width, height, NULL);
    if (!status)
        status = tia_view_seal(&sealed);
    return status ? status : tia_view_set_lights_checked(&sealed, &scene.bindings[0].state, 1);
}

static uint32_t crc(void)
{
    return tia_crc32(0, pixels, (size_t)frame.width * frame.height);
}

/* What happened after changed bits. */
struct counts {
    unsigned tried, noticed, drawn_right, wrong;
    size_t first_wrong;
};

static void try_bit(struct counts *counts, size_t at, uint32_t empty, uint32_t right)
{
    for (size_t i = 0; i < (size_t)frame.width * frame.height; i++)
        pixels[i] = 0x1234;
    int status = tia_view_draw_checked(&sealed, frame, &surface, NULL);
    counts->tried++;
    if (status == TIA_ERR_DAMAGED && crc() == empty)
        counts->noticed++;
    else if (status == TIA_OK && crc() == right)
        counts->drawn_right++;
    else if (!counts->wrong++)
        counts->first_wrong = at;
}

/* Changes each bit of `memory`, one at a time, in a child; false if the child does not survive it. */
static bool change_all(void *memory, size_t size, struct counts *counts)
{
    int pipes[2], status;
    unsigned char *bytes = memory;
    uint32_t empty, right;

    (void)fflush(NULL);
    memset(counts, 0, sizeof *counts);
    for (size_t i = 0; i < (size_t)frame.width * frame.height; i++)
        pixels[i] = 0x1234;
    empty = crc();
    CHECK_EQ(tia_view_draw_checked(&sealed, frame, &surface, NULL), TIA_OK);
    right = crc();
    if (pipe(pipes))
        return false;
    pid_t child = fork();
    if (child == 0) {
        (void)alarm(100);
        for (size_t bit = 0; bit < 8 * size; bit++) {
            bytes[bit / 8] ^= (unsigned char)(1u << bit % 8);
            try_bit(counts, bit, empty, right);
            bytes[bit / 8] ^= (unsigned char)(1u << bit % 8);
        }
        _exit(write(pipes[1], counts, sizeof *counts) != (ssize_t)sizeof *counts);
    }
    (void)close(pipes[1]);
    bool said = child > 0 && read(pipes[0], counts, sizeof *counts) == (ssize_t)sizeof *counts;
    (void)close(pipes[0]);
    (void)waitpid(child, &status, 0);
    return said && status == 0;
}

/* Every change of `memory` must be noticed. */
static void notices_all(const char *name, void *memory, size_t size)
{
    struct counts counts;

    CHECK_MSG(change_all(memory, size, &counts), "%s: a change ends the program", name);
    CHECK_MSG(counts.noticed == 8 * size && !counts.wrong,
              "%s: %u of %u changes noticed, the first wrong one at bit %zu", name, counts.noticed, counts.tried,
              counts.first_wrong);
}

TEST(changes_of_the_view)
{
    CHECK_EQ(prepare(WIDTH, HEIGHT), TIA_OK);
    notices_all("view", view_memory, sealed.view_size);
}

TEST(changes_of_the_seal)
{
    CHECK_EQ(prepare(WIDTH, HEIGHT), TIA_OK);
    notices_all("seal", &seal, sizeof seal);
}

TEST(changes_of_the_scene)
{
    CHECK_EQ(prepare(WIDTH, HEIGHT), TIA_OK);
    notices_all("scene", &scene, sizeof scene);
    notices_all("materials", materials, scene.material_count * sizeof *materials);
    notices_all("spheres", spheres, scene.sphere_count * sizeof *spheres);
    notices_all("bindings", bindings, scene.binding_count * sizeof *bindings);
}

/* Hits are made anew by each call, so that no change of them matters. */
TEST(changes_of_the_hits)
{
    struct counts counts;
    size_t size;

    CHECK_EQ(prepare(WIDTH, HEIGHT), TIA_OK);
    size = tia_hits_size(&scene, frame);
    CHECK(change_all(hits_memory, size, &counts));
    CHECK_EQ(counts.drawn_right, 8 * size);
}

TEST(without_the_scene)
{
    struct counts counts;

    CHECK_EQ(prepare(WIDTH, HEIGHT), TIA_OK);
    sealed.without_scene = true;
    CHECK_EQ(tia_view_seal(&sealed), TIA_OK);
    notices_all("view", view_memory, sealed.view_size);
    CHECK(change_all(bindings, sizeof *bindings, &counts));
    CHECK_EQ(counts.drawn_right, 8 * sizeof *bindings);
    sealed.without_scene = false;
}

/* A `stop` that changes the last byte of the view, while a row is drawn. */
static bool change_the_view(void *ctx)
{
    unsigned *calls = ctx;

    if (++*calls == 5)
        ((unsigned char *)view_memory)[sealed.view_size - 1] ^= 1;
    return false;
}

TEST(changes_while_drawing)
{
    unsigned calls = 100;
    struct tia_view *view;
    const struct tia_job job = {.stop = change_the_view, .ctx = &calls};

    CHECK_EQ(prepare(WIDTH, HEIGHT), TIA_OK);
    CHECK_EQ(tia_view_init(&view, view_memory, sizeof view_memory, &scene, 1, WIDTH, HEIGHT, &job), TIA_OK);
    CHECK_EQ(tia_view_seal(&sealed), TIA_OK);
    CHECK_EQ(tia_view_draw_checked(&sealed, frame, &surface, NULL), TIA_OK);
    calls = 0;
    CHECK_EQ(tia_view_draw_checked(&sealed, frame, &surface, NULL), TIA_ERR_DAMAGED);
    CHECK(calls > 5);
    CHECK_EQ(tia_view_check(&sealed), TIA_ERR_DAMAGED);
}

TEST(lights_that_are_refused)
{
    struct tia_seal before;
    struct tia_light bad = tia_thesis_scene.bindings[0].state;

    CHECK_EQ(prepare(WIDTH, HEIGHT), TIA_OK);
    before = seal;
    bad.emission.r = INT32_MIN;
    CHECK_EQ(tia_view_set_lights_checked(&sealed, &bad, 1), TIA_ERR_RANGE);
    CHECK(!memcmp(&before, &seal, sizeof seal));
    CHECK_EQ(tia_view_check(&sealed), TIA_OK);
    view_memory[20] ^= 1;
    CHECK_EQ(tia_view_set_lights_checked(&sealed, &scene.bindings[1].state, 1), TIA_ERR_DAMAGED);
    CHECK(!memcmp(&before, &seal, sizeof seal));
}

/* Seals a view of the scene, draws, and checks. */
static void seal_scene(const char *path, const struct tia_scene *s)
{
    const struct tia_tile tile = {0, 0, 8, 6};
    const struct tia_surface few = {.pixels = pixels, .step = 2, .pitch = 16};
    struct tia_seal own;
    struct tia_sealed view = {
        .view_size = tia_view_size(s, s->light_count), .hits_size = tia_hits_size(s, tile), .seal = &own};
    struct tia_view *made;

    view.view = malloc(view.view_size);
    view.hits = malloc(view.hits_size);
    int status = tia_view_init(&made, view.view, view.view_size, s, s->light_count, 8, 6, NULL);
    status = status ? status : tia_view_seal(&view);
    status = status ? status : tia_view_draw_checked(&view, tile, &few, NULL);
    CHECK_MSG(status == TIA_OK, "%s: status %d", path, status);
    free(view.view);
    free(view.hits);
}

/* No renderer changes its view while it draws. */
TEST(each_renderer)
{
    static const char *const paths[] = {"scenes/shadow-volume.tia", "scenes/cornell.tia", "scenes/glass.tia"};
    static struct scene_file file;

    for (unsigned i = 0; i < sizeof paths / sizeof *paths; i++) {
        CHECK_MSG(scene_open(&file, paths[i], TIA_FORMAT_TIA, false) == TIA_OK, "%.300s", file.why);
        if (check_failed)
            return;
        file.scene.integration.spp = 1;
        for (int shadows = 0; i == 0 && tia_shadows_name((enum tia_shadows)shadows); shadows++) {
            file.scene.shadows = (enum tia_shadows)shadows;
            seal_scene(tia_shadows_name((enum tia_shadows)shadows), &file.scene);
        }
        seal_scene(paths[i], &file.scene);
        scene_close(&file);
    }
}

/* ---- each bit of a view of 320x240, without and with checks ---- */

enum outcome { SAME, WRONG, ERROR, CRASH, HANG, OUTCOMES };

static int draw_unchecked(void)
{
    struct tia_hits *hits;
    struct tia_view *view = (struct tia_view *)(void *)view_memory;
    int status = tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, frame);

    return status ? status : tia_view_draw(view, hits, frame, &surface, NULL);
}

static enum outcome change_and_draw(size_t bit, bool checked, uint32_t right)
{
    int state = 0;

    (void)fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        (void)alarm(5);
        ((unsigned char *)view_memory)[bit / 8] ^= (unsigned char)(1u << bit % 8);
        int status = checked ? tia_view_draw_checked(&sealed, frame, &surface, NULL) : draw_unchecked();
        _exit(status ? ERROR : crc() == right ? SAME : WRONG);
    }
    (void)waitpid(child, &state, 0);
    return WIFEXITED(state) ? (enum outcome)WEXITSTATUS(state) : WTERMSIG(state) == SIGALRM ? HANG : CRASH;
}

TEST(each_bit_in_a_process)
{
    CHECK_EQ(prepare(FULL_WIDTH, FULL_HEIGHT), TIA_OK);
    CHECK_EQ(draw_unchecked(), TIA_OK);
    uint32_t right = crc();
    for (int checked = 0; checked < 2; checked++) {
        unsigned seen[OUTCOMES] = {0};
        for (size_t bit = 0; bit < 8 * sealed.view_size; bit++)
            seen[change_and_draw(bit, checked, right) % OUTCOMES]++;
        printf(
            "# %zu bits of a view %s checks: %u the same picture, %u another one, %u errors, %u crashes, %u endless\n",
            8 * sealed.view_size, checked ? "with" : "without", seen[SAME], seen[WRONG], seen[ERROR], seen[CRASH],
            seen[HANG]);
        if (checked)
            CHECK_EQ(seen[ERROR], 8 * sealed.view_size);
        else
            CHECK(seen[WRONG] > 100 && seen[CRASH] > 100);
    }
}

int main(void)
{
    RUN(changes_of_the_view);
    RUN(changes_of_the_seal);
    RUN(changes_of_the_scene);
    RUN(changes_of_the_hits);
    RUN(without_the_scene);
    RUN(changes_while_drawing);
    RUN(lights_that_are_refused);
    RUN(each_renderer);
    if (getenv("TRUST_FULL"))
        RUN(each_bit_in_a_process);
    return check_status();
}
