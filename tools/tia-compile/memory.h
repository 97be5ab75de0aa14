/* memory.h - how much memory a scene takes on a machine of another kind, and how much flash. */
#ifndef TIA_COMPILE_MEMORY_H
#define TIA_COMPILE_MEMORY_H

#include "common/convert.h"

/* Writes request->memory, a header with the sizes of what tia_view_size, tia_hits_size and the viewer ask for. TIA_OK,
 * or a failure with the reason in `why`, PORT_WHY bytes. */
int memory_write(const struct request *request, const struct tia_scene *scene, char *why);

#endif
