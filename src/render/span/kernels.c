#include "kernels.h"

static void sphere(const struct sphere_line *line, num_u *t)
{
    num_wide b = line->b;
    struct row_square v = line->square;

    for (int i = 0; i < line->count; i++) {
        num_u top = num_top_u(b);
        num_u root = num_sqrt(num_excess(num_mul_u(top, top), num_mul_u(line->c_disc, num_top_u(v.start))));
        num_u sum = top + root;
        t[i] = num_quotient(line->c_top, sum > 0 ? sum : NUM_LEAST, line->t_shift);
        b += line->b_step;
        v.start += v.step;
        v.step += v.twice;
    }
}

static void sphere_inside(const struct sphere_line *line, num_u *t)
{
    num_wide b = line->b;
    struct row_square v = line->square;

    for (int i = 0; i < line->count; i++) {
        num_u top = num_top_u(b), square = num_top_u(v.start);
        num_u root = num_sqrt(num_mul_u(top, top) + num_mul_u(line->c_disc, square));
        t[i] = num_quotient(top + root, square > 0 ? square : NUM_LEAST, line->t_shift);
        b += line->b_step;
        v.start += v.step;
        v.step += v.twice;
    }
}

static void light_pixel(const struct light_line *line, num_wide facing, num_wide square, struct lit *lit, int i)
{
    num_wide positive = square > 0 ? square : NUM_LEAST;
    struct num_normal n = num_normal(positive);

    lit->facing[i] = num_scale_within(facing, line->scale + n.half);
    lit->square[i] = positive;
    lit->near[i] = num_normal_top(n);
    lit->inverse[i] = n.inverse;
    lit->half[i] = (uint8_t)n.half;
}

static bool light(const struct light_line *line, const num_u *distance, struct lit *lit)
{
    num_wide g = line->g, q = line->q;
    struct row_square v = line->square;
    bool any = false;

    for (int i = 0; i < line->count; i++) {
        num t = num_signed(distance[i]);
        num_wide facing = line->facing + num_mul(t, num_top(g));

        lit->facing[i] = 0;
        if (facing > 0) {
            lit->reach[i] = light_reach(line, t, v.start);
            light_pixel(line, facing, light_square(line, t, q, lit->reach[i]), lit, i);
            any = true;
        }
        g += line->g_step;
        q += line->q_step;
        v.start += v.step;
        v.step += v.twice;
    }
    return any;
}

static void lambert(const struct lit *lit, num_u inverse, int count, num_u *lambert)
{
    for (int i = 0; i < count; i++)
        lambert[i] = lit->facing[i] > 0 ? num_lambert(num_mul_top(lit->facing[i], lit->inverse[i]), inverse) : 0;
}

/* True if the sphere blocks the light; `product` is t (C + Q).v and `turn` t C.v. */
static bool meets(const struct shadow_line *line, num_wide product, num_wide turn, const struct lit *lit, int i)
{
    num_wide a = shadow_toward(line, product, lit->reach[i]);

    if (a <= 0)
        return false;
    a -= shadow_bias(line, lit->facing[i], lit->half[i]);
    if (a <= 0 || (!line->enclosed && num_down(lit->square[i], line->square_down) <= num_down(a, line->product_down)))
        return false;
    num_wide k = shadow_power(line, turn, lit->reach[i]);
    if (k <= 0)
        return !line->enclosed;
    return num_covers(a, lit->near[i], lit->half[i], k, line->swell, line->exponent);
}

static void shadow(const struct shadow_line *line, const num_u *t, struct lit *lit)
{
    num_wide a = line->a, c = line->c;

    for (int i = 0; i < line->count; i++) {
        num distance = num_signed(t[i]);
        if (lit->facing[i] > 0 && meets(line, num_mul(distance, num_top(a)), num_mul(distance, num_top(c)), lit, i))
            lit->facing[i] = 0;
        a += line->a_step;
        c += line->c_step;
    }
}

static void add(num_u *sum, const num_u *lambert, num_u colour, int count)
{
    for (int i = 0; i < count; i++)
        sum[i] = num_clamp(sum[i] + num_colour_product(lambert[i], colour));
}

static void pack(const num_u *red, const num_u *green, const num_u *blue, const num_u *threshold, int x, int count,
                 tia_rgb565 *out)
{
    for (int i = 0; i < count; i++) {
        num_u half = threshold[(x + i) & 7];
        unsigned r = num_quantise(red[i], 31, half), g = num_quantise(green[i], 63, half),
                 b = blue == red ? r : num_quantise(blue[i], 31, half); /* greys are frequent */
        out[i] = (tia_rgb565)(r << 11 | g << 5 | b);
    }
}

const struct span_kernels span_kernels_plain = {sphere, sphere_inside, light, shadow, lambert, add, pack};
