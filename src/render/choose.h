/* choose.h - what a scene asks for. */
#ifndef TIA_NEEDS_H
#define TIA_NEEDS_H

#include <tia/scene.h>

#include "num/num.h"

/* Whether the scene is drawn by general rays, see tia/scene.h. */
bool scene_needs_rays(const struct tia_scene *scene);

#endif
