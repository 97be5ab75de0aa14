#include "light.h"

/* The exponent e_p of t^2 v.v = |P|^2, which is at most c on the tangent, or (2r)^2 from inside: it
 * keeps |P|^2 below 2^60, and t v.v = |P| |v|, where |v| < 2^(30 - f), a mantissa below 2^31 with the
 * exponent e_p - e_t. */
static int reach_exponent(const struct lattice *lattice, const struct body *body)
{
    int bits = body->c < 0 ? num_bits(body->radius * body->radius) + 2 : num_bits(body->c);
    int by_mantissa = body->t_exponent + 31 - ((bits - 31) >> 1) - 30 + lattice->exponent;

    return 92 - bits < by_mantissa ? 92 - bits : by_mantissa;
}

/* The exponent e_d of |Q - P|^2 = Q.Q - 2 t Q.v + |P|^2: each term stays below 2^61, t Q.v as a product
 * of t (31 bits) and Q.v (29 bits). It is even, for the root. */
static int distance_exponent(const struct lattice *lattice, const struct body *body, struct num_vec light, int e_p)
{
    int by_product = body->t_exponent + lattice->exponent - 16 + 61 - num_bits(lattice_reach(lattice, light));
    int by_light = 92 - num_bits(num_dot(light, light)), e = by_light < by_product ? by_light : by_product;

    return (e < e_p ? e : e_p) & ~1;
}

/* The exponent e_s of t G.v keeps it below 2^61, a product of t (31 bits) and G.v (30 bits), like the
 * constant beside it. r N.w/|w| is at most r, so r N.w 2^(e_s + half) times
 * 2^(15 - bits - e_s + e_d/2) is at most |w| 2^(e_d/2 + half - 1) < 2^31, with 16 of the radius's
 * bits behind the point. */
void light_line_prepare(const struct lattice *lattice, struct light_source *source, int x, int y,
                        struct light_line *line)
{
    const struct body *body = source->body;
    struct num_vec g = num_vec_sub(source->light, body->centre);
    num_wide facing = body->c - num_dot(body->centre, source->light), square = num_dot(source->light, source->light);
    int to_top = body->t_exponent + lattice->exponent - 16, limit = 93 - num_bits(facing);
    int e_s = to_top + 62 - num_bits(lattice_reach(lattice, g));

    e_s = e_s < limit ? e_s : limit;
    source->reach_exponent = reach_exponent(lattice, body);
    source->exponent = distance_exponent(lattice, body, source->light, source->reach_exponent);
    struct row_form form = lattice_form(lattice, g, x, y, e_s - to_top);
    line->g = form.start;
    line->g_step = form.step;
    form = lattice_form(lattice, source->light, x, y, source->exponent - to_top);
    line->q = form.start;
    line->q_step = form.step;
    line->square = lattice_square(lattice, x, y);
    line->facing = num_shift(facing, e_s - 32);
    line->distance = num_shift(square, source->exponent - 32);
    line->distance_down = num_count(source->reach_exponent - source->exponent);
    line->reach_down =
        num_count(2 * body->t_exponent + 2 * lattice->exponent + lattice->square_shift - 32 - source->reach_exponent);
    line->scale = 15 - body->radius_bits - e_s + (source->exponent >> 1);
}
