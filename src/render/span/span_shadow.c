#include "span_shadow.h"

#include "math/noinline.h"

/* Returns `e`, lowered if needed to keep a number below 2^60; the number has `bits` bits with the exponent 32. */
static int limit(int e, int bits)
{
    return e < 92 - bits ? e : 92 - bits;
}

/* Sets `form` to a.v from pixel (x, y) on, such that its product with t, of 31 bits, has the exponent e, lowered if
 * needed to keep the product below 2^60. Returns that exponent. */
static NOINLINE int prepare_form(const struct primary_rays *primary, const struct span_sphere *sphere,
                                 const struct num_vec *a, int x, int y, int e, struct row_form *form)
{
    int to_top = sphere->t_exponent + primary->exponent - 16, most = to_top + 61 - span_bits(primary_reach(primary, a));

    e = e < most ? e : most;
    *form = primary_form(primary, a, x, y, e - to_top);
    return e;
}

/* Prepares A.w = C.Q - t (C + Q).v + |P|^2; each term stays below 2^60. Returns e_a, at most 57. So bias N.w, which is
 * below 8, stays below 2^60, too. The shift of num_bias_product is positive, as |w| 2^(e_d/2 + half) is at least 2^31
 * and |w| below 2^16. */
static int prepare_product(const struct primary_rays *primary, const struct light_source *source,
                           const struct span_sphere *caster, int x, int y, struct shadow_line *line)
{
    struct num_vec sum = span_sum(&caster->centre, &source->light);
    num_wide toward = span_dot(&caster->centre, &source->light);
    struct row_form form;
    int e = limit(source->reach_exponent, span_bits(toward));

    e = prepare_form(primary, source->sphere, &sum, x, y, e < 57 ? e : 57, &form);

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
    struct num_vec between = span_difference(&sphere->centre, &caster->centre);
    num_wide apart = span_square30(&between) - span_shift(r * biased + num_square(caster->radius), -2);
    int e = limit(limit(source->reach_exponent, span_bits(caster->c)), span_bits(apart) + 2);

    struct row_form form;

    e = prepare_form(primary, sphere, &caster->centre, x, y, e, &form);
    line->c = form.start;
    line->c_step = form.step;
    num_wide bias = span_bias_of(apart, num_inverse(biased), span_bits(biased), e);
    line->power = span_shift(caster->c, e - 32) + (sphere->c < 0 ? bias : -bias);
    line->power_down = num_count(source->reach_exponent - e);
    return e;
}

void shadow_line_prepare(const struct primary_rays *primary, const struct light_source *source,
                         const struct span_sphere *caster, int x, int y, struct shadow_line *line)
{
    const struct span_sphere *sphere = source->sphere;
    struct num_vec from_light = span_difference(&caster->centre, &source->light);
    int e_a = prepare_product(primary, source, caster, x, y, line);
    int e_k = prepare_power(primary, source, caster, x, y, line);

    /* facing has the exponent 15 - bits + e_d/2 + half, see span_light.c, and bias/r is 2^(-28 - bits) inverse */
    line->inverse = sphere->inverse;
    line->bias_shift = 43 + (source->exponent >> 1) - e_a;
    line->square_down = e_a < source->exponent ? num_count(source->exponent - e_a) : 0;
    line->product_down = e_a < source->exponent ? 0 : num_count(e_a - source->exponent);
    line->swell = span_swell(sphere->inverse, sphere->radius_bits, sphere->c < 0);
    line->exponent = 2 * e_a - source->exponent - e_k;
    line->enclosed = span_is_within(&from_light, caster->radius);
    line->a_doubt = line->k_doubt = line->beyond_doubt = 0;
    line->a_clear = line->k_clear = 0;
    line->margin = line->first = 0;
}
