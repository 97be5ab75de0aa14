/* look.c - what only cameras have that the span renderer does not draw: a window, a line of sight. */
#include "math/integer.h"
#include "scene_check.h"

/* Returns a b - c d, a component of a product of unit vectors, Q2.30. */
static int32_t across(int32_t a, int32_t b, int32_t c, int32_t d)
{
    return (int32_t)(((int64_t)a * b - (int64_t)c * d) >> 30);
}

/* True if v and n are not parallel: the squared sine of their angle, |v x n|^2 of the unit vectors, is at least
 * 2^-20. */
static bool is_off(struct tia_vec3 v, struct tia_vec3 n)
{
    struct tia_dir3 a = tia_normalise(v.x, v.y, v.z), b = tia_normalise(n.x, n.y, n.z);
    int32_t x = across(a.y, b.z, a.z, b.y), y = across(a.z, b.x, a.x, b.z), z = across(a.x, b.y, a.y, b.x);
    return (int64_t)x * x + (int64_t)y * y + (int64_t)z * z >= INT64_C(1) << 40;
}

static int check_line_of_sight(const struct check *check, const struct tia_camera *c)
{
    const struct tia_vec3 *e = &c->eye, *r = &c->reference;

    if (!(c->up.x | c->up.y | c->up.z))
        return TIA_OK;
    REQUIRE(tia_check_is_near(check, *r, 0), "reference", CHECK_FAR);
    struct tia_vec3 n = {e->x - r->x, e->y - r->y, e->z - r->z};
    REQUIRE(n.x | n.y | n.z, "reference", "must not be the eye");
    REQUIRE(is_off(c->up, n), "up", "must be at least 0.056 degrees off the line of sight");
    return TIA_OK;
}

static uint64_t larger_square(int64_t a, int64_t b)
{
    return (uint64_t)(a * a > b * b ? a * a : b * b);
}

static int check_window(const struct check *check, const struct tia_camera *c)
{
    const struct tia_window *w = &c->window;

    REQUIRE(w->bottom < w->top, "window", "bottom must be below top");
    REQUIRE(w->left < w->right || (!w->left && !w->right), "window", "left must be below right, or both 0");
    if (c->projection == TIA_FRUSTUM)
        REQUIRE(w->near > 0, "window", "near must be above 0");
    else
        REQUIRE(larger_square(w->left, w->right) + larger_square(w->bottom, w->top) < UINT64_C(1) << 62, "window",
                CHECK_FAR);
    return TIA_OK;
}

int tia_check_look(const struct check *check)
{
    const struct tia_camera *c = &check->scene->camera;
    int status = c->projection == TIA_PERSPECTIVE ? TIA_OK : check_window(check, c);

    return status ? status : check_line_of_sight(check, c);
}
