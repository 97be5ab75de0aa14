/* texture.h - a texture's value at surface coordinates, see tia/material.h. */
#ifndef TIA_RENDER_TRACE_TEXTURE_H
#define TIA_RENDER_TRACE_TEXTURE_H

#include "trace.h"

/* A place on a surface: the surface coordinates or, for TIA_NOISE, the point in the shape's axes, times 2^-bits. */
struct texture_place {
    num_length at[3];
    int bits;
};

/* Gives the place of the hit's point, or of a point near it, for a texture. */
void ray_texture_place(const struct ray_view *view, const struct tia_texture *texture, const struct hit *hit,
                       struct num_point point, struct texture_place *place);

/* Computes the texture's value at a place. `value` becomes red, green and blue, or one number for TIA_OPACITY. Returns
 * the index of the value in the texture: a checker's cell, 0 or 1, or the number of a texel; 0 for a blend. */
uint32_t ray_texture(const struct tia_texture *texture, const struct texture_place *place, num_length value[]);

/* Returns the numbers of a texture along an axis of its places. */
static inline struct num_pattern texture_pattern(const struct tia_texture *t, int axis)
{
    int number = axis == 1;

    return (struct num_pattern){t->repeat[number], axis == 2 ? 0 : t->offset[number], t->repeat_bits, t->offset_bits};
}

/* True if the path hash includes ray_texture's result. */
static inline bool ray_texture_is_hashed(const struct tia_texture *texture)
{
    return texture->kind == TIA_CHECKER || (texture->kind != TIA_NOISE && !texture->bilinear);
}

#endif
