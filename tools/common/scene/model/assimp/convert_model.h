/* convert_model.h - a model of libassimp as a scene: what runs in the importing process. */
#ifndef TOOLS_SCENE_MODEL_ASSIMP_CONVERT_MODEL_H
#define TOOLS_SCENE_MODEL_ASSIMP_CONVERT_MODEL_H

#include "common/scene/file.h"

/* Imports the model file->path, and writes it to the empty file `fd`. Returns TIA_OK; or an error that the header in
 * the file has, with its reason. Memory is left to the end of the process. */
int convert_model(int fd, const struct scene_file *file);

#endif
