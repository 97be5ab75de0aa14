/* pairs.c - the faces of a mesh in floats, two by two, in the order of its hierarchy's leaves: see pairs_tmpl.h. */
#include "sure_faces.h"

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static double length(const double p[3])
{
    return __builtin_sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
}

/* Returns c of pairs_tmpl.h: the largest of |N|/R, |P|/R and the components of E. As |P| <= R |E| and |N| <= 2 R |E|, P
 * and N enlarge c by factors of sqrt 3 and sqrt 12 at most. No test notices when they are left out, as the largest
 * error found in floats is 4 of the 25 units. */
static double size_of(const struct sure_edges *e, const double whole[3], double extent)
{
    double most = length(whole) / extent;

    for (int i = 0; i < 3; i++) {
        most = larger(most, length(e->edge[i][0]) / extent);
        for (int k = 0; k < 3; k++)
            most = larger(most, __builtin_fabs(e->edge[i][1][k]));
    }
    return most;
}

static void set_face(struct sure_pair *to, int place, const struct sure_tree *tree, uint32_t face)
{
    const struct sure_face f = sure_face_of(tree, face);
    struct sure_edges e = sure_edges_of(&f, tree->centre);
    double whole[3];

    for (int k = 0; k < 3; k++) {
        whole[k] = e.edge[0][0][k] + e.edge[1][0][k] + e.edge[2][0][k];
        to->whole[k][place] = (float)whole[k];
        for (int i = 0; i < 2; i++) {
            to->edge[i][0][k][place] = (float)e.edge[i][0][k];
            to->edge[i][1][k][place] = (float)e.edge[i][1][k];
        }
    }
    to->face[place] = face;
    to->size[place] = f.any ? (float)size_of(&e, whole, tree->extent) : SURE_NONE;
}

static uint32_t set_leaf(struct sure_pair *to, const struct sure_tree *tree, const uint32_t *items, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        set_face(&to[i / 2], i % 2, tree, items[i]);
    if (count % 2) {
        set_face(&to[count / 2], 1, tree, items[count - 1]);
        to[count / 2].size[1] = SURE_NONE;
    }
    return (count + 1) / 2;
}

uint32_t tia_sure_set_pairs(struct sure_pair *to, struct sure_node *nodes, const struct sure_tree *tree)
{
    uint32_t made = 0;

    for (uint32_t i = 0; i < tree->node_count; i++)
        for (int k = 0; k < 2; k++) {
            struct sure_node *n = &nodes[i];
            if (n->count[k] == SURE_INNER)
                continue;
            uint32_t count = set_leaf(&to[made], tree, &tree->items[n->index[k]], n->count[k]);
            n->index[k] = made;
            n->count[k] = count;
            made += count;
        }
    return made;
}
