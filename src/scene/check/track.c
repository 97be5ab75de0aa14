#include <tia/motion.h>

#include "check.h"

#define VALUE(condition, rule) REQUIRE(condition, "value", rule)

/* Places of the eye need no check here: everything else is checked against check->eyes. */
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
    case TIA_MOVES_EYE:
    case TIA_ROTATES_TRANSFORM:
        break;
    }
    return TIA_OK;
}

/* How many there are of what the track moves. */
static uint32_t targets(const struct tia_scene *scene, enum tia_target target)
{
    bool light = target == TIA_MOVES_LIGHT || target == TIA_ROTATES_LIGHT;
    return light ? scene->light_count : target >= TIA_MOVES_TRANSFORM ? scene->transform_count : UINT32_MAX;
}

int tia_check_track(const struct check *check)
{
    const struct tia_track *track = &check->scene->tracks[check->index];
    int64_t before = -1;
    int status = TIA_OK;

    REQUIRE((unsigned)track->target <= TIA_SCALES_TRANSFORM, "target", "must be something that moves");
    REQUIRE(track->index < targets(check->scene, track->target), "index", "must be the index of a light or transform");
    REQUIRE(track->key_count && track->keys, "keys", "must be one or more");
    for (uint32_t i = 0; !status && i < track->key_count; i++) {
        if (asker_stops(check->asker, 1))
            return TIA_STOPPED;
        REQUIRE(track->keys[i].time > before, "time", "must be 0 or more, and rise");
        before = track->keys[i].time;
        status = check_value(check, track, track->keys[i].value);
    }
    return status;
}
