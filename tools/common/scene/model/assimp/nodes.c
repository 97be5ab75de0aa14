/* nodes.c - the nodes of a model: which meshes they use, and where. */
#include <stdlib.h>
#include <string.h>

#include "convert.h"

#define DEPTH_MOST 1000
#define USES_MOST (UINT32_C(1) << 22)

static bool add_use(struct convert *c, const struct affine *place, uint32_t mesh)
{
    if (c->use_count == c->use_room) {
        uint32_t room = c->use_room * 2 + 64;
        struct mesh_use *uses = realloc(c->uses, room * sizeof *uses);
        if (!uses)
            return false;
        c->uses = uses;
        c->use_room = room;
    }
    uint32_t material = c->from->mMeshes[mesh]->mMaterialIndex, last = c->from->mNumMaterials;
    c->uses[c->use_count] = (struct mesh_use){
        .to_world = *place, .mesh = mesh, .material = material < last ? material : last, .number = c->use_count};
    c->use_count++;
    c->mesh_uses[mesh]++;
    return true;
}

static int add_node(struct convert *c, const struct aiNode *node, const struct affine *place)
{
    if (node->mNumMeshes > 0 && !affine_is_finite(place)) {
        convert_warn(c, TIA_WARN_FACE, "node '%.100s' is placed by numbers that are not finite: left out",
                     node->mName.data);
        return TIA_OK;
    }
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        if (c->use_count == USES_MOST)
            return convert_fail(c, TIA_ERR_RANGE, "the model has too many parts, expected at most %u", USES_MOST);
        if (node->mMeshes[i] < c->from->mNumMeshes && !add_use(c, place, node->mMeshes[i]))
            return convert_exhausted(c);
    }
    return TIA_OK;
}

/* Recursion is bounded by DEPTH_MOST. */
static int walk(struct convert *c, const struct aiNode *node, const struct affine *above, unsigned depth)
{
    struct affine own = affine_of(&node->mTransformation), place = affine_product(above, &own);

    if (depth == DEPTH_MOST)
        return convert_fail(c, TIA_ERR_RANGE, "nodes nest deeper than %d", DEPTH_MOST);
    int status = add_node(c, node, &place);
    for (unsigned i = 0; !status && i < node->mNumChildren; i++)
        status = walk(c, node->mChildren[i], &place, depth + 1);
    return status;
}

/* Orders uses by material, then by number. */
static int compare_uses(const void *a, const void *b)
{
    const struct mesh_use *first = a, *second = b;

    if (first->material != second->material)
        return first->material < second->material ? -1 : 1;
    return first->number < second->number ? -1 : 1;
}

int convert_nodes(struct convert *c)
{
    const struct affine one = affine_one();

    if (!c->from->mRootNode)
        return TIA_OK;
    c->mesh_uses = calloc(c->from->mNumMeshes + (size_t)1, sizeof *c->mesh_uses);
    if (!c->mesh_uses)
        return convert_exhausted(c);
    int status = walk(c, c->from->mRootNode, &one, 0);
    if (!status && c->use_count > 0)
        qsort(c->uses, c->use_count, sizeof *c->uses, compare_uses);
    return status;
}

static const struct aiNode *find(const struct aiNode *node, const struct aiString *name, unsigned depth)
{
    const struct aiNode *found = strcmp(node->mName.data, name->data) == 0 ? node : NULL;

    for (unsigned i = 0; !found && depth < DEPTH_MOST && i < node->mNumChildren; i++)
        found = find(node->mChildren[i], name, depth + 1);
    return found;
}

bool convert_node_place(const struct convert *c, const struct aiString *name, struct affine *place)
{
    const struct aiNode *node = c->from->mRootNode ? find(c->from->mRootNode, name, 0) : NULL;
    bool found = node;

    *place = affine_one();
    for (; node; node = node->mParent) {
        struct affine own = affine_of(&node->mTransformation);
        *place = affine_product(&own, place);
    }
    return found && affine_is_finite(place);
}
