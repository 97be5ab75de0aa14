/* pairs.c - the faces of a mesh in floats, two by two, in the order of its hierarchy's leaves. */
#include "sure.h"

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* See pairs.h. */
static double size_of(const struct sure_edges *e, double extent)
{
    double size = 0;

    for (int i = 0; i < 3; i++) {
        const double *cross = e->edge[i][0];
        for (int k = 0; k < 3; k++)
            size = larger(size, __builtin_fabs(e->edge[i][1][k]));
        double square = cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2];
        size = larger(size, __builtin_sqrt(square) / extent);
    }
    return size;
}

static void set_one(struct sure_pair *to, int place, const struct sure_tree *tree, uint32_t face)
{
    const struct sure_face *f = &tree->faces[face];
    struct sure_edges e = sure_edges_of(f, tree->centre);

    for (int i = 0; i < 3; i++)
        for (int part = 0; part < 2; part++)
            for (int k = 0; k < 3; k++)
                to->edge[i][part][k][place] = (float)e.edge[i][part][k];
    to->face[place] = face;
    to->size[place] = f->any ? (float)size_of(&e, tree->extent) : SURE_NONE;
}

static uint32_t set_leaf(struct sure_pair *to, const struct sure_tree *tree, const uint32_t *items, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        set_one(&to[i / 2], i % 2, tree, items[i]);
    if (count % 2) {
        set_one(&to[count / 2], 1, tree, items[count - 1]);
        to[count / 2].size[1] = SURE_NONE;
    }
    return (count + 1) / 2;
}

uint32_t tia_sure_set_pairs(struct sure_pair *to, struct sure_node *nodes, const struct sure_tree *tree)
{
    uint32_t made = 0;

    for (uint32_t i = 0; i < tree->node_count; i++)
        for (int k = 0; k < 2; k++)
            if (nodes[i].count[k] != SURE_INNER) {
                uint32_t count = set_leaf(&to[made], tree, &tree->items[nodes[i].index[k]], nodes[i].count[k]);
                nodes[i].index[k] = made;
                nodes[i].count[k] = count;
                made += count;
            }
    return made;
}
