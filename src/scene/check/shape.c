#include "check.h"

int tia_check_transform(const struct check *check)
{
    const struct tia_transform *t = &check->scene->transforms[check->index];

    REQUIRE(tia_check_is_near(check, t->position, 0), "position", CHECK_FAR);
    REQUIRE(tia_check_is_scale(t->scale), "scale", "must be in 2^-10..1024");
    return TIA_OK;
}

/* At least 2^-10 apart, which only what is near in each coordinate may not be. */
static bool are_apart(struct tia_vec3 a, struct tia_vec3 b)
{
    int64_t d[3] = {(int64_t)a.x - b.x, (int64_t)a.y - b.y, (int64_t)a.z - b.z}, d2 = 0;

    for (int k = 0; k < 3; k++) {
        if (d[k] >= TIA_RADIUS_MIN || d[k] <= -TIA_RADIUS_MIN)
            return true;
        d2 += d[k] * d[k];
    }
    return d2 >= TIA_RADIUS_MIN * TIA_RADIUS_MIN;
}

static int check_cone(const struct check *check, const struct tia_cone *c)
{
    REQUIRE(c->base_radius == 0 || c->base_radius >= TIA_RADIUS_MIN, "base_radius", "must be 0 or at least 2^-10");
    REQUIRE(c->top_radius == 0 || c->top_radius >= TIA_RADIUS_MIN, "top_radius", "must be 0 or at least 2^-10");
    REQUIRE(c->base_radius != c->top_radius, "top_radius", "must not be the base's");
    REQUIRE(are_apart(c->base, c->top), "top", "must be at least 2^-10 from the base");
    return TIA_OK;
}

static bool is_on_line(const struct tia_vec3 p[3])
{
    const int64_t a[3] = {(int64_t)p[1].x - p[0].x, (int64_t)p[1].y - p[0].y, (int64_t)p[1].z - p[0].z};
    const int64_t b[3] = {(int64_t)p[2].x - p[0].x, (int64_t)p[2].y - p[0].y, (int64_t)p[2].z - p[0].z};
    return tia_check_is_on_line(a, b);
}

/* What is a rule of one kind alone. */
static int check_kind(const struct check *check, const struct tia_shape *s)
{
    const struct tia_box *b = &s->box;

    switch (s->kind) {
    case TIA_SPHERE:
        REQUIRE(s->sphere.radius >= TIA_RADIUS_MIN, "radius", CHECK_RADIUS);
        return TIA_OK;
    case TIA_PLANE:
        REQUIRE(!s->transform, "transform", "must be 0 for a plane");
        REQUIRE(tia_check_is_direction(&s->plane.normal), "normal", CHECK_LENGTH);
        REQUIRE(tia_check_is_near(check, s->plane.point, 0), "point", CHECK_FAR);
        return TIA_OK;
    case TIA_DISC:
        REQUIRE(tia_check_is_direction(&s->disc.normal), "normal", CHECK_LENGTH);
        REQUIRE(s->disc.radius >= TIA_RADIUS_MIN, "radius", CHECK_RADIUS);
        return TIA_OK;
    case TIA_CYLINDER:
        REQUIRE(s->cylinder.radius >= TIA_RADIUS_MIN, "radius", CHECK_RADIUS);
        REQUIRE(are_apart(s->cylinder.base, s->cylinder.top), "top", "must be at least 2^-10 from the base");
        return TIA_OK;
    case TIA_CONE:
        return check_cone(check, &s->cone);
    case TIA_BOX:
        REQUIRE(b->min.x < b->max.x && b->min.y < b->max.y && b->min.z < b->max.z, "max", "must be above min");
        return TIA_OK;
    case TIA_TRIANGLE:
        REQUIRE(!is_on_line(s->triangle.corner), "corners", "must not be on one line");
        return TIA_OK;
    case TIA_MESH:
        REQUIRE(s->mesh < check->scene->mesh_count, "mesh", "must be the index of a mesh");
        return TIA_OK;
    case TIA_GRID:
        REQUIRE(s->grid < check->scene->grid_count, "grid", "must be the index of a grid");
        return TIA_OK;
    }
    return tia_check_refuse(check, "kind", "must be a kind of shape");
}

static int64_t least_scale(const struct tia_transform *t)
{
    tia_q16 least = t->scale.x < t->scale.y ? t->scale.x : t->scale.y;
    return least < t->scale.z ? least : t->scale.z;
}

/* Half the box's diagonal, with the margin of tia_object_bounds, over the least scale: below 32768. Scales of 1 and
 * more cannot fail in a box that is near. */
static bool is_round_enough(const struct tia_transform *t, const struct bounds_wide *box)
{
    int64_t scale = least_scale(t), limit = (scale < TIA_Q16_ONE ? scale : TIA_Q16_ONE) << 15, square = 0;

    for (int k = 0; k < 3; k++) {
        int64_t half = (box->max[k] - box->min[k] + 3) / 2;
        square += half * half;
    }
    return scale >= TIA_Q16_ONE || square < limit * limit;
}

int tia_check_placed(const struct check *check, const struct tia_shape *s, const struct bounds_wide *box)
{
    REQUIRE(tia_check_is_box_near(check, box), "place", CHECK_FAR);
    if (s->transform)
        REQUIRE(is_round_enough(&check->scene->transforms[s->transform - 1], box), "transform",
                "too flat for its size: the radius around it, over the least scale, must be below 32768");
    return TIA_OK;
}

int tia_check_shape(const struct check *check)
{
    const struct tia_scene *scene = check->scene;
    const struct tia_shape *s = &scene->shapes[check->index];
    struct bounds_wide box;
    int status;

    REQUIRE(s->material < scene->material_count, "material", "must be the index of a material");
    REQUIRE(s->transform <= scene->transform_count, "transform", "must be 0 or the number of a transform");
    status = check_kind(check, s);
    if (status || s->kind == TIA_PLANE || s->kind == TIA_MESH || s->kind == TIA_GRID)
        return status;
    if (s->kind == TIA_SPHERE && !s->transform) {
        REQUIRE(tia_check_is_near(check, s->sphere.centre, s->sphere.radius), "centre", CHECK_FAR);
        return TIA_OK;
    }
    (void)tia_bounds_in_world(scene, scene->sphere_count + check->index, NULL, &box);
    return tia_check_placed(check, s, &box);
}
