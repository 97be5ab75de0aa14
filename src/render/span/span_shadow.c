#include "span_shadow.h"

/* Returns `e`, lowered if needed to keep a number below 2^60; the number has `bits` bits with the exponent 32. */
static int limit(int e, int bits)
{
    return e < 92 - bits ? e : 92 - bits;
}

/* Returns `e`, lowered if needed to keep t a.v, a product of t (31 bits) and a.v, below 2^60. */
static int limit_product(int e, const struct primary_rays *primary, const struct span_sphere *sphere, struct num_vec a)
{
    int most = sphere->t_exponent + primary->exponent - 16 + 61 - num_bits(primary_reach(primary, a));
    return e < most ? e : most;
}

/* Returns a.v from pixel (x, y) on, such that its product with t has the exponent e. */
static struct row_form product_form(const struct primary_rays *primary, const struct span_sphere *sphere,
                                    struct num_vec a, int x, int y, int e)
{
    return primary_form(primary, a, x, y, e - sphere->t_exponent - primary->exponent + 16);
}

/* Prepares A.w = C.Q - t (C + Q).v + |P|^2; each term stays below 2^60. Returns e_a, at most 57. So bias N.w, which is
 * below 8, stays below 2^60, too. The shift of num_bias_product is positive, as |w| 2^(e_d/2 + half) is at least 2^31
 * and |w| below 2^16. */
static int prepare_product(const struct primary_rays *primary, const struct light_source *source,
                           const struct span_sphere *caster, int x, int y, struct shadow_line *line)
{
    struct num_vec sum = num_vec_add(caster->centre, source->light);
    num_wide toward = span_dot(&caster->centre, &source->light);
    int e = limit_product(limit(source->reach_exponent, num_bits(toward)), primary, source->sphere, sum);

    e = e < 57 ? e : 57;
    struct row_form form = product_form(primary, source->sphere, sum, x, y, e);

    line->a = form.start;
    line->a_step = form.step;
    line->toward = span_shift(toward, e - 32);
    line->a_down = num_count(source->reach_exponent - e);
    return e;
}

/* Prepares (|A'|^2 - R^2) / (1 + bias/r) = |A|^2 - R^2 - (|L - C|^2 - r^2 - R^2 - bias r) bias/(r + bias); each term
 * stays below 2^60, twice t C.v below 2^61. From inside the bias is negative. Returns e_k. */
static int prepare_power(const struct primary_rays *primary, const struct light_source *source,
                         const struct span_sphere *caster, int x, int y, struct shadow_line *line)
{
    const struct span_sphere *sphere = source->sphere;
    num_wide r = sphere->radius, biased = sphere->c < 0 ? r - NUM_BIAS : r + NUM_BIAS;
    struct num_vec between = num_vec_sub(sphere->centre, caster->centre);
    num_wide apart = span_square30(&between) - span_shift(r * biased + caster->radius * caster->radius, -2);
    int e = limit(limit(source->reach_exponent, num_bits(caster->c)), num_bits(apart) + 2);

    e = limit_product(e, primary, sphere, caster->centre);
    struct row_form form = product_form(primary, sphere, caster->centre, x, y, e);
    line->c = form.start;
    line->c_step = form.step;
    num_wide bias = num_bias_of(apart, num_inverse(biased), num_bits(biased), e);
    line->power = span_shift(caster->c, e - 32) + (sphere->c < 0 ? bias : -bias);
    line->power_down = num_count(source->reach_exponent - e);
    return e;
}

static num_wide sum_of_sizes(struct num_vec a)
{
    return num_abs(a.x) + num_abs(a.y) + num_abs(a.z);
}

static struct num_vec quarter(struct num_vec a)
{
    struct num_vec q = {span_shift(a.x, -2), span_shift(a.y, -2), span_shift(a.z, -2)};
    return q;
}

/* True if the caster is behind every point of the sphere L as seen from the light: with D = C - L, G = Q - L and P = L
 * + r N,
 *
 *     A.w = (D - r N).(G - r N) <= D.G + r |D + G| + r^2 <= 0.
 *
 * With vectors divided by 4 the products fit; the sums of the sizes of their components make up for rounding. */
static bool is_behind(const struct light_source *source, const struct span_sphere *caster)
{
    struct num_vec d = quarter(num_vec_sub(caster->centre, source->sphere->centre));
    struct num_vec g = quarter(num_vec_sub(source->light, source->sphere->centre));
    num_wide r = span_shift(source->sphere->radius, -2) + 1;

    return span_dot(&d, &g) + r * (sum_of_sizes(num_vec_add(d, g)) + r) + sum_of_sizes(d) + sum_of_sizes(g) <= 0;
}

bool shadow_line_prepare(const struct primary_rays *primary, const struct light_source *source,
                         const struct span_sphere *caster, int x, int y, struct shadow_line *line)
{
    if (is_behind(source, caster))
        return false;
    const struct span_sphere *sphere = source->sphere;
    struct num_vec from_light = num_vec_sub(caster->centre, source->light);
    int e_a = prepare_product(primary, source, caster, x, y, line);
    int e_k = prepare_power(primary, source, caster, x, y, line);

    /* facing has the exponent 15 - bits + e_d/2 + half, see span_light.c, and bias/r is 2^(-28 - bits) inverse */
    line->inverse = sphere->inverse;
    line->bias_shift = 43 + (source->exponent >> 1) - e_a;
    line->square_down = e_a < source->exponent ? num_count(source->exponent - e_a) : 0;
    line->product_down = e_a < source->exponent ? 0 : num_count(e_a - source->exponent);
    line->swell = num_swell(sphere->inverse, sphere->radius_bits, sphere->c < 0);
    line->exponent = 2 * e_a - source->exponent - e_k;
    line->enclosed = num_is_within(from_light.x, from_light.y, from_light.z, caster->radius);
    line->a_doubt = line->k_doubt = line->beyond_doubt = 0;
    line->a_clear = line->k_clear = 0;
    line->margin = 0;
    return true;
}
