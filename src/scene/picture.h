/* picture.h - textures that have texels. */
#ifndef TIA_SCENE_PICTURE_H
#define TIA_SCENE_PICTURE_H

#include <tia/material.h>

static inline bool texture_has_texels(const struct tia_texture *texture)
{
    return texture->kind == TIA_IMAGE || texture->kind == TIA_OPACITY;
}

/* Returns the number of bytes of a texel. */
static inline uint32_t picture_channels(const struct tia_texture *texture)
{
    return texture->kind == TIA_OPACITY ? 1 : 3;
}

/* Returns a side of the next level, see tia/mip.h. */
static inline uint32_t picture_half(uint32_t side)
{
    return side > 1 ? side / 2 : 1;
}

#endif
