#include "tree.h"

/* A node still to be built; a stack of these replaces recursion. */
struct task {
    struct bvh_range range;
    uint32_t parent; /* node whose second child this is; otherwise this node's own index */
};

/* Sorts at most SPLIT_ITEMS_MOST items by insertion. */
static void sort(uint32_t *items, uint32_t count)
{
    for (uint32_t i = 1; i < count; i++) {
        uint32_t item = items[i], k = i;
        for (; k > 0 && items[k - 1] > item; k--)
            items[k] = items[k - 1];
        items[k] = item;
    }
}

uint32_t tia_bvh_build_range(struct tia_bvh_node *nodes, const struct bvh_items *all, struct bvh_range range,
                             struct cancel *cancel)
{
    struct task tasks[TIA_BVH_DEPTH_MAX + 1] = {{range, 0}};
    uint32_t node_count = 0, waiting = range.count ? 1 : 0;

    while (waiting && !cancelled(cancel, tasks[waiting - 1].range.count)) {
        struct task task = tasks[--waiting];
        struct bvh_range r = task.range;
        const struct tia_bvh_split_items part = bvh_items_of(all, r, cancel);
        uint32_t here = node_count++;
        struct tia_bvh_node *node = &nodes[here];

        if (task.parent != here)
            nodes[task.parent].index = here;
        uint32_t left = tia_bvh_split_items(&part, &node->bounds, bvh_most_items(r.depth + 1));
        if (cancel->stopped)
            break;
        node->index = r.first;
        node->count = left ? 0 : r.count;
        if (!left) {
            sort(part.items, r.count);
            continue;
        }
        tasks[waiting++] = (struct task){{r.first + left, r.count - left, r.depth + 1}, here};
        tasks[waiting++] = (struct task){{r.first, left, r.depth + 1}, here + 1};
    }
    return node_count;
}
