/* bvh.h - a bounding volume hierarchy: boxes within boxes, so that a ray tests few objects.
 *
 * The builder uses the binned surface area heuristic, in integers: the tree is the same on every machine and serves
 * every arithmetic. The tree is in the caller's memory and is read-only once built.
 */
#ifndef TIA_BVH_H
#define TIA_BVH_H

#include <tia/job.h>
#include <tia/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_BVH_DEPTH_MAX 48 /* largest number of levels below the root */

struct tia_bounds {
    struct tia_vec3 min, max; /* min <= max; empty bounds have max < min in all three coordinates */
};

/* Node 0 is the root. An inner node has count 0; its children are the next node and node `index`.
 * A leaf's objects are items[index] .. items[index + count - 1]. */
struct tia_bvh_node {
    struct tia_bounds bounds;
    uint32_t index, count;
};

/* One hierarchy, of a scene's objects or of a mesh's faces; its items are the indices of these. */
struct tia_bvh_tree {
    const struct tia_bvh_node *nodes;
    const uint32_t *items;
    uint32_t node_count, item_count; /* both 0 for an empty tree */
};

/* The hierarchies of a scene, to which scene.bvh points. Objects without a finite box, that is, planes and objects that
 * extend beyond Q16.16, are outside the tree: every ray is tested against them. */
struct tia_bvh {
    struct tia_bvh_tree objects;
    const struct tia_bvh_tree *meshes; /* one for each of the scene's meshes */
    const uint32_t *unbounded;         /* indices of the objects outside the tree */
    uint32_t unbounded_count;
};

/* Returns the number of bytes of memory that tia_bvh_build needs for a scene that tia_scene_check accepts; SIZE_MAX
 * when that number does not fit. The memory must be aligned for uint64_t. */
size_t tia_bvh_size(const struct tia_scene *scene);

/* Builds the hierarchies of a scene that tia_scene_check accepts; set scene->bvh = *bvh to use them. TIA_ERR_MEMORY
 * when `size` is too small. Building needs more memory than the result: only the first *used bytes stay in use; the
 * rest is free again. `used` may be NULL. TIA_STOPPED leaves *bvh as it is.
 *
 * The job's workers build trees of 16384 items and more, which take one thread over 5 ms. The hierarchy has the same
 * bits for any number of threads. */
int tia_bvh_build(const struct tia_bvh **bvh, void *memory, size_t size, size_t *used, const struct tia_scene *scene,
                  const struct tia_job *job);

/* Returns the number of bytes of memory that tia_bvh_move needs for a scene that tia_scene_check accepts; SIZE_MAX when
 * that number does not fit. The memory must be aligned for uint64_t. */
size_t tia_bvh_move_size(const struct tia_scene *scene);

/* Sets *bvh to the hierarchy of `scene`, which tia_scene_at made from `standing`: only objects that moved get new
 * boxes. All else is shared with standing->bvh, whose memory must stay valid. Rays hit the same objects as with a newly
 * built hierarchy. Runs on one thread. Returns TIA_ERR_ARGUMENT also when `standing` has no hierarchy of its own or
 * another number of objects; TIA_ERR_MEMORY when `size` is too small. */
int tia_bvh_move(const struct tia_bvh **bvh, void *memory, size_t size, const struct tia_scene *scene,
                 const struct tia_scene *standing, const struct tia_job *job);

/* Returns the world bounds of object `index`, rounded outwards, then enlarged by 2^-16 on every side, and clamped to
 * the range of Q16.16. The bounds are empty for a plane, for a mesh without faces and for an index without an object.
 * The scene is one that tia_scene_check accepts. Takes time proportional to a mesh's faces. */
struct tia_bounds tia_object_bounds(const struct tia_scene *scene, uint32_t index);

#ifdef __cplusplus
}
#endif

#endif
