#include "span_light.h"

/* Returns the exponent e_p of |P|^2 = t^2 v.v, which is at most c (at the tangent), or (2r)^2 from inside. e_p keeps
 * |P|^2 below 2^60. It also keeps t v.v = |P| |v|, a mantissa with the exponent e_p - e_t, below 2^31, as |v| < 2^(30 -
 * f). */
static int reach_exponent(const struct primary_rays *primary, const struct span_sphere *sphere)
{
    int bits = sphere->c < 0 ? span_bits(num_square(sphere->radius)) + 2 : span_bits(sphere->c);
    int by_mantissa = sphere->t_exponent + 31 - ((bits - 31) >> 1) - 30 + primary->exponent;

    return 92 - bits < by_mantissa ? 92 - bits : by_mantissa;
}

/* Returns the exponent e_d of |Q - P|^2 = Q.Q - 2 t Q.v + |P|^2: each term stays below 2^61, t Q.v as a product of t
 * (31 bits) and Q.v (29 bits). e_d is even, for the square root. */
static int distance_exponent(const struct primary_rays *primary, const struct span_sphere *sphere,
                             const struct num_vec *light, num_wide square, int e_p)
{
    int by_product = sphere->t_exponent + primary->exponent - 16 + 61 - span_bits(primary_reach(primary, light));
    int by_light = 92 - span_bits(square), e = by_light < by_product ? by_light : by_product;

    return (e < e_p ? e : e_p) & ~1;
}

/* Prepares the line. The exponent e_s of r N.w keeps its two terms below 2^61: t G.v, a product of t (31 bits) and G.v
 * (30 bits), and the constant. line->scale is 15 - bits - e_s + e_d/2, where bits is the number of bits of the radius,
 * 16 of them fractional. So r < 2^(bits - 16), and r N.w <= r |w|: the mantissa r N.w 2^(e_s + scale + half) is at most
 * |w| 2^(e_d/2 + half - 1), below 2^31. */
void light_line_prepare(const struct primary_rays *primary, struct light_source *source, int x, int y,
                        struct light_line *line)
{
    const struct span_sphere *sphere = source->sphere;
    bool inside = sphere->c < 0;
    struct num_vec g =
        inside ? span_difference(&sphere->centre, &source->light) : span_difference(&source->light, &sphere->centre);
    num_wide facing = sphere->c - span_dot(&sphere->centre, &source->light),
             square = span_dot(&source->light, &source->light);
    int to_top = sphere->t_exponent + primary->exponent - 16, limit = 93 - span_bits(facing);
    int e_s = to_top + 62 - span_bits(primary_reach(primary, &g));

    facing = inside ? -facing : facing;
    e_s = e_s < limit ? e_s : limit;
    source->reach_exponent = reach_exponent(primary, sphere);
    source->exponent = distance_exponent(primary, sphere, &source->light, square, source->reach_exponent);
    struct row_form form = primary_form(primary, &g, x, y, e_s - to_top);
    line->g = form.start;
    line->g_step = form.step;
    form = primary_form(primary, &source->light, x, y, source->exponent - to_top);
    line->q = form.start;
    line->q_step = form.step;
    line->square = primary_square(primary, x, y);
    line->facing = span_shift(facing, e_s - 32);
    line->distance = span_shift(square, source->exponent - 32);
    line->distance_down = num_count(source->reach_exponent - source->exponent);
    line->reach_down =
        num_count(2 * sphere->t_exponent + 2 * primary->exponent + primary->square_shift - 32 - source->reach_exponent);
    line->facing_doubt = 0;
    line->scale = 15 - sphere->radius_bits - e_s + (source->exponent >> 1);
}
