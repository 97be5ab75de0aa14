/* picture.h - textures that have texels. */
#ifndef TIA_SCENE_PICTURE_H
#define TIA_SCENE_PICTURE_H

#include <tia/material.h>

static inline bool texture_has_texels(const struct tia_texture *texture)
{
    return texture->kind == TIA_IMAGE || texture->kind == TIA_OPACITY;
}

#endif
