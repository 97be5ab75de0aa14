/* solid.c - checks each solid once: its expression, and its members. */
#include "scene/solid.h"

/* True if the steps leave one operand of all members, and neither too many nor too few at any time. */
static bool is_expression(const struct tia_solid *solid)
{
    uint32_t members = 0, depth = 0;

    for (uint32_t i = 0; i < solid->step_count; i++) {
        bool is_member = solid->steps[i] == TIA_SOLID_MEMBER;
        if (solid->steps[i] > TIA_SOLID_DIFFERENCE || depth < (is_member ? 0 : 2))
            return false;
        members += is_member;
        depth += is_member ? 1 : UINT32_MAX;
        if (depth > TIA_SOLID_DEPTH)
            return false;
    }
    return depth == 1 && members == solid->member_count;
}

static bool is_within(const struct bounds_wide *box)
{
    bool within = true;

    for (int k = 0; k < 3; k++)
        within = within && box->min[k] > INT32_MIN && box->max[k] < INT32_MAX;
    return within;
}

static int check_plane(const struct check *check, const struct tia_shape *s)
{
    REQUIRE(!s->transform, "transform", "must be 0 for a plane");
    REQUIRE(tia_check_is_direction(&s->plane.normal), "normal", CHECK_LENGTH);
    return TIA_OK;
}

static int check_member(const struct check *check, const struct tia_shape *s)
{
    const struct tia_scene *scene = check->scene;
    const struct shape_description *kind = tia_solid_member_kind(s);
    struct bounds_wide box;

    REQUIRE(s->material < scene->material_count, "material", "must be the index of a material");
    REQUIRE(s->transform <= scene->transform_count, "transform", "must be 0 or the number of a transform");
    REQUIRE(kind, "kind", "a member must be a sphere, a box, a torus, a capped cylinder, a capped cone or a plane");
    int status = s->kind == TIA_PLANE ? check_plane(check, s) : kind->check(check, s);
    if (status || !tia_solid_member_box(scene, s, &box))
        return status;
    REQUIRE(is_within(&box), "place", "every point of a member must be within 32768 in the solid's axes");
    return s->transform ? tia_check_roundness(check, s, &box) : TIA_OK;
}

int tia_check_solid(const struct check *check)
{
    const struct tia_solid *solid = &check->scene->solids[check->index];
    int status = TIA_OK;

    REQUIRE(solid->member_count && solid->member_count <= TIA_SOLID_MEMBERS, "members", "must be 1 to 32");
    REQUIRE(solid->members && solid->steps, "arrays", "an array with a count must not be NULL");
    REQUIRE(solid->step_count == 2 * solid->member_count - 1 && is_expression(solid), "steps",
            "must be an expression of all members, with at most 16 operands waiting");
    for (uint32_t i = 0; !status && i < solid->member_count; i++)
        status = check_member(check, &solid->members[i]);
    if (status)
        return status;
    const struct tia_bounds box = tia_solid_box(check->scene, solid);
    REQUIRE(tia_solid_is_bounded(&box), "place", "must be bounded: a box or the like must be intersected");
    return TIA_OK;
}
