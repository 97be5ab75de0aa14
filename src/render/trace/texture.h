/* texture.h - a texture's value at surface coordinates, see tia/material.h. */
#ifndef TIA_RENDER_TRACE_TEXTURE_H
#define TIA_RENDER_TRACE_TEXTURE_H

#include "scene/picture.h"
#include "trace.h"

/* A place on a surface: the surface coordinates or, for TIA_NOISE, the point in the shape's axes, times 2^-bits. */
struct texture_place {
    num_length at[3];
    int bits;
};

/* Gives the place of the hit's point, or of a point near it, for a texture. */
void ray_texture_place(const struct ray_view *view, const struct tia_texture *texture, const struct hit *hit,
                       struct num_point point, struct texture_place *place);

/* Returns the number of a texture's axes: noise fills space. */
static inline int texture_axes(const struct tia_texture *t)
{
    return t->kind == TIA_NOISE ? 3 : 2;
}

/* Gives the change of the place from a point near the hit, whose place is `from`, to another one, in the texture's
 * cells, each at most 2^12. A change of more than a unit of length is that of the first part of the way, continued. */
void ray_texture_change(const struct ray_view *view, const struct tia_texture *texture, const struct hit *hit,
                        struct num_point point, const struct texture_place *from, struct num_point change,
                        num_length cells[3]);

/* Computes the texture's value at a place. `value` becomes red, green and blue, or one number for TIA_OPACITY. Returns
 * the index of the value in the texture: a checker's cell, 0 or 1, or the number of a texel; 0 for a blend. */
uint32_t ray_texture(const struct tia_texture *texture, const struct texture_place *place, num_length value[]);

/* Rows of texels, from the top. */
struct texels {
    const uint8_t *first;
    int32_t width, height;
    uint32_t channels;
};

/* Returns the texels of a picture as they are given. */
static inline struct texels texture_texels(const struct tia_texture *t)
{
    return (struct texels){t->texels, t->width, t->height, picture_channels(t)};
}

/* Interpolates the four texels around a position bilinearly. Positions are in texels from the centre of the lower left
 * one, and at most one beyond the edges. */
void texture_blend(const struct texels *t, num_length u, num_length v, num_length value[]);

/* Gives the position in the texture's cells along one of its axes: the cell, and the part of it, 0..1. */
num_length texture_position(const struct tia_texture *t, int axis, const struct texture_place *place, int32_t *cell);

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
