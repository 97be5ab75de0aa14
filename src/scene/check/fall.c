/* fall.c - checks of falling balls. */
#include <tia/motion.h>

#include "scene_check.h"

#define SPEED_MOST (INT32_C(1024) * TIA_Q16_ONE)
#define MASS_MIN (TIA_Q16_ONE >> 10)
#define MASS_MAX (INT32_C(1024) * TIA_Q16_ONE)

static bool is_slow(struct tia_vec3 v)
{
    return tia_check_is_between(v.x, -SPEED_MOST, SPEED_MOST) && tia_check_is_between(v.y, -SPEED_MOST, SPEED_MOST) &&
           tia_check_is_between(v.z, -SPEED_MOST, SPEED_MOST);
}

bool tia_check_can_hide(const struct check *check)
{
    const struct tia_scene *scene = check->scene;
    return scene->mesh_count > 0 && scene->meshes[scene->mesh_count - 1].face_count == 0;
}

int tia_check_falling(const struct check *check)
{
    const struct tia_falling *f = check->scene->falling;

    if (!f)
        return TIA_OK;
    REQUIRE(f->balls && f->count >= 1 && f->count <= TIA_FALLS_MAX, "fall", "must be 1 to 256 balls");
    REQUIRE(is_slow(f->gravity), "gravity", "each component must be within 1024");
    REQUIRE(tia_check_is_between(f->end, 0, TIA_FALL_END_MAX), "gravity", "must end within 1024 seconds");
    return TIA_OK;
}

/* True if no other shape has the shape's transform, and no track moves it. */
static bool is_own(const struct check *check, uint32_t shape)
{
    const struct tia_scene *scene = check->scene;
    uint32_t transform = scene->shapes[shape].transform;

    for (uint32_t i = 0; i < scene->track_count && !cancelled(check->cancel, 1); i++)
        if (scene->tracks[i].target >= TIA_MOVES_TRANSFORM && scene->tracks[i].target <= TIA_SCALES_TRANSFORM &&
            scene->tracks[i].index == transform - 1)
            return false;
    for (uint32_t i = 0; i < scene->shape_count && !cancelled(check->cancel, 1); i++)
        if (i != shape && scene->shapes[i].transform == transform)
            return false;
    return true;
}

int tia_check_fall(const struct check *check)
{
    const struct tia_scene *scene = check->scene;
    const struct tia_fall *fall = &scene->falling->balls[check->index];

    REQUIRE(fall->shape < scene->shape_count && scene->shapes[fall->shape].kind == TIA_SPHERE, "shape",
            "must be a sphere");
    uint32_t transform = scene->shapes[fall->shape].transform;
    REQUIRE(transform && is_own(check, fall->shape), "shape", "must have a transform of its own that no track moves");
    struct tia_vec3 scale = scene->transforms[transform - 1].scale;
    REQUIRE(scale.x == scale.y && scale.y == scale.z, "shape", "must be scaled evenly");
    for (uint32_t i = 0; i < check->index; i++)
        REQUIRE(scene->falling->balls[i].shape != fall->shape, "shape", "must fall only once");
    REQUIRE(is_slow(fall->velocity), "velocity", "each component must be within 1024");
    REQUIRE(tia_check_is_between(fall->restitution, 0, TIA_Q16_ONE), "restitution", "must be in 0..1");
    REQUIRE(tia_check_is_between(fall->mass, MASS_MIN, MASS_MAX), "mass", "must be in 2^-10..1024");
    REQUIRE(tia_check_can_hide(check), "shape", "needs a last mesh without faces in the scene");
    return check->cancel->stopped ? TIA_STOPPED : TIA_OK;
}
