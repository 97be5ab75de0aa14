/* objects.h - the hierarchy of a scene's objects, its construction and its refitting. */
#ifndef TIA_SCENE_BVH_OBJECTS_H
#define TIA_SCENE_BVH_OBJECTS_H

#include "math/align.h"
#include "tree.h"

/* A block of memory that is filled from the front, and the builder of large trees. */
struct bvh_space {
    unsigned char *front;
    struct tia_bounds *boxes; /* boxes of the items of one tree, while it is built */
    struct cancel cancel;
    /* builds the same tree of `count` items as tia_bvh_build_range; NULL: tia_bvh_build_range builds it */
    uint32_t (*build)(struct bvh_space *space, struct tia_bvh_node *nodes, const struct bvh_items *all, uint32_t count);
    const struct tia_workers *workers; /* workers for `build` */
};

static inline uint64_t bvh_object_count(const struct tia_scene *scene)
{
    return (uint64_t)scene->sphere_count + scene->shape_count;
}

static inline uint64_t bvh_tree_size(uint64_t count)
{
    return ALIGN(count * sizeof(uint32_t)) + TREE_NODES(count) * sizeof(struct tia_bvh_node);
}

static inline void *bvh_allocate(struct bvh_space *space, uint64_t size)
{
    void *place = space->front;
    space->front += ALIGN(size);
    return place;
}

/* Writes the box of an object. Returns false if the object has none, or the box does not fit in Q16.16. */
bool tia_bvh_object_box(struct tia_bounds *box, const struct tia_scene *scene, uint32_t object,
                        const struct tia_bvh_tree *meshes);

/* Builds bvh->objects; the meshes' trees must be built already. */
void tia_bvh_build_objects(struct bvh_space *space, struct tia_bvh *bvh, const struct tia_scene *scene);

/* Builds a tree with space->workers if it is large. A value for space->build. */
uint32_t tia_bvh_build_together(struct bvh_space *space, struct tia_bvh_node *nodes, const struct bvh_items *all,
                                uint32_t count);

#endif
