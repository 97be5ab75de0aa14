/* pack_write.h - the arrays of a packed model, which grow. */
#ifndef TOOLS_SCENE_MODEL_ASSIMP_PACK_WRITE_H
#define TOOLS_SCENE_MODEL_ASSIMP_PACK_WRITE_H

#include "common/scene/model/model_pack.h"

struct pack_array {
    char *items;
    uint64_t count, room; /* elements */
    size_t element;
};

/* The arrays of a model. */
struct pack {
    struct model_header header;
    struct pack_array arrays[MODEL_ARRAYS];
};

void pack_init(struct pack *pack);

/* Adds `count` elements of zeros. Returns the first one, or NULL if there is no memory. */
void *pack_grow(struct pack_array *array, uint64_t count);

/* Adds an element. Returns false if there is no memory. */
bool pack_add(struct pack_array *array, const void *element);

/* Writes header and arrays. Returns false if they do not fit. */
bool pack_write(struct pack *pack, int fd);

#endif
