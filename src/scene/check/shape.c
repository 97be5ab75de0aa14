#include "scene/object_bounds.h"
#include "scene/shapes/description.h"
#include "scene_check.h"

int tia_check_transform(const struct check *check)
{
    const struct tia_transform *t = &check->scene->transforms[check->index];

    REQUIRE(tia_check_is_near(check, t->position, 0), "position", CHECK_FAR);
    REQUIRE(tia_check_is_scale(t->scale), "scale", "must be in 2^-10..1024");
    return TIA_OK;
}

static int64_t least_scale(const struct tia_transform *t)
{
    tia_q16 least = t->scale.x < t->scale.y ? t->scale.x : t->scale.y;
    return least < t->scale.z ? least : t->scale.z;
}

/* True if a transformed box is not too flat: half its diagonal, with the margin of tia_object_bounds, over the smallest
 * scale is below 32768. If no scale is below 1, a box near the eye always passes. */
static bool is_round_enough(const struct tia_transform *t, const struct bounds_wide *box)
{
    int64_t scale = least_scale(t);
    uint64_t limit = (uint64_t)(scale < TIA_Q16_ONE ? scale : TIA_Q16_ONE) << 15, square = 0;

    for (int k = 0; k < 3; k++) {
        uint64_t half = (uint64_t)(box->max[k] - box->min[k] + 3) / 2; /* at most 2^31 */
        square += half * half;
    }
    return scale >= TIA_Q16_ONE || square < limit * limit;
}

int tia_check_roundness(const struct check *check, const struct tia_shape *s, const struct bounds_wide *box)
{
    REQUIRE(is_round_enough(&check->scene->transforms[s->transform - 1], box), "transform",
            "too flat for its size: the radius around it, over the least scale, must be below 32768");
    return TIA_OK;
}

int tia_check_placed(const struct check *check, const struct tia_shape *s, const struct bounds_wide *box)
{
    REQUIRE(tia_check_is_box_near(check, box), "place", CHECK_FAR);
    return s->transform ? tia_check_roundness(check, s, box) : TIA_OK;
}

int tia_check_shape(const struct check *check)
{
    const struct tia_scene *scene = check->scene;
    const struct tia_shape *s = &scene->shapes[check->index];
    const struct shape_description *description = tia_shape_description(s->kind);
    struct bounds_wide box;

    REQUIRE(s->material < scene->material_count, "material", "must be the index of a material");
    REQUIRE(s->transform <= scene->transform_count, "transform", "must be 0 or the number of a transform");
    REQUIRE(description, "kind", "must be a kind of shape");
    int status = description->check(check, s);
    if (status || !description->add_bounds || s->kind == TIA_MESH || s->kind == TIA_GRID)
        return status; /* the boxes of meshes and grids are checked later, see tia_check_uses */
    if (s->kind == TIA_SPHERE && !s->transform) {
        REQUIRE(tia_check_is_near(check, s->sphere.centre, s->sphere.radius), "centre", CHECK_FAR);
        return TIA_OK;
    }
    (void)tia_bounds_in_world(scene, scene->sphere_count + check->index, NULL, &box);
    return tia_check_placed(check, s, &box);
}
