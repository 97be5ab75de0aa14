/* model_map.h - the scene of a packed model. */
#ifndef TOOLS_SCENE_MODEL_MODEL_MAP_H
#define TOOLS_SCENE_MODEL_MODEL_MAP_H

#include "model_pack.h"

/* Fills `scene` with the arrays of a packed model of `size` bytes. `tables` receives memory for its meshes and
 * textures, to be freed by free(). Returns TIA_OK; TIA_ERR_MEMORY; or TIA_ERR_RANGE if an array is not inside. */
int model_map(struct tia_scene *scene, void **tables, const struct model_header *header, size_t size);

/* Returns an array. */
const void *model_map_array(const struct model_header *header, enum model_array_name name);

#endif
