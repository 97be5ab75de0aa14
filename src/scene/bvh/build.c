/* build.c - builds all hierarchies of a scene in one block of memory:
 *
 *     struct tia_bvh
 *     struct tia_bvh_tree of each mesh
 *     for each mesh: items, nodes
 *     for the objects: items, unbounded objects, nodes
 *     at the end of the block, only while building: the boxes of one tree's items
 */
#include "objects.h"

#include "math/align.h"
#include "scene/object_bounds.h"

/* Costs of testing an object; visiting two boxes costs 1. On average over all tests, most of which miss early, a sphere
 * takes about twice as many instructions as a visit, a triangle three times, a cylinder or cone five times. */
enum { SPHERE_COST = 2, FACE_COST = 3, ROUND_COST = 5 };

/* In large meshes a node of up to four faces is a leaf, which halves the memory of their trees. As these fit in no
 * cache either way, rays do not take longer. */
#define LARGE_LEAF 4u

/* Returns the largest number of boxes needed at the same time. */
static uint64_t box_count(const struct tia_scene *scene)
{
    uint64_t most = bvh_object_count(scene);

    for (uint32_t i = 0; i < scene->mesh_count; i++)
        most = scene->meshes[i].face_count > most ? scene->meshes[i].face_count : most;
    return most;
}

static uint64_t whole_size(const struct tia_scene *scene)
{
    uint64_t size = ALIGN(sizeof(struct tia_bvh)) + ALIGN(scene->mesh_count * (uint64_t)sizeof(struct tia_bvh_tree));

    for (uint32_t i = 0; i < scene->mesh_count; i++)
        size += bvh_tree_size(scene->meshes[i].face_count);
    return size + bvh_tree_size(bvh_object_count(scene)) + ALIGN(box_count(scene) * sizeof(struct tia_bounds));
}

size_t tia_bvh_size(const struct tia_scene *scene)
{
    uint64_t size = scene ? whole_size(scene) : SIZE_MAX;
    return size > SIZE_MAX / 2 ? SIZE_MAX : (size_t)size;
}

/* Builds the tree of `count` items. Allocates only the nodes used, at most TREE_NODES(count). */
static struct tia_bvh_tree build(struct bvh_space *space, const struct bvh_items *all, uint32_t count)
{
    struct tia_bvh_node *nodes = (struct tia_bvh_node *)(void *)space->front;
    uint32_t used = space->build ? space->build(space, nodes, all, count)
                                 : tia_bvh_build_range(nodes, all, (struct bvh_range){0, count, 0}, &space->cancel);

    bvh_allocate(space, used * sizeof *nodes);
    return (struct tia_bvh_tree){nodes, all->items, used, count};
}

static struct tia_bvh_tree build_mesh(struct bvh_space *space, const struct tia_mesh *mesh)
{
    uint32_t *items = bvh_allocate(space, mesh->face_count * (uint64_t)sizeof *items);

    for (uint32_t i = 0; i < mesh->face_count && !cancelled(&space->cancel, 1); i++) {
        struct tia_bounds box = tia_bounds_of_face(mesh, i);
        struct bounds_wide wide = {{box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}};
        (void)tia_bounds_with_margin(&wide, &space->boxes[i]);
        items[i] = i;
    }
    const struct bvh_items all = {items, space->boxes, FACE_COST, mesh->face_count > BVH_LARGE_MESH ? LARGE_LEAF : 1u};
    return build(space, &all, mesh->face_count);
}

/* Returns a mesh's own box: the root's box without the margin that tia_bounds_with_margin added. */
static struct tia_bounds without_margin(const struct tia_bounds *b)
{
#define LESS(x) ((x) > INT32_MIN ? (x) + 1 : (x))
#define MORE(x) ((x) < INT32_MAX ? (x)-1 : (x))
    return (struct tia_bounds){{LESS(b->min.x), LESS(b->min.y), LESS(b->min.z)},
                               {MORE(b->max.x), MORE(b->max.y), MORE(b->max.z)}};
#undef LESS
#undef MORE
}

