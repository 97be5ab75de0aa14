/* texture.h - a texture's value at surface coordinates, see tia/material.h. */
#ifndef TIA_RENDER_TRACE_TEXTURE_H
#define TIA_RENDER_TRACE_TEXTURE_H

#include "num/num_ray.h"

/* At 2^bits uv. `value` receives red, green and blue, or of TIA_OPACITY one number. Returns which of the texture's
 * values it is: a checker's cell, 0 or 1, or the number of a texel; 0 for a blend of texels. */
uint32_t ray_texture(const struct tia_texture *texture, const num_length uv[2], int bits, num_length value[]);

/* Whether the path hash has what ray_texture returns. */
static inline bool ray_texture_is_hashed(const struct tia_texture *texture)
{
    return texture->kind == TIA_CHECKER || !texture->bilinear;
}

#endif
