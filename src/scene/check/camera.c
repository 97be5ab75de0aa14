#include "math/integer.h"
#include "scene_check.h"

/* True if v and n are not parallel: the squared sine of their angle, |v x n|^2 of the unit vectors, is at least
 * 2^-20. */
static bool is_off(struct tia_vec3 v, struct tia_vec3 n)
{
    struct tia_dir3 a = tia_normalise(v.x, v.y, v.z), b = tia_normalise(n.x, n.y, n.z);
    int64_t x = ((int64_t)a.y * b.z - (int64_t)a.z * b.y) >> 30, y = ((int64_t)a.z * b.x - (int64_t)a.x * b.z) >> 30,
            z = ((int64_t)a.x * b.y - (int64_t)a.y * b.x) >> 30;
    return x * x + y * y + z * z >= INT64_C(1) << 40;
}

static int check_look(const struct check *check, const struct tia_camera *c)
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

int tia_check_camera(const struct check *check)
{
    const struct tia_camera *c = &check->scene->camera;
    uint32_t n = c->samples;
    int status;

    if (c->projection == TIA_PERSPECTIVE)
        REQUIRE(tia_check_is_between(c->fov, TIA_FOV_MIN, TIA_FOV_MAX), "fov", "must be in 1..170 degrees");
    else
        REQUIRE(c->projection == TIA_FRUSTUM || c->projection == TIA_ORTHOGRAPHIC, "projection",
                "must be perspective, frustum or orthographic");
    REQUIRE(n == 0 || n == 1 || n == 4 || n == TIA_SAMPLES_MAX, "samples", "must be 1, 4 or 16");
    status = c->projection == TIA_PERSPECTIVE ? TIA_OK : check_window(check, c);
    return status ? status : check_look(check, c);
}
