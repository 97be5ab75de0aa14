/* nodes.c - conversion of a hierarchy to nodes that hold the boxes of their two children instead of their own. */
#include <tia/bvh.h>

#include "sure.h"

/* Returns x in units of 1 as a float, rounded up if `up` is set, else down. */
static float outward(tia_q16 x, bool up)
{
    float f = (float)x;
    double exact = x;
    int32_t bits;

    if (up ? (double)f < exact : (double)f > exact) {
        __builtin_memcpy(&bits, &f, sizeof bits);
        bits += (f > 0) == up ? 1 : -1; /* the next float, away from 0 or towards 0; subnormal numbers do not occur */
        __builtin_memcpy(&f, &bits, sizeof f);
    }
    return f * (float)SURE_Q16;
}

/* Returns the number of items below a node, or 0 if there are more than `most`. These items are consecutive; *first
 * receives the index of the first one. */
static uint32_t items_below(const struct tia_bvh_node *n, uint32_t most, uint32_t *first)
{
    uint32_t count = 0;

    for (uint32_t ends = most > 0; ends && count <= most; n++) {
        *first = n->count && !count ? n->index : *first;
        count += n->count;
        ends = n->count ? ends - 1 : ends + 1;
    }
    return count <= most ? count : 0;
}

static void set_child(struct sure_node *to, int i, const struct tia_bvh_node *from, uint32_t number, uint32_t few)
{
    uint32_t first = from->index, count = from->count ? from->count : items_below(from, few, &first);
    const tia_q16 least[3] = {from->bounds.min.x, from->bounds.min.y, from->bounds.min.z};
    const tia_q16 most[3] = {from->bounds.max.x, from->bounds.max.y, from->bounds.max.z};

    for (int k = 0; k < 3; k++) {
        to->box[k][i] = outward(least[k], false);
        to->box[k + 3][i] = outward(most[k], true);
    }
    to->index[i] = count ? first : number;
    to->count[i] = count ? count : SURE_INNER;
}

/* Sets the only node of a hierarchy whose root is a leaf. Returns 1, the number of nodes. */
static uint32_t set_single(struct sure_node *to, const struct tia_bvh_node *from)
{
    set_child(to, 0, from, 0, 0);
    for (int k = 0; k < 6; k++)
        to->box[k][1] = SURE_NOWHERE;
    to->index[1] = to->count[1] = 0;
    return 1;
}

/* A node whose index[1] is still to be set. `second` is the index of its second child in the given hierarchy. */
struct pending {
    uint32_t node, second;
};

/* Returns the index of the next given node to convert, at or after i; `end` if there is none. Nodes below children that
 * became leaves are skipped. If the node is a second child, index[1] of its parent is set. */
static uint32_t next_node(uint32_t i, struct sure_node *to, uint32_t made, const struct pending *stack, int *depth,
                          uint32_t end)
{
    while (*depth && stack[*depth - 1].second == i) {
        struct sure_node *parent = &to[stack[--*depth].node];
        if (parent->count[1] == SURE_INNER) {
            parent->index[1] = made;
            return i;
        }
        i = *depth ? stack[*depth - 1].second : end;
    }
    return i;
}

/* Makes the nodes; returns their number. Inner nodes keep their order: a node comes first, then those below its first
 * child, then those below its second. */
uint32_t tia_sure_set_nodes(struct sure_node *to, const struct tia_bvh_tree *from, uint32_t few)
{
    struct pending stack[TIA_BVH_DEPTH_MAX + 1];
    uint32_t made = 0, i = 0;
    int depth = 0;

    if (from->node_count && from->nodes[0].count)
        return set_single(to, from->nodes);
    while (i < from->node_count) {
        const struct tia_bvh_node *n = &from->nodes[i];
        set_child(&to[made], 0, n + 1, made + 1, few);
        set_child(&to[made], 1, &from->nodes[n->index], 0, few);
        stack[depth++] = (struct pending){made, n->index};
        i = to[made++].count[0] == SURE_INNER ? i + 1 : n->index;
        i = next_node(i, to, made, stack, &depth, from->node_count);
    }
    return made;
}
