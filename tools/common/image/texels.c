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

void image_drop_alpha(struct image_texels *texels)
{
    free(texels->alpha);
    texels->alpha = NULL;
}

void image_free(struct image_texels *texels)
{
    free(texels->rgb);
    texels->rgb = NULL;
    image_drop_alpha(texels);
}

void image_split(struct image_texels *texels, unsigned char *rgba)
{
    size_t count = (size_t)texels->width * texels->height;
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < 3; c++)
            texels->rgb[3 * i + c] = rgba[4 * i + c];
    for (size_t i = 0; i < count; i++)
        rgba[i] = rgba[4 * i + 3];
    unsigned char *alpha = realloc(rgba, count);
    texels->alpha = alpha ? alpha : rgba;
}
