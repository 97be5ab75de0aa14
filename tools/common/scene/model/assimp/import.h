/* import.h - the process that imports a model by libassimp. */
#ifndef TOOLS_SCENE_MODEL_ASSIMP_IMPORT_H
#define TOOLS_SCENE_MODEL_ASSIMP_IMPORT_H

#include "common/scene/file.h"
#include "common/scene/model/model_pack.h"

#define IMPORT_SECONDS 120 /* processor time */
#define IMPORT_MEMORY ((uint64_t)4 << 30)

struct import_result {
    int fd; /* the packed model, to be closed; -1: none */
    char why[MODEL_WHY];
};

/* Loads the library. From then on models are imported in this process, which is confined already, and may neither open
 * the library's file nor make processes. A missing library is reported by import_run. */
void import_here(void);

/* Imports the model file->path in a process of its own, with the bounds above; it opens no file that scene_opens
 * refuses. Returns TIA_OK; or TIA_ERR_DEVICE, TIA_ERR_RANGE or TIA_ERR_MEMORY, with the reason. */
int import_run(struct import_result *result, const struct scene_file *file);

#endif
