#include "scene_check.h"

#include "scene/colour.h"

static bool has_texture(const struct check *check, uint32_t number, bool opacity)
{
    return !number || (check->more && check->more->has_texture(check, number, opacity));
}

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
    REQUIRE(has_texture(check, m->texture, false), "texture",
            "must be 0 or the number of a checker, an image or a noise");
    REQUIRE(has_texture(check, m->opacity, true), "opacity", "must be 0 or the number of an opacity texture");
    REQUIRE(!m->bump || has_texture(check, m->bump, false) || has_texture(check, m->bump, true), "bump",
            "must be 0 or the number of a texture");
    return TIA_OK;
}
