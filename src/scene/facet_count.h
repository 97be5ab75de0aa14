/* facet_count.h - number of flat faces for a curved shape, so that no point of a face is farther from the surface than
 * the scene allows. */
#ifndef TIA_SCENE_FACET_COUNT_H
#define TIA_SCENE_FACET_COUNT_H

#include <tia/scene.h>

struct tia_facets {
    uint32_t around; /* corners of a full circle, a multiple of 4 */
    uint64_t points, faces;
};

/* Computes the division of a sphere, disc, cylinder or cone. Returns false for other objects, and in a scene that is
 * not tessellated. If too many corners are needed, `faces` is far above TIA_OBJECTS_MAX. */
bool tia_facets_of(const struct tia_scene *scene, uint32_t object, struct tia_facets *facets);

#endif