bool tia_bvh_object_box(struct tia_bounds *box, const struct tia_scene *scene, uint32_t object,
                        const struct tia_bvh_tree *meshes)
{
    const struct tia_shape *shape = object < scene->sphere_count ? NULL : &scene->shapes[object - scene->sphere_count];
    struct bounds_wide wide;
    struct tia_bounds own = BOUNDS_NOTHING;

    if (shape && shape->kind == TIA_MESH) {
        if (!meshes[shape->mesh].node_count) {
            *box = own;
            return true;
        }
        own = without_margin(&meshes[shape->mesh].nodes[0].bounds);
    }
    return tia_bounds_in_world(scene, object, &own, &wide) && tia_bounds_with_margin(&wide, box);
}

static bool is_costly(enum tia_shape_kind kind)
{
    return kind == TIA_CYLINDER || kind == TIA_CONE || kind == TIA_TORUS || kind == TIA_ROUNDED;
}

/* Returns the mean cost of testing an item, at least 1. */
static uint32_t object_cost(const struct tia_scene *scene, const uint32_t *items, uint32_t count, struct cancel *cancel)
{
    uint64_t sum = 0;

    for (uint32_t i = 0; i < count && !cancelled(cancel, 1); i++) {
        uint32_t spheres = scene->sphere_count;
        bool sphere = items[i] < spheres;
        enum tia_shape_kind kind = sphere ? TIA_SPHERE : scene->shapes[items[i] - spheres].kind;
        sum += sphere ? SPHERE_COST : is_costly(kind) ? ROUND_COST : FACE_COST;
    }
    return sum > count ? (uint32_t)(sum / count) : 1;
}

/* Builds the tree of the objects. Objects with a box fill `items` from the front, the others from the back. */
void tia_bvh_build_objects(struct bvh_space *space, struct tia_bvh *bvh, const struct tia_scene *scene)
{
    uint32_t count = (uint32_t)bvh_object_count(scene), last = count, first = 0;
    uint32_t *items = bvh_allocate(space, count * (uint64_t)sizeof *items);

    for (uint32_t i = count; !cancelled(&space->cancel, 1) && i-- > 0;)
        if (tia_bvh_object_box(&space->boxes[first], scene, i, bvh->meshes))
            items[first++] = i;
        else
            items[--last] = i;
    const struct bvh_items all = {items, space->boxes, object_cost(scene, items, first, &space->cancel), 1};
    bvh->objects = build(space, &all, first);
    bvh->unbounded = items + last;
    bvh->unbounded_count = count - last;
}

int tia_bvh_build(const struct tia_bvh **bvh, void *memory, size_t size, size_t *used, const struct tia_scene *scene,
                  const struct tia_job *job)
{
    const struct tia_workers *workers = job ? job->workers : NULL;

    if (!bvh || !scene || !memory_is_usable(memory) || !workers_are_usable(workers))
        return TIA_ERR_ARGUMENT;
    struct bvh_space space = {.front = memory, .cancel = cancel_for(job), .workers = workers};

    space.build = workers ? tia_bvh_build_together : NULL;
    size_t needed = tia_bvh_size(scene);

    if (needed == SIZE_MAX || size < needed)
        return TIA_ERR_MEMORY;
    space.boxes = (void *)(space.front + needed - ALIGN(box_count(scene) * sizeof(struct tia_bounds)));
    struct tia_bvh *whole = bvh_allocate(&space, sizeof *whole);
    struct tia_bvh_tree *meshes = bvh_allocate(&space, scene->mesh_count * (uint64_t)sizeof *meshes);
    whole->meshes = meshes;
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        meshes[i] = build_mesh(&space, &scene->meshes[i]);
    tia_bvh_build_objects(&space, whole, scene);
    if (space.cancel.stopped)
        return TIA_STOPPED;
    *bvh = whole;
    if (used)
        *used = (size_t)(space.front - (unsigned char *)memory);
    return TIA_OK;
}
