/* scene_memory.h - the memory and flash that a scene takes on a machine of another kind. */
#ifndef TIA_COMPILE_SCENE_MEMORY_H
#define TIA_COMPILE_SCENE_MEMORY_H

#include "common/convert.h"

/* Writes request->memory, a header with the results of tia_view_size and tia_hits_size and the viewer's memory. TIA_OK,
 * or a failure with the reason in `why`, PORT_WHY bytes. */
int memory_write(const struct request *request, const struct tia_scene *scene, char *why);

#endif
