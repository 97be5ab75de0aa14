/* edges.h - finds the face across each edge of faces that share corners. Where one of two neighbours faces the light
 * and the other does not, their edge is part of the silhouette. */
#ifndef TIA_FLAT_EDGES_H
#define TIA_FLAT_EDGES_H

#include <tia/vec.h>

#include "scene/cancel.h"

#define TIA_SIDES 4              /* the most corners that a face has */
#define TIA_NO_CORNER UINT32_MAX /* the fourth corner of a triangle */
#define TIA_NO_EDGE UINT32_MAX

/* A flat face; its corners run counterclockwise seen from outside. */
struct tia_flat_face {
    uint32_t corner[TIA_SIDES]; /* indices of points */
};

static inline unsigned tia_face_sides(const struct tia_flat_face *face)
{
    return face->corner[TIA_SIDES - 1] == TIA_NO_CORNER ? TIA_SIDES - 1 : TIA_SIDES;
}

/* Edges are numbered: from corner k of face f to the next corner is edge TIA_SIDES f + k. */

/* Returns the bytes of room for tia_weld. */
size_t tia_weld_room(uint32_t points);
/* Returns the bytes of room for tia_edges_join. */
size_t tia_edges_room(uint32_t faces);

/* Unites points of equal coordinates: first[i] becomes the lowest index of a point at the position of point i. */
void tia_weld(uint32_t *first, const struct tia_vec3 *points, uint32_t count, void *room);

/* Sets across[e] to an edge that runs the other way between the same points, each used once, or to TIA_NO_EDGE; an edge
 * without length is its own neighbour. Returns true if each edge has one, that is if the faces close. Corners at one
 * position must have one index. across has TIA_SIDES `count` elements; the fourth of a triangle is not written. Once
 * cancelled, the result is undefined. */
bool tia_edges_join(uint32_t *across, const struct tia_flat_face *faces, uint32_t count, void *room,
                    struct cancel *cancel);

#endif
