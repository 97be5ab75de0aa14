/* texture.c - the value of a texture. */
#include "rays.h"

/* Returns the index of a texel; x and y are integers of any size, counted from the upper left. */
static uint32_t texel_index(const struct tia_texture *texture, double x, double y)
{
    double w = texture->width, h = texture->height;
    uint32_t column = (uint32_t)(x - w * floor(x / w)), row = (uint32_t)(y - h * floor(y / h));

    return row * texture->width + column;
}

static struct colour texel(const struct tia_texture *texture, uint32_t index)
{
    const uint8_t *p = texture->texels + 3 * (size_t)index;

    if (texture->kind == TIA_OPACITY) {
        double grey = texture->texels[index] / 255.0;
        return (struct colour){{grey, grey, grey}};
    }
    return (struct colour){{p[0] / 255.0, p[1] / 255.0, p[2] / 255.0}};
}

/* Returns the interpolation between a and b, exactly a if they are equal: opaque texels must not transmit 1e-16 of the
 * light. */
static struct colour between(struct colour a, struct colour b, double part)
{
    for (int i = 0; i < 3; i++)
        a.channel[i] += part * (b.channel[i] - a.channel[i]);
    return a;
}

/* Returns the interpolation of the four texels around (x, y); the centres of texels have integer coordinates. */
static struct colour bilinear(const struct tia_texture *texture, double x, double y)
{
    double left = floor(x), top = floor(y);
    struct colour row[2];

    for (int i = 0; i < 2; i++) {
        struct colour first = texel(texture, texel_index(texture, left, top + i));
        row[i] = between(first, texel(texture, texel_index(texture, left + 1, top + i)), x - left);
    }
    return between(row[0], row[1], y - top);
}

struct colour oracle_texture(const struct tia_texture *texture, double u, double v, uint32_t *cell)
{
    const double repeat = ldexp(1, -texture->repeat_bits), offset = ldexp(1, -texture->offset_bits);

    u = q16(texture->repeat[0]) * repeat * (u - q16(texture->offset[0]) * offset);
    v = q16(texture->repeat[1]) * repeat * (v - q16(texture->offset[1]) * offset);
    if (texture->kind == TIA_CHECKER) {
        *cell = fmod(floor(u) + floor(v), 2.0) != 0;
        return rgb(texture->cells[*cell]);
    }
    *cell = ORACLE_BLENDED;
    if (texture->bilinear)
        return bilinear(texture, u * texture->width - 0.5, (1 - v) * texture->height - 0.5);
    /* counted from the lower left, a texel includes its lower and left edge */
    *cell = texel_index(texture, floor(u * texture->width), texture->height - 1 - floor(v * texture->height));
    return texel(texture, *cell);
}
