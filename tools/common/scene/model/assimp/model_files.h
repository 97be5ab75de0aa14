/* model_files.h - the files of a model: regular ones alone, of bounded size, each noted. */
#ifndef TOOLS_SCENE_MODEL_ASSIMP_MODEL_FILES_H
#define TOOLS_SCENE_MODEL_ASSIMP_MODEL_FILES_H

#include <assimp/cfileio.h>

#include "common/scene/file.h"
#include "common/scene/whole_file.h"
#include "pack_write.h"

struct model_files {
    const struct scene_file *file;
    struct pack_array *noted; /* MODEL_FILES */
    size_t left;              /* bytes that may still be read */
    struct aiFileIO io;       /* for the library; its UserData is this struct */
};

void model_files_init(struct model_files *files, const struct scene_file *file, struct pack_array *noted);

/* Reads a file whole, as whole_read does, unless scene_opens refuses it. */
int model_files_read(struct model_files *files, const char *path, struct whole *whole, const char **why);

/* Reads a file that the model calls `name`: relative to its folder; with slashes for backslashes; or, where a path of
 * another machine is named, in its folder. */
int model_files_read_named(struct model_files *files, const char *name, struct whole *whole, const char **why);

#endif
