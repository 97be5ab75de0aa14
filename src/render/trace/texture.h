/* texture.h - a texture's value at surface coordinates, see tia/material.h. */
#ifndef TIA_RENDER_TRACE_TEXTURE_H
#define TIA_RENDER_TRACE_TEXTURE_H

#include "num/num_ray.h"

/* Computes the texture's value at the surface coordinates 2^bits uv. `value` becomes red, green and blue, or one number
 * for TIA_OPACITY. Returns the index of the value in the texture: a checker's cell, 0 or 1, or the number of a texel; 0
 * for a blend of texels. */
uint32_t ray_texture(const struct tia_texture *texture, const num_length uv[2], int bits, num_length value[]);

/* True if the path hash includes ray_texture's result. */
static inline bool ray_texture_is_hashed(const struct tia_texture *texture)
{
    return texture->kind == TIA_CHECKER || !texture->bilinear;
}

#endif
