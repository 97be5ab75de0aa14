#include "scene_check.h"

int tia_check_camera(const struct check *check)
{
    const struct tia_camera *c = &check->scene->camera;
    uint32_t n = c->samples;

    if (c->projection == TIA_PERSPECTIVE)
        REQUIRE(tia_check_is_between(c->fov, TIA_FOV_MIN, TIA_FOV_MAX), "fov", "must be in 1..170 degrees");
    else
        REQUIRE(c->projection == TIA_FRUSTUM || c->projection == TIA_ORTHOGRAPHIC, "projection",
                "must be perspective, frustum or orthographic");
    REQUIRE(n == 0 || n == 1 || n == 4 || n == TIA_SAMPLES_MAX, "samples", "must be 1, 4 or 16");
    return check->more ? check->more->camera(check) : TIA_OK;
}
