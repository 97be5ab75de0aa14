/* bvh.h - a bounding volume hierarchy: boxes within boxes, so that a ray tests few objects.
 *
 * Built by the binned surface-area heuristic, with integers, the same everywhere, in the caller's
 * memory; const tables afterwards, whatever the arithmetic that walks them.
 */
#ifndef TIA_BVH_H
#define TIA_BVH_H

#include <tia/scene.h>

#define TIA_BVH_DEPTH_MAX 48 /* levels below the root */

struct tia_bounds {
    struct tia_vec3 min, max; /* min <= max, or nothing: then max < min in all three */
};

/* Node 0 is the root. A node with count 0 has two children, the next node and node `index`; else its
 * objects are items[index] .. items[index + count - 1]. */
struct tia_bvh_node {
    struct tia_bounds bounds;
    uint32_t index, count;
};

/* One hierarchy: of a scene's objects (an item is an object's index), or of a mesh's faces. */
struct tia_bvh_tree {
    const struct tia_bvh_node *nodes;
    const uint32_t *items;
    uint32_t node_count, item_count; /* no nodes: no items */
};

/* What scene.bvh points to. Beside the tree are the planes, which have no bounds, and what reaches beyond
 * Q16.16, where an eye near the end of those numbers still sees it. */
struct tia_bvh {
    struct tia_bvh_tree objects;
    const struct tia_bvh_tree *meshes; /* one for each of the scene's meshes */
    const uint32_t *planes;            /* objects */
    uint32_t plane_count;
};

/* Bytes of memory, aligned for uint64_t, that tia_bvh_build takes for the scene. */
size_t tia_bvh_size(const struct tia_scene *scene);

/* Builds the hierarchies of a scene that tia_scene_check accepts; scene->bvh = *bvh uses them.
 * TIA_ERR_MEMORY when `size` is too small. The memory beyond what *bvh needs is free again:
 * *used bytes are in use (used may be NULL). */
int tia_bvh_build(const struct tia_bvh **bvh, void *memory, size_t size, size_t *used, const struct tia_scene *scene);

/* Bounds in the world of object `index`: rounded outwards and a unit of 2^-16 larger on every side; cut off
 * where Q16.16 ends. A plane has none, nor has a mesh without faces. A mesh's faces are all looked at. */
struct tia_bounds tia_object_bounds(const struct tia_scene *scene, uint32_t index);

#endif
