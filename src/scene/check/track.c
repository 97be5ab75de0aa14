#include <tia/motion.h>

#include "scene/colour.h"
#include "scene_check.h"

#define VALUE(condition, rule) REQUIRE(condition, "value", rule)

/* Checks a keyframe's value. Positions of the eye are not checked here: all other positions are checked against
 * check->eyes. */
static int check_value(const struct check *check, const struct tia_track *track, struct tia_vec3 value)
{
    struct tia_light moved;

    switch (track->target) {
    case TIA_MOVES_LIGHT:
        moved = check->scene->lights[track->index];
        moved.centre = value;
        VALUE(tia_check_is_light_near(check, &moved), CHECK_FAR);
        break;
    case TIA_MOVES_REFERENCE:
    case TIA_MOVES_TRANSFORM:
        VALUE(tia_check_is_near(check, value, 0), CHECK_FAR);
        break;
    case TIA_ROTATES_LIGHT:
        VALUE(value.x | value.y | value.z, "must not be 0");
        break;
    case TIA_SCALES_TRANSFORM:
        VALUE(tia_check_is_scale(value), "must be in 2^-10..1024");
        break;
    case TIA_SHOWS_SHAPE:
    case TIA_SHOWS_LIGHT:
        VALUE((value.x == 0 || value.x == 1) && !value.y && !value.z, "must be 0 or 1");
        break;
    case TIA_SETS_COLOUR:
    case TIA_SETS_TRANSMISSION:
    case TIA_SETS_EMISSION:
    case TIA_SETS_SPECULAR:
    case TIA_SETS_MIRROR:
    case TIA_SETS_REFRACTION:
    case TIA_SETS_FACING:
        VALUE(tia_check_is_unit(&(struct tia_rgb){value.x, value.y, value.z}), CHECK_UNIT);
        break;
    case TIA_MOVES_EYE:
    case TIA_ROTATES_TRANSFORM:
    case TIA_TARGETS:
        break;
    }
    return TIA_OK;
}

/* Checks the rules for the target of a track of visibility or colour. */
static int check_target(const struct check *check, const struct tia_track *track)
{
    bool needs_mesh = track->target == TIA_SHOWS_SHAPE || track->target >= TIA_SETS_SPECULAR;

    REQUIRE(!needs_mesh || tia_check_can_hide(check), "target", "needs a last mesh without faces in the scene");
    if (track->target < TIA_SETS_COLOUR)
        return TIA_OK;
    const struct tia_material *m = &check->scene->materials[track->index];
    REQUIRE(track->target != TIA_SETS_SPECULAR || tia_check_is_between(m->exponent, TIA_Q16_ONE, TIA_EXPONENT_MAX),
            "target", "must be of a material with an exponent in 1..10000");
    REQUIRE(track->target != TIA_SETS_REFRACTION || tia_check_is_between(m->index, TIA_INDEX_MIN, TIA_INDEX_MAX),
            "target", "must be of a material with an index in 0.25..4");
    REQUIRE(track->target != TIA_SETS_EMISSION || (!colour_is_black(&m->emission) && !m->emission_bits), "target",
            "must be of a material that emits, at most 1");
    return TIA_OK;
}

/* Returns the number of objects of the kind that the target belongs to. */
static uint32_t targets(const struct tia_scene *scene, enum tia_target target)
{
    if (target == TIA_MOVES_LIGHT || target == TIA_ROTATES_LIGHT || target == TIA_SHOWS_LIGHT)
        return scene->light_count;
    if (target >= TIA_MOVES_TRANSFORM && target <= TIA_SCALES_TRANSFORM)
        return scene->transform_count;
    if (target >= TIA_SETS_COLOUR)
        return scene->material_count;
    return target == TIA_SHOWS_SHAPE ? scene->shape_count : UINT32_MAX;
}

int tia_check_track(const struct check *check)
{
    const struct tia_track *track = &check->scene->tracks[check->index];
    int64_t before = -1;
    int status = TIA_OK;

    REQUIRE((unsigned)track->target < TIA_TARGETS, "target", "must be a target of animation");
    REQUIRE(track->index < targets(check->scene, track->target), "index",
            "must be the index of a light, transform, shape or material");
    REQUIRE(track->key_count && track->keys, "keys", "must be one or more");
    status = track->target >= TIA_SHOWS_SHAPE ? check_target(check, track) : TIA_OK;
    for (uint32_t i = 0; !status && i < track->key_count; i++) {
        if (cancelled(check->cancel, 1))
            return TIA_STOPPED;
        REQUIRE(track->keys[i].time > before, "time", "must be 0 or more, and rise");
        before = track->keys[i].time;
        status = check_value(check, track, track->keys[i].value);
    }
    return status;
}
