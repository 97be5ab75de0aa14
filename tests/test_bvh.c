/* tia_bvh_build: invariants of every hierarchy, hostile scenes, and its memory. */
#include "hierarchy.h"
#include "scene/bvh/split.h"

static bool is_nothing(const struct tia_bounds *b)
{
    return b->max.x < b->min.x;
}

static bool contains(const struct tia_bounds *b, const struct tia_bounds *in)
{
    return is_nothing(in) || (b->min.x <= in->min.x && b->min.y <= in->min.y && b->min.z <= in->min.z &&
                              b->max.x >= in->max.x && b->max.y >= in->max.y && b->max.z >= in->max.z);
}

/* number of times that each item was found */
static unsigned char met[MOST + 40];
static uint32_t deepest, met_nodes;

static void check_leaf(const struct tia_bvh_tree *tree, const struct tia_mesh *mesh, const struct tia_bvh_node *node)
{
    CHECK(node->index + node->count <= tree->item_count);
    for (uint32_t i = 0; i < node->count; i++) {
        uint32_t item = tree->items[node->index + i];
        struct tia_bounds box = box_of(mesh, item);
        CHECK(i == 0 || tree->items[node->index + i - 1] < item);
        CHECK(contains(&node->bounds, &box));
        met[item]++;
    }
}

static void check_node(const struct tia_bvh_tree *tree, const struct tia_mesh *mesh, uint32_t index, uint32_t depth)
{
    const struct tia_bvh_node *node = &tree->nodes[index];

    met_nodes++;
    deepest = depth > deepest ? depth : deepest;
    CHECK(depth <= TIA_BVH_DEPTH_MAX);
    if (check_failed > 0)
        return;
    if (node->count) {
        check_leaf(tree, mesh, node);
        return;
    }
    CHECK(node->index > index + 1 && node->index < tree->node_count);
    CHECK(contains(&node->bounds, &tree->nodes[index + 1].bounds));
    CHECK(contains(&node->bounds, &tree->nodes[node->index].bounds));
    check_node(tree, mesh, index + 1, depth + 1);
    check_node(tree, mesh, node->index, depth + 1);
}

static void check_tree(const struct tia_bvh_tree *tree, const struct tia_mesh *mesh)
{
    deepest = met_nodes = 0;
    memset(met, 0, sizeof met);
    if (tree->node_count)
        check_node(tree, mesh, 0, 0);
    CHECK_EQ(met_nodes, tree->node_count);
    for (uint32_t i = 0; i < tree->item_count; i++)
        CHECK_EQ(met[tree->items[i]], 1);
}

/* Checks that every object is there once, in the tree or beside it. */
static void check_all(void)
{
    uint32_t count = scene.sphere_count + scene.shape_count;

    for (uint32_t i = 0; i < scene.mesh_count; i++) {
        CHECK_EQ(bvh->meshes[i].item_count, meshes[i].face_count);
        check_tree(&bvh->meshes[i], &meshes[i]);
    }
    check_tree(&bvh->objects, NULL);
    for (uint32_t i = 0; i < bvh->unbounded_count; i++) {
        CHECK(i == 0 || bvh->unbounded[i - 1] < bvh->unbounded[i]);
        met[bvh->unbounded[i]]++;
    }
    CHECK_EQ(bvh->objects.item_count + bvh->unbounded_count, count);
    for (uint32_t i = 0; i < count; i++)
        CHECK_EQ(met[i], 1);
}

TEST(spheres_of_all_counts)
{
    for (uint32_t count = 0; count < 40; count++) {
        set_spheres(count);
        build();
        check_all();
        CHECK(count || !bvh->objects.node_count);
    }
    set_spheres(MOST);
    build();
    check_all();
    CHECK(deepest < 32 && bvh->objects.node_count > MOST / 4);
}

TEST(everything)
{
    set_everything();
    build();
    check_all();
    CHECK_EQ(bvh->unbounded_count, 8 - 2 + 1); /* planes 5, 10, ... 30 and sphere 38 */
    CHECK_EQ(bvh->unbounded[0], 105);
    CHECK_EQ(bvh->unbounded[6], 138);
    CHECK_EQ(bvh->meshes[1].node_count, 0);
    CHECK_EQ(bvh->meshes[2].node_count, 1);
}

