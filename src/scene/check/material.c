#include "scene_check.h"

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
    if (check->more)
        return check->more->textures_of(check, m);
    REQUIRE(!m->texture, "texture", "must be 0");
    REQUIRE(!m->opacity, "opacity", "must be 0");
    REQUIRE(!m->bump, "bump", "must be 0");
    return TIA_OK;
}
