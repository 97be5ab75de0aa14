/* facets.h - into how many flat faces curved shapes are divided, so that no point of a face is farther from the surface
 * than the scene allows. */
#ifndef TIA_SCENE_FACETS_H
#define TIA_SCENE_FACETS_H

#include <tia/scene.h>

struct tia_facets {
    uint32_t around; /* corners of a full circle: a multiple of 4 */
    uint64_t points, faces;
};

/* Of a sphere, disc, cylinder or cone of a scene with `tessellated`; false: the object is none, or there it is not. Far
 * more faces than TIA_OBJECTS_MAX when the corners would be too many to place. */
bool tia_facets_of(const struct tia_scene *scene, uint32_t object, struct tia_facets *facets);

#endif
