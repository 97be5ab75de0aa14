#include "kernels.h"

void kernel_sphere(const struct sphere_line *line, num_u *t)
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

void kernel_sphere_inside(const struct sphere_line *line, num_u *t)
{
    num_wide b = line->b;
    struct row_square v = line->square;

    for (int i = 0; i < line->count; i++) {
        num_u top = num_top_u(b), square = num_top_u(v.start);
        num_u root = num_sqrt(num_mul_u(top, top) + num_mul_u(line->c_disc, square));
        t[i] = num_quotient(top + root, square, line->t_shift);
        b += line->b_step;
        v.start += v.step;
        v.step += v.twice;
    }
}

static void light_pixel(const struct light_line *line, num_wide facing, num_wide square, struct lit *lit, int i)
{
    num_wide positive = square > 0 ? square : NUM_LEAST;
    struct num_normal n = num_normal(positive);

    lit->facing[i] = num_scale(facing, line->scale + n.half);
    lit->square[i] = positive;
    lit->near[i] = num_normal_top(n);
    lit->inverse[i] = n.inverse;
    lit->half[i] = (uint8_t)n.half;
}

bool kernel_light(const struct light_line *line, const num_u *distance, struct lit *lit)
{
    num_wide g = line->g, q = line->q;
    struct row_square v = line->square;
    bool any = false;

    for (int i = 0; i < line->count; i++) {
        num t = (num)distance[i];
        num_wide facing = line->facing + num_mul(t, num_top(g));

        lit->facing[i] = 0;
        if (facing > 0) {
            num reach = (num)num_scale(num_mul(t, num_top(v.start)), line->reach_scale);
            light_pixel(line, facing, line->distance - 2 * num_mul(t, num_top(q)) + num_mul(t, reach), lit, i);
            any = true;
        }
        g += line->g_step;
        q += line->q_step;
        v.start += v.step;
        v.step += v.twice;
    }
    return any;
}

void kernel_lambert(const struct lit *lit, num_u inverse, int count, num_u *lambert)
{
    for (int i = 0; i < count; i++)
        lambert[i] = lit->facing[i] > 0 ? num_lambert(num_mul_top(lit->facing[i], lit->inverse[i]), inverse) : 0;
}

/* Whether the light, inside the sphere, is met from P: P is outside, and faces the centre. */
static bool meets_enclosed(const struct shadow_line *line, num_wide square, num_wide product)
{
    num_wide w = num_shift(square, line->square_scale), b = num_shift(product, line->product_scale);

    return w >= b && w - 2 * b + line->outside > 0;
}

static bool meets(const struct shadow_line *line, num_wide u, const struct lit *lit, int i)
{
    num_wide product = u - line->to_light;
    int half = lit->half[i];

    if (line->enclosed)
        return meets_enclosed(line, lit->square[i], product);
    if (product <= 0)
        return false;
    num_u b = num_scale(product, line->b_scale + half) + num_mul_top(lit->facing[i], line->b_bias);
    num_wide k = (num_wide)line->k - num_mul_shift(num_top(u - line->to_centre), line->k_bias, line->k_bias_shift);
    if (k > 0 && num_square_below(b, lit->near[i], (num_u)k))
        return false;
    return num_reaches(lit->square[i], half, b, line->reach_shift);
}

void kernel_shadow(const struct shadow_line *line, const num_u *t, struct lit *lit)
{
    num_wide b = line->b;

    for (int i = 0; i < line->count; i++, b += line->b_step)
        if (lit->facing[i] > 0 && meets(line, num_mul((num)t[i], num_top(b)), lit, i))
            lit->facing[i] = 0;
}

void kernel_add(num_u *sum, const num_u *lambert, num_u colour, int count)
{
    for (int i = 0; i < count; i++) {
        sum[i] = num_clamp(sum[i] + num_colour_product(lambert[i], colour));
    }
}

void kernel_pack(const num_u *red, const num_u *green, const num_u *blue, const num_u *threshold, int x, int count,
                 tia_rgb565 *out)
{
    for (int i = 0; i < count; i++) {
        num_u half = threshold[(x + i) & 7];
        unsigned r = num_quantise(red[i], 31, half), g = num_quantise(green[i], 63, half),
                 b = num_quantise(blue[i], 31, half);
        out[i] = (tia_rgb565)(r << 11 | g << 5 | b);
    }
}
