/* A scene at each stated limit draws, and one step beyond it is refused by name.
 *
 * At the limit q16 draws the same as f64: where both have the same path, no channel is more than two levels off, and
 * few pixels have a different path; and the checking build draws the same and reports nothing. Scenes too large for a
 * quick test are not drawn: of TIA_OBJECTS_MAX objects only the sizes are checked. */
#include "check.h"
#include "common/corpus/measure.h"
#include "common/thread_pool.h"
#include "reports.h"

#include "limit_cases.h"

#include <tia/bvh.h>
#include <tia/debug.h>

static struct threads *pool;

#define WIDTH 24
#define HEIGHT 18

/* Returns the number of changes of colour along the picture: 0 if no object is visible. */
static unsigned changes(const tia_rgb565 *picture)
{
    unsigned count = 0;

    for (int i = 1; i < WIDTH * HEIGHT; i++)
        count += picture[i] != picture[i - 1];
    return count;
}

static void draws(const char *name)
{
    struct measure what = {.scene = &scene, .width = WIDTH, .height = HEIGHT, .core_count = 2};
    struct tally tallies[2] = {{0}, {0}};
    const struct tally *t = &tallies[0];
    tia_rgb565 picture[WIDTH * HEIGHT];

    what.reference = &tia_core_q16;
#ifdef TIA_HAVE_F64
    what.reference = &tia_core_f64;
#endif
    what.cores[0] = &tia_core_q16;
    what.cores[1] = &tia_core_chk;
    what.workers = threads_workers(pool);
    what.picture = picture;
    reports = 0;
    CHECK_MSG(!measure(&what, tallies), "%s is not drawn", name);
    CHECK_MSG(changes(picture) > 5, "%s: nothing to be seen", name);
    CHECK_MSG(t->stray == 0 || t->astray <= 2, "%s: %u levels off", name, (unsigned)t->astray);
    CHECK_MSG(t->flips * 20 <= t->pixels, "%s: %u other paths", name, (unsigned)t->flips);
    CHECK_MSG(!memcmp(&tallies[0], &tallies[1], sizeof tallies[0]), "%s: the checking build differs", name);
    CHECK_MSG(reports == 0, "%s: %u reports, the first %s", name, reports, first_report);
}

static void refused(unsigned i)
{
    struct tia_fault f = {"", 0, "", ""};
    struct tia_view *view;

    if (tia_scene_check(&scene, &f) != TIA_ERR_RANGE)
        CHECK_MSG(false, "%s: one beyond is accepted", limits[i].name);
    CHECK_MSG(!strcmp(f.thing, limits[i].thing) && f.index == limits[i].index && !strcmp(f.field, limits[i].field) &&
                  !strcmp(f.rule, limits[i].rule),
              "%s: %s %u: %s: %s", limits[i].name, f.thing, (unsigned)f.index, f.field, f.rule);
    CHECK_EQ(tia_view_init(&view, texels, sizeof texels, &scene, 1, WIDTH, HEIGHT, NULL), TIA_ERR_RANGE);
}

TEST(each_limit_draws_and_one_beyond_is_refused)
{
    for (unsigned i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        set_up();
        limits[i].set(0);
        draws(limits[i].name);
        set_up();
        limits[i].set(1);
        refused(i);
    }
}

TEST(images_of_any_size)
{
    static uint64_t memory[8192];
    struct tia_view *view;

    set_up();
    CHECK_EQ(tia_view_init(&view, memory, sizeof memory, &scene, 1, TIA_SIZE_MAX, TIA_SIZE_MAX, NULL), TIA_OK);
    CHECK_EQ(tia_view_init(&view, memory, sizeof memory, &scene, 1, TIA_SIZE_MAX + 1, 1, NULL), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_init(&view, memory, sizeof memory, &scene, 1, 1, TIA_SIZE_MAX + 1, NULL), TIA_ERR_ARGUMENT);
}

/* The largest numbers, 2^24 spheres, shapes or faces, are not drawn. Their memory is checked: a tree of n has 2 n - 1
 * nodes and n items. */
TEST(most_objects)
{
    const uint64_t n = TIA_OBJECTS_MAX, tree = n * 4 + (2 * n - 1) * sizeof(struct tia_bvh_node);
    struct tia_mesh mesh = {.face_count = TIA_OBJECTS_MAX};
    struct tia_fault f;

    set_up();
    scene.sphere_count = TIA_OBJECTS_MAX - 2;
    CHECK(tia_bvh_size(&scene) > tree && tia_bvh_size(&scene) < 2 * tree);
    CHECK(tia_view_size(&scene, 1) < 1 << 16); /* spheres need no prepared data */
    scene.sphere_count++;
    scene.spheres = &sphere;
    CHECK_EQ(tia_scene_check(&scene, &f), TIA_ERR_RANGE);
    CHECK(!strcmp(f.field, "counts"));
    set_up();
    scene.meshes = &mesh;
    scene.mesh_count = 1;
    CHECK(tia_bvh_size(&scene) > tree && tia_bvh_size(&scene) < 2 * tree);
}

int main(void)
{
    pool = threads_create(1);
    for (size_t i = 0; i < sizeof texels; i++)
        texels[i] = (uint8_t)(i * 7);
    for (size_t i = 0; i < sizeof cells; i++)
        cells[i] = i % 3 > 0;
    RUN(each_limit_draws_and_one_beyond_is_refused);
    RUN(images_of_any_size);
    RUN(most_objects);
    threads_destroy(pool);
    return check_status();
}
