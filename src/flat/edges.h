/* edges.h - finds the face across each edge of faces that share corners. An edge is part of the silhouette if only one
 * of its two faces is turned to the light. */
#ifndef TIA_FLAT_EDGES_H
#define TIA_FLAT_EDGES_H

#include <tia/vec.h>

#include "scene/cancel.h"

#define TIA_SIDES 4              /* largest number of corners of a face */
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

/* Edge TIA_SIDES f + k runs from corner k of face f to the next corner. */

/* Returns the number of bytes of working memory for tia_weld. */
size_t tia_weld_room(uint32_t points);
/* Returns the number of bytes of working memory for tia_edges_join. */
size_t tia_edges_room(uint32_t faces);

/* Unites points with equal coordinates: first[i] becomes the lowest index of a point at point i's position. */
void tia_weld(uint32_t *first, const struct tia_vec3 *points, uint32_t count, void *room);

/* Pairs edges that run between the same points in opposite directions, each edge once, and sets across[e] to the
 * partner of e: TIA_NO_EDGE if there is none, e for an edge without length. Returns true if no edge has TIA_NO_EDGE,
 * that is, if the faces form closed surfaces. Corners at the same position must have the same index. `across` has
 * TIA_SIDES * count elements; a triangle's fourth is not written. Once cancelled, the result is undefined. */
bool tia_edges_join(uint32_t *across, const struct tia_flat_face *faces, uint32_t count, void *room,
                    struct cancel *cancel);

#endif
