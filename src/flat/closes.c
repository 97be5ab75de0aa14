#include <tia/debug.h>
#include <tia/scene.h>

#include "edges.h"

/* The working memory holds an index for each point, followed first by the memory of tia_weld, then by the faces, the
 * edges across, and the memory of tia_edges_join. */
size_t tia_shadow_mesh_room(const struct tia_mesh *mesh)
{
    if (!mesh)
        return SIZE_MAX;
    size_t points = tia_weld_room(mesh->vertex_count), faces = tia_edges_room(mesh->face_count);

    faces += (size_t)mesh->face_count * (sizeof(struct tia_flat_face) + TIA_SIDES * sizeof(uint32_t));
    return (size_t)mesh->vertex_count * sizeof(uint32_t) + (points > faces ? points : faces);
}

bool tia_shadow_mesh_closes(const struct tia_mesh *mesh, void *room)
{
    if (!mesh || !room || (uintptr_t)room % sizeof(uint32_t))
        return false;
    uint32_t *first = room, *rest = first + mesh->vertex_count;
    struct tia_flat_face *faces = (void *)rest;
    uint32_t *across = (void *)(faces + mesh->face_count);
    struct cancel never = {.stop = NULL};

    tia_weld(first, mesh->vertices, mesh->vertex_count, rest);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        for (int k = 0; k < 3; k++)
            faces[f].corner[k] = first[mesh->faces[f].corner[k].vertex];
        faces[f].corner[TIA_SIDES - 1] = TIA_NO_CORNER;
    }
    return tia_edges_join(across, faces, mesh->face_count, across + (size_t)TIA_SIDES * mesh->face_count, &never);
}
