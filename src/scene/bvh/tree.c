#include "tree.h"

#include "split.h"

/* A node still to be built; a stack of these replaces recursion. */
struct task {
    uint32_t first, count; /* items */
    uint32_t parent;       /* the node whose second child it is; its own index when it is none */
    uint32_t depth;
};

/* Insertion sort, for at most SPLIT_ITEMS_MOST items. */
static void sort(uint32_t *items, uint32_t count)
{
    for (uint32_t i = 1; i < count; i++) {
        uint32_t item = items[i], k = i;
        for (; k > 0 && items[k - 1] > item; k--)
            items[k] = items[k - 1];
        items[k] = item;
    }
}

/* The most items that a node may have at `depth`: with no more, halving reaches single items by TIA_BVH_DEPTH_MAX. */
static uint32_t most_items(uint32_t depth)
{
    uint32_t left = TIA_BVH_DEPTH_MAX - depth;
    return UINT32_C(1) << (left < 31 ? left : 31);
}

struct tia_bvh_tree tia_bvh_build_tree(struct tia_bvh_node *nodes, uint32_t *items, uint32_t count, uint32_t cost,
                                       const struct tia_bounds *boxes, struct asker *asker)
{
    struct task tasks[TIA_BVH_DEPTH_MAX + 1] = {{0, count, 0, 0}};
    uint32_t node_count = 0, waiting = count ? 1 : 0;

    while (waiting && !asker_stops(asker, tasks[waiting - 1].count)) {
        struct task task = tasks[--waiting];
        const struct tia_bvh_split_items part = {boxes, items + task.first, task.count, cost, asker};
        uint32_t here = node_count++;
        struct tia_bvh_node *node = &nodes[here];

        if (task.parent != here)
            nodes[task.parent].index = here;
        *node = (struct tia_bvh_node){tia_bvh_split_bounds(&part), task.first, task.count};
        uint32_t left = tia_bvh_split_items(&part, &node->bounds, most_items(task.depth + 1));
        if (asker->stopped)
            break;
        if (!left) {
            sort(part.items, task.count);
            continue;
        }
        node->count = 0;
        tasks[waiting++] = (struct task){task.first + left, task.count - left, here, task.depth + 1};
        tasks[waiting++] = (struct task){task.first, left, here + 1, task.depth + 1};
    }
    return (struct tia_bvh_tree){nodes, items, node_count, count};
}
