#include "scene_check.h"

/* Returns a x + b y. */
static int64_t sum(int a, int32_t x, int b, int32_t y)
{
    return (int64_t)a * x + (int64_t)b * y;
}

bool tia_check_is_light_near(const struct check *check, const struct tia_light *l)
{
    const struct tia_vec3 *c = &l->centre, *s = &l->side[0], *t = &l->side[1];

    if (tia_light_has(l->kind, TIA_LIGHT_PLACELESS))
        return true;
    if (!tia_light_has(l->kind, TIA_LIGHT_SIDES))
        return tia_check_is_near(check, *c, tia_light_has(l->kind, TIA_LIGHT_RADIUS) ? l->radius : 0);
    for (int i = 0; i < 4; i++) {
        int a = i & 1 ? 1 : -1, b = i & 2 ? 1 : -1;
        const int64_t p[3] = {c->x + sum(a, s->x, b, t->x), c->y + sum(a, s->y, b, t->y), c->z + sum(a, s->z, b, t->z)};
        if (!tia_check_is_box_near(check, &(struct bounds_wide){{p[0], p[1], p[2]}, {p[0], p[1], p[2]}}))
            return false;
    }
    return true;
}

/* True if both sides are 0, or if they are not parallel. */
static bool are_sides(const struct tia_vec3 side[2])
{
    const int64_t s[3] = {side[0].x, side[0].y, side[0].z}, t[3] = {side[1].x, side[1].y, side[1].z};
    bool both = !(s[0] | s[1] | s[2] | t[0] | t[1] | t[2]);
    return both || !tia_check_is_on_line(s, t);
}

static int check_shape_of(const struct check *check, const struct tia_light *l)
{
    if (tia_light_has(l->kind, TIA_LIGHT_DIRECTION))
        REQUIRE(tia_check_is_direction(&l->direction), "direction", CHECK_LENGTH);
    if (tia_light_has(l->kind, TIA_LIGHT_CONE)) {
        REQUIRE(tia_check_is_between(l->outer, TIA_Q16_ONE, 90 * TIA_Q16_ONE), "outer", "must be in 1..90 degrees");
        REQUIRE(tia_check_is_between(l->inner, 0, l->outer), "inner", "must be in 0..outer degrees");
    }
    if (tia_light_has(l->kind, TIA_LIGHT_SIDES))
        REQUIRE(are_sides(l->side), "side", "the sides must not be on one line, unless both are 0");
    if (tia_light_has(l->kind, TIA_LIGHT_SAMPLED))
        REQUIRE(l->samples <= TIA_LIGHT_SAMPLES_MAX, "samples", "must be in 1..256");
    return TIA_OK;
}

static bool is_attenuation(tia_q16 x)
{
    return tia_check_is_between(x, 0, 32767 * TIA_Q16_ONE);
}

int tia_check_light(const struct check *check, const struct tia_light *l)
{
    REQUIRE((unsigned)l->kind < TIA_LIGHT_KINDS, "kind", "must be a kind of light");
    if (tia_light_has(l->kind, TIA_LIGHT_RADIUS))
        REQUIRE(l->radius == 0 || l->radius >= TIA_RADIUS_MIN, "radius", "must be 0 or at least 2^-10");
    REQUIRE(tia_check_is_light_near(check, l), "centre", CHECK_FAR);
    REQUIRE(l->emission.r >= 0 && l->emission.g >= 0 && l->emission.b >= 0, "emission", "each channel must be in 0..2");
    if (!tia_light_has(l->kind, TIA_LIGHT_PLACELESS))
        REQUIRE(is_attenuation(l->constant) && is_attenuation(l->linear) && is_attenuation(l->quadratic), "attenuation",
                "each term must be in 0..32767");
    return check_shape_of(check, l);
}
