#include "check.h"

#include "scene/colour.h"

int tia_check_material(const struct check *check)
{
    const struct tia_material *m = &check->scene->materials[check->index];

    REQUIRE(tia_check_is_unit(&m->colour), "colour", CHECK_UNIT);
    REQUIRE(tia_check_is_unit(&m->transmission), "transmission", CHECK_UNIT);
    REQUIRE(tia_check_is_unit(&m->emission), "emission", CHECK_UNIT);
    REQUIRE(tia_check_is_unit(&m->specular), "specular", CHECK_UNIT);
    REQUIRE(tia_check_is_unit(&m->mirror), "mirror", CHECK_UNIT);
    REQUIRE(tia_check_is_unit(&m->refraction), "refraction", CHECK_UNIT);
    REQUIRE(tia_check_is_unit(&m->facing), "facing", CHECK_UNIT);
    REQUIRE(colour_is_black(&m->specular) || tia_check_is_between(m->exponent, TIA_Q16_ONE, TIA_EXPONENT_MAX),
            "exponent", "must be in 1..10000");
    REQUIRE(colour_is_black(&m->refraction) || tia_check_is_between(m->index, TIA_INDEX_MIN, TIA_INDEX_MAX), "index",
            "must be in 0.25..4");
    REQUIRE(m->texture <= check->scene->texture_count, "texture", "must be 0 or the number of a texture");
    return TIA_OK;
}

static bool is_repeat(tia_q16 x)
{
    return tia_check_is_between(x, TIA_Q16_ONE / 1024, 1024 * TIA_Q16_ONE);
}

int tia_check_texture(const struct check *check)
{
    const struct tia_texture *t = &check->scene->textures[check->index];

    REQUIRE(t->kind == TIA_CHECKER || t->kind == TIA_IMAGE, "kind", "must be a checker or an image");
    REQUIRE(is_repeat(t->repeat[0]) && is_repeat(t->repeat[1]), "repeat", "must be in 1/1024..1024");
    if (t->kind == TIA_CHECKER) {
        REQUIRE(tia_check_is_unit(&t->cells[0]) && tia_check_is_unit(&t->cells[1]), "cells", CHECK_UNIT);
    } else {
        REQUIRE(tia_check_is_between(t->width, 1, TIA_TEXTURE_MAX), "width", "must be in 1..16384");
        REQUIRE(tia_check_is_between(t->height, 1, TIA_TEXTURE_MAX), "height", "must be in 1..16384");
        REQUIRE(t->texels, "texels", "must not be NULL");
    }
    return TIA_OK;
}
