#include "span_casters.h"

#include "math/integer.h"
#include "math/noinline.h"

/* ---- the test ---- */

/* Derivation. All shadow rays from points P of the ball L, r to the light Q are within the bias of the segments from P
 * to Q, and these fill the hull of the ball and Q: the balls with the centre L + s (Q - L) and the radius (1 - s) r for
 * s in 0..1. A sphere C, R that blocks one of them is within R of a point between the ray's ends, or of the light; see
 * docs/definition.md. So it blocks none if for all s, with D = C - L and G = Q - L,
 *
 *     |D - s G| > R + bias + (1 - s) r.
 *
 * In quarters of the scene's unit, C, L and Q are off by half a unit in each component, and so D and G by sqrt(3), and
 * D - s G by (1 + s) sqrt(3) < 3.47. R and r are off by half a unit each, and the bias is 2. With the sum rounded up,
 * rho = R + r + 7, the condition is |D - s G| > rho - s r, or
 *
 *     K - 2 s B + s^2 A > 0,   K = D.D - rho^2,   B = D.G - rho r,   A = G.G - r^2.
 *
 * It holds for all s if it holds at 0 and at 1, and also at B/A, where the form is least, if A > 0 and that is in
 * between: there it is K - B^2/A, which is positive if K >= A, as then B < A <= K. Otherwise K A and B^2 are compared
 * with factors cut to 30 bits. C, L and Q are within 2^29 of the eye in these units, and r and R are at most 2^29 + 3,
 * so that D and G are below 2^30 + 2, rho is below 2^30 + 16, and no sum reaches 2^63. */
#define SLACK 7

void span_hull_of(const struct coarse_ball *ball, const struct coarse_ball *light, struct span_hull *h)
{
    h->x = ball->x;
    h->y = ball->y;
    h->z = ball->z;
    h->radius = ball->radius;
    h->gx = light->x - ball->x;
    h->gy = light->y - ball->y;
    h->gz = light->z - ball->z;
    h->a = num_mul(h->gx, h->gx) + num_mul(h->gy, h->gy) + num_mul(h->gz, h->gz) - num_mul(h->radius, h->radius);
    h->down = num_larger(span_bits(h->a) - 30, 0);
    h->a_down = (num)num_down(h->a, h->down) - 1;
}

static inline bool is_clear(const struct span_hull *h, const struct coarse_ball *caster)
{
    num x = caster->x - h->x, y = caster->y - h->y, z = caster->z - h->z, rho = h->radius + caster->radius + SLACK;
    num_wide k = num_mul(x, x) + num_mul(y, y) + num_mul(z, z) - num_mul(rho, rho);

    if (k <= 0)
        return false;
    num_wide b = num_mul(x, h->gx) + num_mul(y, h->gy) + num_mul(z, h->gz) - num_mul(rho, h->radius);
    if (k + h->a - 2 * b <= 0)
        return false;
    if (b <= 0 || b >= h->a || k >= h->a)
        return true;
    num k_down = (num)num_down(k, h->down) - 1, b_up = (num)num_down(b, h->down) + 1;
    return num_mul(k_down, h->a_down) > num_mul(b_up, b_up);
}

/* ---- points ---- */

/* |v| is below 2^30. */
bool span_coarse_point(const struct primary_rays *primary, const struct span_sphere *sphere, int x, int y, num_u t,
                       num doubt, struct coarse_ball *ball)
{
    num_wide across = num_pixel_coordinate(2 * x + 1 - primary->width, primary->exponent);
    int shift = 14 - sphere->t_exponent - primary->exponent;

    ball->radius = doubt;
    ball->x = (num)span_shift(num_mul(num_signed(t), (num)across), shift);
    ball->y = (num)span_shift(num_mul(num_signed(t), (num)primary_y(primary, y)), shift);
    ball->z = (num)-span_shift(num_mul(num_signed(t), (num)primary->depth), shift);
    if (ball->radius > 0)
        return true;
    num_wide radius =
        span_shift(num_up((num_wide)num_distance_doubt(t, sphere->doubt_shift, sphere->doubt), 30), shift);
    ball->radius = (num)radius + 2;
    return span_bits(radius) < 29;
}

/* ---- lists ---- */

static uint32_t rows_of(uint32_t lights)
{
    return lights < CASTER_ROWS ? lights : CASTER_ROWS;
}

uint64_t span_casters_size(uint32_t spheres, uint32_t lights)
{
    return ((uint64_t)spheres + lights) * sizeof(struct coarse_ball) +
           (uint64_t)spheres * rows_of(lights) * ((spheres + 7) / 8);
}

void span_casters_place(struct span_casters *casters, const struct span_sphere *spheres, uint32_t count,
                        uint32_t lights, void *memory)
{
    casters->spheres = spheres;
    casters->coarse = memory;
    casters->lists = (uint8_t *)(casters->coarse + count + lights);
    casters->count = count;
    casters->rows = rows_of(lights);
}

