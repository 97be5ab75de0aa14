/* facets.h - the corners and faces of curved shapes that are divided into flat faces, see scene/facet_count.h. */
#ifndef TIA_FLAT_FACETS_H
#define TIA_FLAT_FACETS_H

#include "edges.h"
#include "scene/facet_count.h"

/* A shape in its own axes. Each circle has its first corner along across[0], and the next ones towards across[1]. */
struct tia_facet_shape {
    enum tia_shape_kind kind;
    uint32_t around;
    bool capped;
    int64_t centre[2][3], radius[2]; /* Q31.32: of a sphere or disc in [0], of other shapes one for each end */
    int64_t across[2][3];            /* axes perpendicular to the shape's own, Q1.62; not set for a sphere */
};

/* Prepares an object that tia_facets_of divides. */
void tia_facet_shape_init(struct tia_facet_shape *shape, const struct tia_scene *scene, uint32_t object);

/* Gives point i, Q31.32. */
void tia_facet_point(const struct tia_facet_shape *shape, uint32_t i, int64_t point[3]);

/* Returns face i; its corners are indices of points. */
struct tia_flat_face tia_facet_face(const struct tia_facet_shape *shape, uint32_t i);

/* Gives the numbers of faces of parts 0 and 1, see debug.h: the shape's side, whose faces come first, and its base. */
void tia_facet_parts(const struct tia_facet_shape *shape, uint32_t parts[2]);

#endif
