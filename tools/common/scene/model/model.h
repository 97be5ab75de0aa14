/* model.h - reads models in the formats of libassimp: glTF, FBX, Collada, 3DS and others.
 *
 * The library parses files in dozens of formats and is written in C++, so damaged files crash it now and then. It
 * therefore runs in a process of its own, with bounds for memory and time, which converts the model to a scene in
 * integers. This process maps the result and checks it.
 */
#ifndef TOOLS_SCENE_MODEL_MODEL_H
#define TOOLS_SCENE_MODEL_MODEL_H

#include "common/scene/file.h"

/* True if libassimp reads files with this extension, which begins behind the dot, and tia has no reader of its own. */
bool model_is_extension(const char *extension);

/* Reads file->path into file->scene, which has no hierarchy yet, as scene_open does. Models without a camera or without
 * lights get those of .obj files. After an error, call model_close. */
int model_open(struct scene_file *file, bool strict);

/* Prepares for reading a model in this process, which will be confined; see assimp/import.h. Does nothing without
 * libassimp. */
void model_confine(void);

void model_close(struct scene_file *file);

#endif