TEST(memory_as_promised)
{
    set_everything();
    size_t size = tia_bvh_size(&scene);
    unsigned char *room = malloc(size), *again = malloc(size);
    const struct tia_bvh *one, *two;
    size_t used_again;

    CHECK_EQ(tia_bvh_build(&one, room, size - 1, &used, &scene, NULL), TIA_ERR_MEMORY);
    CHECK_EQ(tia_bvh_build(&one, room, 0, &used, &scene, NULL), TIA_ERR_MEMORY);
    /* malloc'ed exactly: a sanitizer detects a byte too far */
    CHECK_EQ(tia_bvh_build(&one, room, size, &used, &scene, NULL), TIA_OK);
    memset(again, 0xff, size);
    CHECK_EQ(tia_bvh_build(&two, again, size, &used_again, &scene, NULL), TIA_OK);
    CHECK_EQ(tia_bvh_build(&two, again, size, NULL, &scene, NULL), TIA_OK);
    CHECK_EQ(used, used_again);
    /* memory beyond `used` is the caller's again */
    memset(room + used, 0, size - used);
    memset(again + used, 0xff, size - used);
    CHECK_EQ(one->objects.node_count, two->objects.node_count);
    CHECK(!memcmp(one->objects.nodes, two->objects.nodes, one->objects.node_count * sizeof(struct tia_bvh_node)));
    CHECK(!memcmp(one->objects.items, two->objects.items, one->objects.item_count * sizeof(uint32_t)));
    for (int i = 0; i < 3; i++) {
        const struct tia_bvh_tree *a = &one->meshes[i], *b = &two->meshes[i];
        CHECK(a->node_count == b->node_count && a->item_count == b->item_count);
        CHECK(!memcmp(a->nodes, b->nodes, a->node_count * sizeof *a->nodes));
        CHECK(!memcmp(a->items, b->items, a->item_count * sizeof *a->items));
    }
    bvh = one;
    check_all();
    free(room);
    free(again);
}

/* Cancellation is prompt whenever `stop` returns true: `stop` is not called again. */
TEST(asked_to_stop)
{
    const struct tia_bvh *none = NULL;
    unsigned questions = 100000, all;

    set_everything();
    set_spheres(MOST);
    size_t size = tia_bvh_size(&scene);
    unsigned char *room = malloc(size);
    CHECK_EQ(tia_bvh_build(&bvh, room, size, &used, &scene, &(struct tia_job){.stop = count_down, .ctx = &questions}),
             TIA_OK);
    check_all();
    all = 100000 - questions;
    CHECK(all > MOST / 4096);
    for (unsigned i = 1; i <= all; i += 1 + i / 10) {
        questions = i;
        CHECK_EQ(
            tia_bvh_build(&none, room, size, NULL, &scene, &(struct tia_job){.stop = count_down, .ctx = &questions}),
            TIA_STOPPED);
        CHECK(!none && !questions);
    }
    free(room);
}

TEST(one_place)
{
    set_spheres(MOST);
    for (uint32_t i = 0; i < MOST; i++)
        spheres[i] = (struct tia_sphere){{7, 8, 9}, 100 + (tia_q16)(i % 3), 0};
    build();
    check_all();
    CHECK(deepest <= 13); /* halves: 20000 / 2^12 are 5 */
    for (uint32_t i = 0; i < bvh->objects.node_count; i++)
        CHECK(bvh->objects.nodes[i].count <= 8);
}

TEST(exponential_spacing)
{
    set_exponential_spheres();
    build();
    check_all();
    CHECK(deepest <= TIA_BVH_DEPTH_MAX);
}

/* With 90 of 100 items close together and the others far away, the best division makes the tree too deep. It is used
 * only if a child may have 90 items; otherwise the items are halved. */
TEST(a_depth_that_would_not_do)
{
    struct tia_bounds boxes[100], bounds;
    uint32_t numbers[100];
    struct cancel never = {0};
    const struct tia_bvh_split_items items = {boxes, numbers, 100, 1, 1, &never};

    for (uint32_t i = 0; i < 100; i++) {
        struct tia_vec3 p = {i < 90 ? (tia_q16)i : (tia_q16)i * ONE, 0, 0};
        boxes[i] = (struct tia_bounds){{p.x, 0, 0}, {p.x + 2, 2, 2}};
        numbers[i] = i;
    }
    CHECK_EQ(tia_bvh_split_items(&items, &bounds, 100), 90);
    CHECK(bounds.min.x == 0 && bounds.max.x == 99 * ONE + 2);
    CHECK_EQ(tia_bvh_split_items(&items, &bounds, 90), 90);
    CHECK_EQ(tia_bvh_split_items(&items, &bounds, 89), 50);
    CHECK_EQ(tia_bvh_split_items(&items, &bounds, 50), 50);
}