void span_casters_put(const struct span_casters *casters, uint32_t n)
{
    const struct span_sphere *s = &casters->spheres[n];

    casters->coarse[n] = (struct coarse_ball){(num)span_shift(s->centre.x, -2), (num)span_shift(s->centre.y, -2),
                                              (num)span_shift(s->centre.z, -2), (num)span_shift(s->radius, -2)};
}

/* Returns the list of a sphere and a light. */
static ONCE_IN_FLASH uint8_t *list_of(const struct span_casters *casters, uint32_t sphere, uint32_t light)
{
    uint32_t row = light < casters->rows ? light : casters->rows - 1;

    return casters->lists + (size_t)((sphere * casters->rows + row) * ((casters->count + 7) / 8));
}

static ONCE_IN_FLASH num_wide sum_of_sizes(const struct num_vec *a)
{
    return num_abs(a->x) + num_abs(a->y) + num_abs(a->z);
}

/* Returns (b - a)/4. */
static ONCE_IN_FLASH struct num_vec quarter_between(const struct num_vec *a, const struct num_vec *b)
{
    struct num_vec d = span_difference(b, a), q = {span_shift(d.x, -2), span_shift(d.y, -2), span_shift(d.z, -2)};
    return q;
}

/* True if the caster is behind every point of the sphere L as seen from the light: with D = C - L, G = Q - L and P = L
 * + r N,
 *
 *     A.w = (D - r N).(G - r N) <= D.G + r |D + G| + r^2 <= 0.
 *
 * With vectors divided by 4 the products fit; the sums of the sizes of their components make up for rounding. */
static bool is_behind(const struct span_sphere *sphere, const struct num_vec *light, const struct span_sphere *caster)
{
    struct num_vec d = quarter_between(&sphere->centre, &caster->centre);
    struct num_vec g = quarter_between(&sphere->centre, light), sum = span_sum(&d, &g);
    num_wide r = span_shift(sphere->radius, -2) + 1;

    return span_dot(&d, &g) + r * (sum_of_sizes(&sum) + r) + sum_of_sizes(&d) + sum_of_sizes(&g) <= 0;
}

/* True if sphere j may block the light of sphere n. A sphere around the eye does so by a rule of its own, also at
 * itself. */
static bool may_block(const struct span_casters *casters, const struct span_hull *hull, uint32_t n, uint32_t light,
                      uint32_t j)
{
    const struct span_sphere *spheres = casters->spheres;

    if (spheres[j].c < 0)
        return true;
    return j != n && !(NUM_CERTIFIED && is_clear(hull, &casters->coarse[j])) &&
           !is_behind(&spheres[n], &spheres[light].centre, &spheres[j]);
}

void span_casters_find(const struct span_casters *casters, uint32_t light, struct cancel *cancel)
{
    uint32_t count = casters->count;

    for (uint32_t n = 0; n < count && !cancelled(cancel, count); n++) {
        uint8_t *list = list_of(casters, n, light);
        struct span_hull hull;
        span_hull_of(&casters->coarse[n], &casters->coarse[count + light], &hull);
        for (uint32_t j = 0; j < count; j++) {
            if (!(j & 7) && light < CASTER_ROWS)
                list[j >> 3] = 0;
            if (may_block(casters, &hull, n, count + light, j))
                list[j >> 3] = (uint8_t)(list[j >> 3] | 1u << (j & 7));
        }
    }
}

bool span_hull_clears(const struct span_hull *hull, const struct coarse_ball *caster)
{
    return is_clear(hull, caster);
}

const uint8_t *span_list_of(const struct span_casters *casters, uint32_t sphere, uint32_t light)
{
    return list_of(casters, sphere, light);
}

uint32_t span_next_in(const struct span_casters *casters, const uint8_t *list, uint32_t from)
{
    uint32_t j = from;

    while (j < casters->count) {
        uint32_t rest = (uint32_t)list[j >> 3] >> (j & 7);
        if (rest)
            return j + tia_ctz32(rest);
        j = (j | 7) + 1;
    }
    return casters->count;
}

/* A sphere around the eye contains all visible points, so that no hull of these is clear of it. */
uint32_t span_next_caster(const void *lit, uint32_t light, uint32_t from)
{
    const struct span_lit *points = lit;
    const struct span_casters *casters = points->casters;
    const uint8_t *list = list_of(casters, points->object, light);
    uint32_t j = span_next_in(casters, list, from);
    struct span_hull hull;

    if (points->surrounded && j < casters->count) {
        span_hull_of(&points->around, &casters->coarse[casters->count + light], &hull);
        while (j < casters->count && is_clear(&hull, &casters->coarse[j]))
            j = span_next_in(casters, list, j + 1);
    }
    return j;
}
