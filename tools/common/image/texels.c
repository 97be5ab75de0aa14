#include "texels.h"

#include <stdlib.h>

int image_room(struct image_texels *texels, uint64_t width, uint64_t height, unsigned side, size_t most,
               const char **why)
{
    if (width == 0 || height == 0) {
        *why = "an empty picture";
        return TIA_ERR_RANGE;
    }
    if (width > side || height > side || width * height > most / 3) {
        *why = "too large a picture";
        return TIA_ERR_RANGE;
    }
    texels->width = (unsigned)width;
    texels->height = (unsigned)height;
    texels->rgb = malloc((size_t)(width * height * 3));
    *why = "memory: exhausted";
    return texels->rgb ? TIA_OK : TIA_ERR_MEMORY;
}
