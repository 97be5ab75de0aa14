#include "shadow.h"

/* When the light is inside the caster, |w|^2, B.w and |B|^2 - R^2 are compared directly: all are
 * brought to the smallest of their exponents, and one less for the factor 2. */
static void prepare_enclosed(struct shadow_line *line, num_wide k, int e_d, int e_w)
{
    int e = e_d < e_w ? e_d : e_w;

    e = (e < 30 ? e : 30) - 1;
    line->square_scale = e - e_d;
    line->product_scale = e - e_w;
    line->outside = num_shift(k, e - 30);
}

/* The exponents of the comparison (B'.w)^2 >= |w|^2 k'. B.w <= |B| |w|, and |w| 2^(e_d/2 + half) is
 * below 2^32, so B.w 2^(e_w + half + a - 32) is below 2^30 for a = 30 - log2 |B| - e_w + e_d/2. Both
 * sides then agree when k has the exponent e_k = 2 e_w + 2 a - e_d - 32. False when k is so large
 * that no product reaches it: k >= 2^31, |w|^2 >= 2^30 and (B'.w)^2 < 2^61. */
static bool prepare_comparison(struct shadow_line *line, const struct body *body, num_wide k, int b_bits, int e_d,
                               int e_w)
{
    int a = 30 - b_bits - e_w + (e_d >> 1), e_k = 2 * e_w + 2 * a - e_d - 32;

    if (num_bits(k) + e_k - 30 > 31)
        return false;
    line->k = num_scale(k, e_k - 30);
    line->b_scale = a - 32;
    line->reach_shift = e_d - e_w - a + 32;

    /* bias/r is 2^(-28 - bits) inverse. facing has the exponent 15 - bits + e_d/2 + half, and
     * num_mul_top takes 2^-32; t B.v - B.L goes through num_top as well. */
    line->b_bias = num_bias(body->inverse, e_w + a - 43 - (e_d >> 1));
    line->k_bias = num_double_bias(body->inverse);
    line->k_bias_shift = body->radius_bits - 5 + e_w - e_k;
    line->k_bias_shift = line->k_bias_shift < 0 ? 0 : line->k_bias_shift > 63 ? 63 : line->k_bias_shift;
    return true;
}

bool shadow_line_prepare(const struct tia_view *view, const struct shadow_source *source, const struct body *caster,
                         int x, int y, struct shadow_line *line)
{
    const struct body *body = source->body;
    struct num_vec b = num_vec_sub(caster->centre, source->light);
    num_wide square = num_square30(b);
    num_wide k = square - num_shift(caster->radius * caster->radius, -2) + NUM_BIAS_SQUARED;
    num_wide to_light = num_dot(b, source->light), to_centre = num_dot(b, body->centre);
    int bits = num_bits(num_max(num_abs(to_light), num_abs(to_centre)));
    int e_w = body->t_exponent + view->exponent - 16 + 62 - num_bits(view_reach(view, b));

    e_w = e_w < 93 - bits ? e_w : 93 - bits;
    struct row_form form = view_row_form(view, b, y, e_w - body->t_exponent - view->exponent + 16);
    line->b = form.start + (num_wide)x * form.step;
    line->b_step = form.step;
    line->to_light = num_shift(to_light, e_w - 32);
    line->to_centre = num_shift(to_centre, e_w - 32);
    line->enclosed = k <= 0;
    if (line->enclosed)
        prepare_enclosed(line, k, source->exponent, e_w);
    return line->enclosed || prepare_comparison(line, body, k, (num_bits(square) - 29) >> 1, source->exponent, e_w);
}
