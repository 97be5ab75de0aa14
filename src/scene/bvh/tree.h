/* tree.h - builds one hierarchy, top down. */
#ifndef TIA_SCENE_BVH_TREE_H
#define TIA_SCENE_BVH_TREE_H

#include <tia/bvh.h>

/* Upper bound of the nodes for n items: each leaf has at least one. */
#define TREE_NODES(n) ((n) ? 2 * (uint64_t)(n)-1 : 0)

/* Who is asked whether to go on. */
struct tia_bvh_asker {
    bool (*stop)(void *ctx); /* NULL: nobody */
    void *ctx;
    uint32_t work; /* items since the last question */
    bool stopped;
};

#define TREE_PATIENCE 4096 /* items */

/* Adds some items of work. True: stop. */
static inline bool tia_bvh_stops(struct tia_bvh_asker *asker, uint32_t work)
{
    asker->work = asker->work < TREE_PATIENCE ? asker->work + work : asker->work;
    if (asker->stop && !asker->stopped && asker->work >= TREE_PATIENCE) {
        asker->work = 0;
        asker->stopped = asker->stop(asker->ctx);
    }
    return asker->stopped;
}

/* Fills `nodes`, which has room for TREE_NODES(count), and reorders `items`, whose boxes are boxes[item]. In each leaf
 * the items are in rising order. When it is stopped, the tree is not complete. */
struct tia_bvh_tree tia_bvh_build_tree(struct tia_bvh_node *nodes, uint32_t *items, uint32_t count,
                                       const struct tia_bounds *boxes, struct tia_bvh_asker *asker);

#endif
