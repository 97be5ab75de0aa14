/* library.h - the functions of libassimp, which is loaded when a model is read. */
#ifndef TOOLS_SCENE_MODEL_ASSIMP_LIBRARY_H
#define TOOLS_SCENE_MODEL_ASSIMP_LIBRARY_H

#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <stdbool.h>

struct assimp_library {
    const struct aiScene *(*import)(const char *, unsigned, struct aiFileIO *, const struct aiPropertyStore *);
    const char *(*error)(void);
    struct aiPropertyStore *(*create_properties)(void);
    void (*set_integer)(struct aiPropertyStore *, const char *, int);
    unsigned (*major)(void);
    unsigned (*minor)(void);
};

/* Loads the library. On failure returns false and sets *why. */
bool assimp_load(struct assimp_library *library, const char **why);

#endif
