/* number_range.c - range checks of numbers, the same for all fields. */
#include "math/integer.h"
#include "scene_check.h"

int tia_check_refuse(const struct check *check, const char *field, const char *rule)
{
    if (check->fault)
        *check->fault = (struct tia_fault){check->thing, check->index, field, rule};
    return TIA_ERR_RANGE;
}

bool tia_check_is_unit(const struct tia_rgb *c)
{
    return c->r >= 0 && c->r <= TIA_Q30_ONE && c->g >= 0 && c->g <= TIA_Q30_ONE && c->b >= 0 && c->b <= TIA_Q30_ONE;
}

bool tia_check_is_between(int32_t x, int32_t least, int32_t most)
{
    return x >= least && x <= most;
}

bool tia_check_is_scale(struct tia_vec3 s)
{
    return tia_check_is_between(s.x, TIA_SCALE_MIN, TIA_SCALE_MAX) &&
           tia_check_is_between(s.y, TIA_SCALE_MIN, TIA_SCALE_MAX) &&
           tia_check_is_between(s.z, TIA_SCALE_MIN, TIA_SCALE_MAX);
}

static uint64_t square(int64_t x)
{
    return (uint64_t)(x * x);
}

/* True if the squared length is in 1/4..9/4, exactly; length2 has 60 fractional bits. */
bool tia_check_is_direction(const struct tia_dir3 *d)
{
    uint64_t length2 = square(d->x) + square(d->y) + square(d->z);
    return length2 >= UINT64_C(1) << 58 && length2 <= UINT64_C(9) << 58;
}

static uint64_t size_of(int64_t x)
{
    return (uint64_t)(x < 0 ? -x : x);
}

/* True if a b = c d. */
static bool are_same(int64_t a, int64_t b, int64_t c, int64_t d)
{
    bool minus = (a < 0) != (b < 0), other = (c < 0) != (d < 0), zero = !a || !b;
    return !tia_cmp_products(size_of(a), size_of(b), size_of(c), size_of(d)) && (zero || minus == other);
}

bool tia_check_is_on_line(const int64_t a[3], const int64_t b[3])
{
    return are_same(a[0], b[1], a[1], b[0]) && are_same(a[1], b[2], a[2], b[1]) && are_same(a[2], b[0], a[0], b[2]);
}

/* True if all points of a box are nearer than `reach` to every position of the eye. The test is exact: d2 < reach^2 for
 * the largest squared distance d2 to a corner. */
static bool is_nearer(const struct check *check, const struct bounds_wide *box, int64_t reach)
{
    const struct tia_vec3 *first = &check->eyes.min, *last = &check->eyes.max;
    const int64_t eye_min[3] = {first->x, first->y, first->z}, eye_max[3] = {last->x, last->y, last->z};
    uint64_t d2 = 0;

    for (int k = 0; k < 3; k++) {
        int64_t over = box->max[k] - eye_min[k], under = eye_max[k] - box->min[k], far = over > under ? over : under;
        if (far >= INT32_MAX)
            return false;
        d2 += square(far);
    }
    return reach > 0 && d2 < square(reach);
}

bool tia_check_is_box_near(const struct check *check, const struct bounds_wide *box)
{
    return is_nearer(check, box, INT64_C(1) << 31);
}

bool tia_check_is_near(const struct check *check, struct tia_vec3 c, tia_q16 radius)
{
    const struct bounds_wide point = {{c.x, c.y, c.z}, {c.x, c.y, c.z}};
    return is_nearer(check, &point, (INT64_C(1) << 31) - radius);
}

/* Squares are computed only if all differences are small, so that they fit. */
bool tia_check_are_apart(struct tia_vec3 a, struct tia_vec3 b)
{
    int64_t d[3] = {(int64_t)a.x - b.x, (int64_t)a.y - b.y, (int64_t)a.z - b.z}, d2 = 0;

    for (int k = 0; k < 3; k++) {
        if (d[k] >= TIA_RADIUS_MIN || d[k] <= -TIA_RADIUS_MIN)
            return true;
        d2 += d[k] * d[k];
    }
    return d2 >= TIA_RADIUS_MIN * TIA_RADIUS_MIN;
}
