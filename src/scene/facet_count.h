/* facet_count.h - number of flat faces of curved shapes, such that no point of a face is farther from the surface than
 * the scene allows. */
#ifndef TIA_SCENE_FACET_COUNT_H
#define TIA_SCENE_FACET_COUNT_H

#include <tia/scene.h>

struct tia_facets {
    uint32_t around; /* corners of a full circle, a multiple of 4 */
    uint64_t points, faces;
};

/* Gives the division of a sphere, disc, cylinder or cone of a scene with `tessellated`; false if the object is none of
 * these, or not tessellated. When there would be too many corners, the number of faces is far above TIA_OBJECTS_MAX. */
bool tia_facets_of(const struct tia_scene *scene, uint32_t object, struct tia_facets *facets);

#endif
