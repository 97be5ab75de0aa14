#include "scene_check.h"

int tia_check_sphere(const struct check *check)
{
    const struct tia_sphere *s = &check->scene->spheres[check->index];

    REQUIRE(s->radius >= TIA_RADIUS_MIN, "radius", CHECK_RADIUS);
    REQUIRE(tia_check_is_near(check, s->centre, s->radius), "centre", CHECK_FAR);
    REQUIRE(s->material < check->scene->material_count, "material", "must be the index of a material");
    return TIA_OK;
}
