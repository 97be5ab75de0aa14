#include "unit.h"

#include <stdio.h>

static void write_numbers(struct unit *unit, const uint32_t *numbers, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        text_word(&unit->text, "%uu,", numbers[i]);
}

/* Writes the tables of one tree, with names made from `name`. */
static void write_tree(struct unit *unit, const struct tia_bvh_tree *tree, const char *name)
{
    if (tree->node_count == 0)
        return;
    table_begin(unit, "struct tia_bvh_node", "%s_nodes", name);
    for (uint32_t i = 0; i < tree->node_count; i++) {
        const struct tia_bvh_node *n = &tree->nodes[i];
        text_word(&unit->text, "{{{%d, %d, %d}, {%d, %d, %d}}, %uu, %uu},", n->bounds.min.x, n->bounds.min.y,
                  n->bounds.min.z, n->bounds.max.x, n->bounds.max.y, n->bounds.max.z, n->index, n->count);
    }
    table_end(unit);
    table_begin(unit, "uint32_t", "%s_items", name);
    write_numbers(unit, tree->items, tree->item_count);
    table_end(unit);
}

static void refer_to_tree(struct unit *unit, const struct tia_bvh_tree *tree, const char *name)
{
    text_word(&unit->text, "{");
    field_table(unit, "nodes", tree->node_count, "%s_nodes", name);
    field_table(unit, "items", tree->node_count, "%s_items", name);
    text_word(&unit->text, ".node_count = %uu,", tree->node_count);
    field_unsigned(unit, "item_count", tree->item_count);
    text_print(&unit->text, "},\n");
}

static void write_mesh_trees(struct unit *unit, const struct tia_bvh *bvh)
{
    uint32_t count = unit->scene->mesh_count;
    char name[24];

    for (uint32_t i = 0; i < count; i++) {
        (void)snprintf(name, sizeof name, "mesh_%u", i);
        write_tree(unit, &bvh->meshes[i], name);
    }
    if (count == 0)
        return;
    table_begin(unit, "struct tia_bvh_tree", "trees");
    for (uint32_t i = 0; i < count; i++) {
        (void)snprintf(name, sizeof name, "mesh_%u", i);
        refer_to_tree(unit, &bvh->meshes[i], name);
    }
    table_end(unit);
}

void unit_bvh(struct unit *unit)
{
    const struct tia_bvh *bvh = unit->scene->bvh;

    if (!bvh)
        return;
    write_tree(unit, &bvh->objects, "objects");
    write_mesh_trees(unit, bvh);
    if (bvh->unbounded_count > 0) {
        table_begin(unit, "uint32_t", "unbounded");
        write_numbers(unit, bvh->unbounded, bvh->unbounded_count);
        table_end(unit);
    }
    text_print(&unit->text, "static const struct tia_bvh %s_bvh = {\n", unit->symbol);
    text_word(&unit->text, ".objects =");
    refer_to_tree(unit, &bvh->objects, "objects");
    field_table(unit, "meshes", unit->scene->mesh_count, "trees");
    field_table(unit, "unbounded", bvh->unbounded_count, "unbounded");
    field_unsigned(unit, "unbounded_count", bvh->unbounded_count);
    table_end(unit);
}
