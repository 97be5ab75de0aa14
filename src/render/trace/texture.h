/* texture.h - a texture's colour at surface coordinates, see tia/material.h. */
#ifndef TIA_RENDER_TRACE_TEXTURE_H
#define TIA_RENDER_TRACE_TEXTURE_H

#include "num/num_ray.h"

/* Returns which of the texture's colours it is: a checker's cell, 0 or 1, or the number of a texel; 0 for a blend of
 * texels. */
uint32_t ray_texture(const struct tia_texture *texture, const num_length uv[2], num_length rgb[3]);

#endif