/* Two cubes share half of their space: 12/16 + 12/16 + 1/c < 2 for a cost c above 2. */
TEST(items_that_cost_more_are_split_sooner)
{
    struct tia_bounds boxes[2] = {{{0, 0, 0}, {2, 2, 2}}, {{0, 0, 1}, {2, 2, 3}}};
    uint32_t numbers[2] = {0, 1};
    struct cancel never = {0};

    for (uint32_t cost = 1; cost < 5; cost++) {
        const struct tia_bvh_split_items items = {boxes, numbers, 2, cost, 1, &never};
        struct tia_bounds bounds;
        CHECK_EQ(tia_bvh_split_items(&items, &bounds, 2), cost > 2);
    }
}

/* Four boxes far apart are divided, unless so many items are to stay together. */
TEST(few_items_that_are_not_divided)
{
    struct cancel never = {0};

    for (uint32_t undivided = 1; undivided < 6; undivided++)
        for (uint32_t count = 2; count < 5; count++) {
            struct tia_bounds boxes[4], bounds;
            uint32_t numbers[4] = {0, 1, 2, 3};
            for (int32_t i = 0; i < 4; i++)
                boxes[i] = (struct tia_bounds){{99 * i, 0, 0}, {99 * i + 2, 2, 2}};
            const struct tia_bvh_split_items items = {boxes, numbers, count, 3, undivided, &never};
            CHECK_EQ(tia_bvh_split_items(&items, &bounds, 4) == 0, count <= undivided);
            CHECK(bounds.min.x == 0 && bounds.max.x == 99 * (int32_t)count - 97 && bounds.max.z == 2);
        }
}

/* The first axis on which the centres differ orders two items: the lower centre comes first. */
TEST(order_of_two)
{
    static const struct {
        struct tia_bounds second; /* the first item is a cube at 4, 4, 4 */
        uint32_t left, first;
    } cases[] = {
        {{{4, 4, 4}, {5, 5, 5}}, 0, 0},  {{{4, 4, 0}, {5, 5, 1}}, 1, 1},  {{{4, 0, 9}, {5, 1, 10}}, 1, 1},
        {{{4, 9, 0}, {5, 10, 1}}, 1, 0}, {{{9, 0, 0}, {10, 1, 1}}, 1, 0}, {{{0, 9, 9}, {1, 10, 10}}, 1, 1},
    };
    struct cancel never = {0};

    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct tia_bounds boxes[2] = {{{4, 4, 4}, {5, 5, 5}}, cases[i].second}, bounds;
        uint32_t numbers[2] = {0, 1};
        const struct tia_bvh_split_items items = {boxes, numbers, 2, 3, 1, &never};
        CHECK_EQ(tia_bvh_split_items(&items, &bounds, 2), cases[i].left);
        CHECK_EQ(numbers[0], cases[i].first);
        CHECK(!memcmp(&boxes[1 - cases[i].first], &cases[i].second, sizeof boxes[0]));
    }
}

TEST(ends_of_the_numbers)
{
    set_spheres(1000);
    for (uint32_t i = 0; i < 1000; i++) {
        spheres[i].centre = (struct tia_vec3){i & 1 ? INT32_MAX - 5000 : INT32_MIN + 5000,
                                              i & 2 ? INT32_MAX - 5000 : INT32_MIN + 5000, number(INT32_MAX - 70000)};
        spheres[i].radius = 64 + (tia_q16)(random_u32() % 4900);
    }
    spheres[30].radius = 5000; /* Q16.16 has no room for the margin */
    spheres[40].radius = 4998;
    build();
    check_all();
    CHECK(bvh->unbounded_count == 1 && bvh->unbounded[0] == 30);
}

TEST(too_large_for_the_machine)
{
    scene = (struct tia_scene){.meshes = meshes, .mesh_count = 1};
    meshes[0] = (struct tia_mesh){.face_count = TIA_OBJECTS_MAX};
    /* 4 bytes an item, two nodes of 32, a box of 24 */
    CHECK(tia_bvh_size(&scene) >= (size_t)92 * TIA_OBJECTS_MAX - 32 &&
          tia_bvh_size(&scene) < (size_t)93 * TIA_OBJECTS_MAX);
}

int main(void)
{
    RUN(spheres_of_all_counts);
    RUN(everything);
    RUN(memory_as_promised);
    RUN(asked_to_stop);
    RUN(one_place);
    RUN(exponential_spacing);
    RUN(a_depth_that_would_not_do);
    RUN(items_that_cost_more_are_split_sooner);
    RUN(few_items_that_are_not_divided);
    RUN(order_of_two);
    RUN(ends_of_the_numbers);
    RUN(too_large_for_the_machine);
    free(memory);
    return check_status();
}
