/* limit_textures.h - the limits of textures; limit_cases.h includes it. */
#ifndef TESTS_LIMIT_TEXTURES_H
#define TESTS_LIMIT_TEXTURES_H

LIMIT(fewest_repeats)
{
    materials[0].texture = 1;
    texture.repeat[0] = texture.repeat[1] = ONE / 1024 - beyond;
}

LIMIT(least_repeat_bits)
{
    materials[1].texture = 1;
    texture.repeat[0] = texture.repeat[1] = INT32_MAX;
    texture.repeat_bits = (int8_t)(TIA_TEXTURE_BITS_MIN - beyond);
    texture.footprint = true;
}

LIMIT(most_repeat_bits)
{
    materials[0].texture = 1;
    texture.repeat[0] = texture.repeat[1] = INT32_MAX;
    texture.repeat_bits = (int8_t)(TIA_TEXTURE_BITS_MAX + beyond);
    texture.footprint = true;
}

LIMIT(least_offset_bits)
{
    materials[0].texture = 1;
    texture.offset_bits = (int8_t)(TIA_TEXTURE_BITS_MIN - beyond);
}

LIMIT(most_offset_bits)
{
    materials[1].texture = 1;
    texture.offset_bits = (int8_t)(TIA_TEXTURE_BITS_MAX + beyond);
}

LIMIT(widest_image)
{
    texture.kind = TIA_IMAGE;
    materials[0].texture = 1;
    texture.width = (uint16_t)(TIA_TEXTURE_MAX + beyond);
}

LIMIT(highest_image)
{
    texture.kind = TIA_IMAGE;
    texture.bilinear = true;
    materials[1].texture = 1;
    texture.height = (uint16_t)(TIA_TEXTURE_MAX + beyond);
}

#endif
