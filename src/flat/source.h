/* source.h - an object of a scene as points and flat faces, independent of the camera. */
#ifndef TIA_FLAT_SOURCE_H
#define TIA_FLAT_SOURCE_H

#include "facets.h"
#include "scene/hull.h"

/* The two faces of a plane are half planes; their common edge is a line from a direction at infinity to the opposite
 * one. */
#define TIA_PLANE_FACES 2
#define TIA_PLANE_POINTS 5

struct tia_flat_source {
    const struct tia_scene *scene;
    const struct tia_shape *shape; /* NULL: one of the scene's spheres */
    enum tia_shape_kind kind;
    uint32_t points, faces;
    uint32_t parts[2]; /* see tia_facet_parts */
    bool divided;      /* the object is curved, and divided into flat faces */
    struct tia_facet_shape facets;
    struct frame frame;
};

/* True for an instance of a mesh without faces, such as a hidden shape, see motion.h. Such an object is neither flat
 * nor curved. It needs no memory, so the memory for a scene with all its shapes suffices at all times. */
bool tia_flat_is_empty(const struct tia_scene *scene, uint32_t object);

/* True if an object is drawn as flat faces. Rays draw all grids, and curved objects unless the scene is tessellated. */
bool tia_flat_takes(const struct tia_scene *scene, uint32_t object);

/* Gives the numbers of points and faces of an object for which tia_flat_takes is true. */
void tia_flat_count(const struct tia_scene *scene, uint32_t object, uint64_t *points, uint64_t *faces);

void tia_flat_source_init(struct tia_flat_source *source, const struct tia_scene *scene, uint32_t object);

/* Returns the number of the object's points that have a position in the world. A plane has only point 0; its others are
 * directions. */
static inline uint32_t tia_flat_places(const struct tia_flat_source *source)
{
    return source->kind == TIA_PLANE ? 1 : source->points;
}

/* Gives point i in the world, Q31.32; i is below tia_flat_places. */
void tia_flat_source_point(const struct tia_flat_source *source, uint32_t i, int64_t world[3]);

/* Returns face i; its corners are indices of points. */
struct tia_flat_face tia_flat_source_face(const struct tia_flat_source *source, uint32_t i);

#endif
