#include "texture.h"

#include "noise.h"
#include "rgb.h"

void ray_texture_place(const struct ray_view *view, const struct tia_texture *texture, const struct hit *hit,
                       struct num_point point, struct texture_place *place)
{
    if (texture->kind != TIA_NOISE) {
        place->bits = ray_uv(view, hit, point, place->at);
        return;
    }
    struct num_point own = ray_own_point(view, hit, point);
    place->at[0] = own.x;
    place->at[1] = own.y;
    place->at[2] = own.z;
    place->bits = -view->scene->scale_bits;
}

static uint32_t checker(const struct tia_texture *t, const int32_t cell[2], num_length rgb[3])
{
    uint32_t colour = (uint32_t)(cell[0] ^ cell[1]) & 1;

    ray_rgb(&t->cells[colour], rgb);
    return colour;
}

/* Returns texel (x, y), counted from the lower left; rows are stored from the top. Images repeat; x and y are at most
 * one beyond the edges. */
static const uint8_t *texel(const struct texels *t, int32_t x, int32_t y)
{
    x = x < 0 ? x + t->width : x >= t->width ? x - t->width : x;
    y = y < 0 ? y + t->height : y >= t->height ? y - t->height : y;
    return t->first + t->channels * ((size_t)(t->height - 1 - y) * (size_t)t->width + (size_t)x);
}

void texture_blend(const struct texels *t, num_length u, num_length v, num_length value[])
{
    int32_t x = num_floor(u), y = num_floor(v);
    num_length right = u - num_integer(x), up = v - num_integer(y);
    const uint8_t *lower[2] = {texel(t, x, y), texel(t, x + 1, y)};
    const uint8_t *upper[2] = {texel(t, x, y + 1), texel(t, x + 1, y + 1)};

    for (unsigned c = 0; c < t->channels; c++) {
        num_length above = num_integer(upper[0][c]) + right * (upper[1][c] - upper[0][c]);
        num_length below = num_integer(lower[0][c]) + right * (lower[1][c] - lower[0][c]);
        value[c] = num_ratio(below + num_product(above - below, up), num_integer(255));
    }
}

static uint32_t nearest(const struct texels *t, num_length u, num_length v, num_length value[])
{
    const uint8_t *found = texel(t, num_floor(u), num_floor(v));

    for (unsigned c = 0; c < t->channels; c++)
        value[c] = num_ratio(num_integer(found[c]), num_integer(255));
    return (uint32_t)(found - t->first) / t->channels;
}

num_length texture_position(const struct tia_texture *t, int axis, const struct texture_place *place, int32_t *cell)
{
    const struct num_pattern pattern = texture_pattern(t, axis);

    return num_repeat(place->at[axis], place->bits, &pattern, cell);
}

static void noise(const struct tia_texture *t, const struct texture_place *place, num_length rgb[3])
{
    struct noise_place at;

    for (int i = 0; i < 3; i++)
        at.part[i] = texture_position(t, i, place, &at.cell[i]);
    ray_rgb_blend(t->cells, num_length_clamp(noise_value(&at, t->octaves, 0), 0, NUM_LENGTH_ONE), rgb);
}

uint32_t ray_texture(const struct tia_texture *t, const struct texture_place *place, num_length value[])
{
    int32_t cell[2];

    if (t->kind == TIA_NOISE) {
        noise(t, place, value);
        return 0;
    }
    num_length u = texture_position(t, 0, place, &cell[0]), v = texture_position(t, 1, place, &cell[1]);
    if (t->kind == TIA_CHECKER)
        return checker(t, cell, value);
    const struct texels texels = texture_texels(t);
    u *= t->width;
    v *= t->height;
    if (!t->bilinear)
        return nearest(&texels, u, v, value);
    texture_blend(&texels, u - NUM_LENGTH_ONE / 2, v - NUM_LENGTH_ONE / 2, value);
    return 0;
}
