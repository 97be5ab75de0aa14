/* tia_bvh_build by several workers: the hierarchy is that of one thread, and building can be cancelled. */
#include "common/thread_pool.h"
#include "hierarchy.h"

/* True between enter() and leave(): a second enter() must not come in between. */
static bool inside;

static void run_backwards(void *ctx, void (*job)(void *arg, unsigned index), void *arg, unsigned count)
{
    (void)ctx;
    while (count-- > 0)
        job(arg, count);
}

static bool enter(void *ctx)
{
    (void)ctx;
    CHECK(!inside);
    inside = true;
    return true;
}

static void leave(void *ctx)
{
    (void)ctx;
    inside = false;
}

static const struct tia_workers backwards = {run_backwards, enter, leave, NULL, 1};

static void check_same(const struct tia_bvh_tree *a, const struct tia_bvh_tree *b)
{
    CHECK_EQ(a->node_count, b->node_count);
    CHECK_EQ(a->item_count, b->item_count);
    CHECK(!memcmp(a->nodes, b->nodes, a->node_count * sizeof *a->nodes));
    CHECK(!memcmp(a->items, b->items, a->item_count * sizeof *a->items));
}

/* Checks that the scene's hierarchy by these workers is that of tia_bvh_build. */
static void check_parallel(const struct tia_workers *workers)
{
    const struct tia_bvh *other = NULL;
    size_t size = tia_bvh_size(&scene), used_too = 0;
    void *room = malloc(size); /* of exactly this size: a sanitizer detects a byte too far */

    memset(room, 0x5a, size);
    CHECK_EQ(tia_bvh_build(&other, room, size - 1, &used_too, &scene, &(struct tia_job){.workers = workers}),
             TIA_ERR_MEMORY);
    CHECK_EQ(tia_bvh_build(&other, room, size, &used_too, &scene, &(struct tia_job){.workers = workers}), TIA_OK);
    CHECK_EQ(used_too, used);
    check_same(&other->objects, &bvh->objects);
    for (uint32_t i = 0; i < scene.mesh_count; i++)
        check_same(&other->meshes[i], &bvh->meshes[i]);
    CHECK_EQ(other->unbounded_count, bvh->unbounded_count);
    free(room);
}

static void check_all_workers(void)
{
    build();
    check_parallel(NULL);
    check_parallel(&backwards);
    for (unsigned count = 1; count <= 3; count++) {
        struct threads *pool = threads_create(count);
        CHECK(pool);
        check_parallel(threads_workers(pool));
        threads_destroy(pool);
    }
}

TEST(by_several_threads)
{
    set_everything();
    set_mesh(&meshes[0], 0, MOST);
    set_mesh(&meshes[2], 0, 1);
    check_all_workers();
    set_spheres(MOST);
    check_all_workers();
}

/* Where lists of items are halved, the order of a node's items matters, too. */
TEST(by_several_threads_at_one_place)
{
    set_spheres(MOST);
    for (uint32_t i = 0; i < MOST; i++)
        spheres[i] = (struct tia_sphere){{i < 300 ? (tia_q16)i * ONE : 7, 8, 9}, 100 + (tia_q16)(i % 3), 0};
    check_all_workers();
    set_exponential_spheres();
    check_all_workers();
}

TEST(several_threads_asked_to_stop)
{
    const struct tia_bvh *none = NULL;
    unsigned questions = 100000, all;

    set_spheres(MOST);
    size_t size = tia_bvh_size(&scene);
    void *room = malloc(size);
    CHECK_EQ(tia_bvh_build(&bvh, room, size, NULL, &scene,
                           &(struct tia_job){.workers = &backwards, .stop = count_down, .ctx = &questions}),
             TIA_OK);
    all = 100000 - questions;
    CHECK(all > MOST / 4096);
    for (questions = 1; questions <= all; questions++) {
        unsigned left = questions;
        CHECK_EQ(tia_bvh_build(&none, room, size, NULL, &scene,
                               &(struct tia_job){.workers = &backwards, .stop = count_down, .ctx = &left}),
                 TIA_STOPPED);
        CHECK(!none && !left && !inside);
    }
    free(room);
}

struct countdown {
    unsigned left, after; /* calls of `stop` before it returns true, and later calls */
};

static bool count_after(void *ctx)
{
    struct countdown *c = ctx;
    c->after += c->left == 0;
    c->left -= c->left > 0;
    return c->left == 0;
}

/* With so many faces, the threads call `stop` while they process a part's items together, 32 at a time: once it returns
 * true for one thread, each of the others calls it once more, and none continues with unprocessed items. */
TEST(asked_to_stop_while_looking_together)
{
    enum { FACES = 32 * 5000, BOXES = FACES / 4096 };
    struct tia_face *many = calloc(FACES, sizeof *many);
    const struct tia_bvh *none = NULL;

    set_everything();
    set_mesh(&meshes[0], 0, MOST);
    for (uint32_t i = 0; i < FACES; i++)
        many[i] = faces[random_u32() % MOST];
    scene = (struct tia_scene){.meshes = meshes, .mesh_count = 1};
    meshes[0].faces = many;
    meshes[0].face_count = FACES;
    size_t size = tia_bvh_size(&scene);
    void *room = malloc(size);
    for (unsigned i = BOXES + 2; i < BOXES + 60; i += 7) {
        struct countdown c = {i, 0};
        CHECK_EQ(tia_bvh_build(&none, room, size, NULL, &scene,
                               &(struct tia_job){.workers = &backwards, .stop = count_after, .ctx = &c}),
                 TIA_STOPPED);
        CHECK(!none && !c.left && c.after <= 32);
    }
    free(room);
    free(many);
}

int main(void)
{
    RUN(by_several_threads);
    RUN(by_several_threads_at_one_place);
    RUN_LONG(several_threads_asked_to_stop);
    RUN(asked_to_stop_while_looking_together);
    free(memory);
    return check_status();
}
