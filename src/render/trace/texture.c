#include "texture.h"

#include "rgb.h"

static uint32_t checker(const struct tia_texture *t, const int32_t cell[2], num_length rgb[3])
{
    uint32_t colour = (uint32_t)(cell[0] ^ cell[1]) & 1;

    ray_rgb(&t->cells[colour], rgb);
    return colour;
}

static unsigned channels_of(const struct tia_texture *t)
{
    return t->kind == TIA_OPACITY ? 1 : 3;
}

/* Returns texel (x, y), counted from the lower left; rows are stored from the top. Images repeat; x and y are at most
 * one beyond the edges. */
static const uint8_t *texel(const struct tia_texture *t, int32_t x, int32_t y)
{
    x = x < 0 ? x + t->width : x >= t->width ? x - t->width : x;
    y = y < 0 ? y + t->height : y >= t->height ? y - t->height : y;
    return t->texels + channels_of(t) * ((size_t)(t->height - 1 - y) * t->width + (size_t)x);
}

/* Interpolates the four texels around the position bilinearly. */
static void blend(const struct tia_texture *t, num_length u, num_length v, num_length value[])
{
    int32_t x = num_floor(u), y = num_floor(v);
    num_length right = u - num_integer(x), up = v - num_integer(y);
    const uint8_t *lower[2] = {texel(t, x, y), texel(t, x + 1, y)};
    const uint8_t *upper[2] = {texel(t, x, y + 1), texel(t, x + 1, y + 1)};

    for (unsigned c = 0; c < channels_of(t); c++) {
        num_length above = num_integer(upper[0][c]) + right * (upper[1][c] - upper[0][c]);
        num_length below = num_integer(lower[0][c]) + right * (lower[1][c] - lower[0][c]);
        value[c] = num_ratio(below + num_product(above - below, up), num_integer(255));
    }
}

static uint32_t nearest(const struct tia_texture *t, num_length u, num_length v, num_length value[])
{
    const uint8_t *found = texel(t, num_floor(u), num_floor(v));

    for (unsigned c = 0; c < channels_of(t); c++)
        value[c] = num_ratio(num_integer(found[c]), num_integer(255));
    return (uint32_t)(found - t->texels) / channels_of(t);
}

static num_length place(const struct tia_texture *t, int axis, num_length x, int bits, int32_t *cell)
{
    const struct num_pattern pattern = {t->repeat[axis], t->offset[axis], t->repeat_bits, t->offset_bits};

    return num_repeat(x, bits, &pattern, cell);
}

uint32_t ray_texture(const struct tia_texture *t, const num_length uv[2], int bits, num_length value[])
{
    int32_t cell[2];
    num_length u = place(t, 0, uv[0], bits, &cell[0]), v = place(t, 1, uv[1], bits, &cell[1]);

    if (t->kind == TIA_CHECKER)
        return checker(t, cell, value);
    if (!t->bilinear)
        return nearest(t, u * t->width, v * t->height, value);
    blend(t, u * t->width - NUM_LENGTH_ONE / 2, v * t->height - NUM_LENGTH_ONE / 2, value);
    return 0;
}
