/* refit.c - the hierarchy of a scene whose objects have moved.
 *
 * The tree of the scene at rest is kept; only the boxes of objects that moved, and the boxes around them, change. The
 * tree's quality may decline over time: if boxes of the same depth overlap, rays visit more of them. The number of
 * nodes that a ray visits is proportional to the boxes' areas (split.c). So when the sum of the areas has grown by
 * half, the tree of the objects is rebuilt. The trees of the meshes never change.
 */
#include "objects.h"

#include "math/integer.h"
#include "scene/object_bounds.h"

size_t tia_bvh_move_size(const struct tia_scene *scene)
{
    if (!scene)
        return SIZE_MAX;
    uint64_t count = bvh_object_count(scene);
    uint64_t size =
        ALIGN(sizeof(struct tia_bvh)) + bvh_tree_size(count) + ALIGN(count * (uint64_t)sizeof(struct tia_bounds));

    return size > SIZE_MAX / 2 ? SIZE_MAX : (size_t)size;
}

/* True if two elements are equal, byte by byte. An object that differs only in padding counts as moved. */
static bool same(const void *a, const void *b, size_t size)
{
    const unsigned char *one = a, *other = b;
    size_t i = 0;

    while (a != b && i < size && one[i] == other[i])
        i++;
    return a == b || i == size;
}

/* The state of a refit. */
struct following {
    const struct tia_scene *scene, *standing;
    struct tia_bvh_node *nodes;
    bool fits; /* all moved objects still have a box */
};

/* True if transform `number`, from 1, is as it was; also if it is 0. */
static bool is_still(const struct following *f, uint32_t number)
{
    return !number ||
           same(&f->scene->transforms[number - 1], &f->standing->transforms[number - 1], sizeof(struct tia_transform));
}

/* True if the object has moved; spheres without a transform never do. */
static bool has_moved(const struct following *f, uint32_t object)
{
    if (object < f->scene->sphere_count)
        return false;
    uint32_t i = object - f->scene->sphere_count;
    const struct tia_shape *shape = &f->scene->shapes[i];
    const struct tia_solid *solid = shape->kind == TIA_SOLID ? &f->scene->solids[shape->solid] : NULL;
    bool same_place = is_still(f, shape->transform);

    for (uint32_t k = 0; solid && k < solid->member_count; k++)
        same_place = same_place && is_still(f, solid->members[k].transform);
    return !same_place || !same(&f->scene->shapes[i], &f->standing->shapes[i], sizeof(struct tia_shape));
}

/* Refits the box of a leaf; the box stays if none of the leaf's items moved. */
static void follow_leaf(struct following *f, struct tia_bvh_node *leaf)
{
    const struct tia_bvh *bvh = f->standing->bvh;
    const uint32_t *items = bvh->objects.items + leaf->index;
    struct tia_bounds bounds = BOUNDS_NOTHING, box;
    bool moved = false;

    for (uint32_t i = 0; i < leaf->count; i++)
        moved = moved || has_moved(f, items[i]);
    for (uint32_t i = 0; i < leaf->count && moved; i++) {
        f->fits = f->fits && tia_bvh_object_box(&box, f->scene, items[i], bvh->meshes);
        if (f->fits)
            tia_bounds_add(&bounds, &box);
    }
    if (moved)
        leaf->bounds = bounds;
}

/* Refits all nodes from the last one to the first: children come after their parents, so both children of a node are
 * refitted before the node.
 */
static void follow(struct following *f, struct cancel *cancel)
{
    const struct tia_bvh_tree *tree = &f->standing->bvh->objects;

    for (uint32_t i = tree->node_count; i-- > 0 && f->fits && !cancelled(cancel, 1);) {
        struct tia_bvh_node *node = &f->nodes[i];
        *node = tree->nodes[i];
        if (node->count) {
            follow_leaf(f, node);
        } else {
            node->bounds = f->nodes[i + 1].bounds;
            tia_bounds_add(&node->bounds, &f->nodes[node->index].bounds);
        }
    }
}

static uint64_t extent(tia_q16 min, tia_q16 max)
{
    return max < min ? 0 : (uint64_t)((int64_t)max - min);
}

static uint64_t largest(const struct tia_bounds *b)
{
    return extent(b->min.x, b->max.x) | extent(b->min.y, b->max.y) | extent(b->min.z, b->max.z);
}

/* Returns half the sum of the nodes' surface areas. Extents of 18 bits keep each node's half area below 3 * 2^36. */
static uint64_t areas(const struct tia_bvh_node *nodes, uint32_t count, unsigned shift)
{
    uint64_t sum = 0;

    for (uint32_t i = 0; i < count; i++) {
        const struct tia_bounds *b = &nodes[i].bounds;
        uint64_t x = extent(b->min.x, b->max.x) >> shift, y = extent(b->min.y, b->max.y) >> shift,
                 z = extent(b->min.z, b->max.z) >> shift, area = x * y + y * z + z * x;
        sum = sum < UINT64_MAX - area ? sum + area : UINT64_MAX;
    }
    return sum;
}

static bool is_good(const struct following *f)
{
    const struct tia_bvh_tree *tree = &f->standing->bvh->objects;
    uint32_t count = tree->node_count;

    if (!f->fits || !count)
        return f->fits;
    uint64_t all = largest(&f->nodes[0].bounds) | largest(&tree->nodes[0].bounds);
    unsigned bits = all ? 64 - tia_clz64(all) : 0, shift = bits > 18 ? bits - 18 : 0;
    uint64_t before = areas(tree->nodes, count, shift);
    return areas(f->nodes, count, shift) <= before + before / 2;
}

/* True if `scene` can be a later state of `standing`, and `standing` has a hierarchy of its objects. */
static bool can_follow(const struct tia_scene *scene, const struct tia_scene *standing)
{
    const struct tia_bvh *bvh = standing->bvh;

    return bvh && scene->sphere_count == standing->sphere_count && scene->shape_count == standing->shape_count &&
           scene->transform_count == standing->transform_count && scene->mesh_count == standing->mesh_count &&
           (uint64_t)bvh->objects.item_count + bvh->unbounded_count == bvh_object_count(standing);
}

int tia_bvh_move(const struct tia_bvh **bvh, void *memory, size_t size, const struct tia_scene *scene,
                 const struct tia_scene *standing, const struct tia_job *job)
{
    if (!bvh || !scene || !standing || !memory_is_usable(memory) || !can_follow(scene, standing))
        return TIA_ERR_ARGUMENT;
    uint64_t boxes = ALIGN(bvh_object_count(scene) * (uint64_t)sizeof(struct tia_bounds));
    struct bvh_space space = {.front = memory, .cancel = cancel_for(job)}, anew;
    size_t needed = tia_bvh_move_size(scene);

    if (needed == SIZE_MAX || size < needed)
        return TIA_ERR_MEMORY;
    space.boxes = (void *)(space.front + needed - boxes);
    struct tia_bvh *whole = bvh_allocate(&space, sizeof *whole);
    anew = space;
    struct following f = {scene, standing, (struct tia_bvh_node *)(void *)space.front, true};
    *whole = *standing->bvh;
    follow(&f, &space.cancel);
    whole->objects.nodes = f.nodes;
    if (!space.cancel.stopped && !is_good(&f)) {
        tia_bvh_build_objects(&anew, whole, scene);
        space.cancel = anew.cancel;
    }
    if (space.cancel.stopped)
        return TIA_STOPPED;
    *bvh = whole;
    return TIA_OK;
}
