#include "scene/picture.h"
#include "scene_check.h"

/* True if a number is 0 or that of a texture: an opacity, or another one. */
static bool is_texture(const struct check *check, uint32_t number, bool opacity)
{
    const struct tia_scene *scene = check->scene;

    return !number || (number <= scene->texture_count && (scene->textures[number - 1].kind == TIA_OPACITY) == opacity);
}

int tia_check_textures_of(const struct check *check, const struct tia_material *m)
{
    REQUIRE(is_texture(check, m->texture, false), "texture",
            "must be 0 or the number of a checker, an image or a noise");
    REQUIRE(is_texture(check, m->opacity, true), "opacity", "must be 0 or the number of an opacity texture");
    REQUIRE(m->bump <= check->scene->texture_count, "bump", "must be 0 or the number of a texture");
    return TIA_OK;
}

static bool is_repeat(tia_q16 x)
{
    return x >= TIA_Q16_ONE / 1024;
}

static bool is_bits(int8_t bits)
{
    return bits >= TIA_TEXTURE_BITS_MIN && bits <= TIA_TEXTURE_BITS_MAX;
}

int tia_check_texture(const struct check *check)
{
    const struct tia_texture *t = &check->scene->textures[check->index];

    REQUIRE(t->kind == TIA_CHECKER || texture_has_texels(t) || t->kind == TIA_NOISE, "kind",
            "must be a checker, an image, an opacity or a noise");
    REQUIRE(is_repeat(t->repeat[0]) && is_repeat(t->repeat[1]), "repeat", "must be 1/1024 or more");
    REQUIRE(is_bits(t->repeat_bits), "repeat_bits", "must be in -8..12");
    REQUIRE(is_bits(t->offset_bits), "offset_bits", "must be in -8..12");
    REQUIRE(t->depth >= -TIA_BUMP_MAX && t->depth <= TIA_BUMP_MAX, "depth", "must be in -64..64");
    REQUIRE(t->kind != TIA_NOISE || tia_check_is_between(t->octaves, 1, TIA_OCTAVES_MAX), "octaves", "must be in 1..8");
    if (!texture_has_texels(t)) {
        REQUIRE(tia_check_is_unit(&t->cells[0]) && tia_check_is_unit(&t->cells[1]), "cells", CHECK_UNIT);
    } else {
        REQUIRE(tia_check_is_between(t->width, 1, TIA_TEXTURE_MAX), "width", "must be in 1..16384");
        REQUIRE(tia_check_is_between(t->height, 1, TIA_TEXTURE_MAX), "height", "must be in 1..16384");
        REQUIRE(t->texels, "texels", "must not be NULL");
    }
    return TIA_OK;
}
