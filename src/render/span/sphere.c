#include "sphere.h"

#include "kernels.h"

/* The exponents. An accumulator for b is L.v * 2^b_shift, below 2^63, and its upper half the
 * mantissa: its exponent is e_b = 16 + f + b_shift - 32; for v.v it is e_v = 2f + square_shift - 32.
 * For b^2 - c v.v both products need the same exponent, so c is taken with
 * 2 e_b - e_v = 2 b_shift - square_shift. Both must stay below 2^31. From inside -c v.v is added:
 * then one bit less keeps the sum b + sqrt(...) below 2^32. */
static void prepare_discriminant(const struct lattice *lattice, struct body *body)
{
    num_wide b_reach = lattice_reach(lattice, body->centre);
    int spare = body->c < 0, b_shift = 63 - num_bits(b_reach) - spare;
    int c_limit = ((lattice->square_shift + 63 - num_bits(body->c)) >> 1) - spare;

    body->b_shift = b_shift < c_limit ? b_shift : c_limit;
    body->c_disc = num_scale(num_abs(body->c), 2 * body->b_shift - lattice->square_shift - 32);
}

/* t^2 <= c / v.v from outside (the tangent), t^2 <= (2r)^2 / v.v from inside; v.v is at least
 * depth^2. The exponent of t makes t^2 < 2^61. num_quotient(a, b, s) is a/b * 2^(63 - s), with
 * the exponents e of a and b: e_t = e_a - e_b + 63 - s. */
static void prepare_distance(const struct lattice *lattice, struct body *body)
{
    int b_exponent = body->b_shift + lattice->exponent - 16;
    int v_exponent = lattice->square_shift + 2 * lattice->exponent - 32;
    int depth_bits = num_bits(lattice->depth * lattice->depth) - 1 - 2 * lattice->exponent;

    if (body->c < 0) {
        int reach_bits = num_bits(body->radius * body->radius) + 2 - 32;
        body->t_exponent = (61 - reach_bits + depth_bits) >> 1;
        body->t_shift = b_exponent - v_exponent + 63 - body->t_exponent;
    } else {
        int c_bits = num_bits(body->c);
        c_bits += num_bits(num_shift(body->c, 32 - c_bits)) > 32; /* all ones: rounded up to 2^32 */
        body->c_top = num_scale(body->c, 32 - c_bits);
        body->t_exponent = (61 - (c_bits - 32) + depth_bits) >> 1;
        body->t_shift = 64 - c_bits - b_exponent + 63 - body->t_exponent;
    }
}

/* A line of pixels as the cone meets it: a row, or the rows themselves (then X is -Y). */
static struct run rows_that_see(const struct lattice *lattice, const struct body *body)
{
    struct run none = {0, 0}, all = {0, lattice->height};
    struct slice s = {-body->centre.y,
                      -body->centre.z * lattice->depth,
                      lattice->depth * lattice->depth,
                      body->c - body->centre.x * body->centre.x,
                      lattice->exponent,
                      lattice->height};

    /* Along row y the largest (L.v)^2 / v.v is L.x^2 + (L.y Y - L.z depth)^2 / (Y^2 + depth^2):
     * the square of L's projection on the plane of the row. */
    return s.c > 0 ? slice_run(&s, none) : all;
}

void sphere_prepare(const struct lattice *lattice, struct body *body, struct num_vec centre, tia_q16 radius)
{
    struct run none = {0, 0};

    body->centre = centre;
    body->radius = num_coordinate(radius);
    body->c = num_dot(body->centre, body->centre) - body->radius * body->radius;
    body->rows = none;
    if (radius == 0)
        return;
    body->radius_bits = num_bits(body->radius);
    body->inverse = num_inverse(body->radius);
    prepare_discriminant(lattice, body);
    prepare_distance(lattice, body);
    body->rows = rows_that_see(lattice, body);
}

struct run sphere_run(const struct lattice *lattice, const struct body *body, int y, struct run guess)
{
    num_wide row = lattice_y(lattice, y);
    struct slice s = {body->centre.x,
                      body->centre.y * row - body->centre.z * lattice->depth,
                      row * row + lattice->depth * lattice->depth,
                      body->c,
                      lattice->exponent,
                      lattice->width};

    return slice_run(&s, guess);
}

void sphere_distances(const struct lattice *lattice, const struct body *body, int y, int x, int count, num_u *t)
{
    struct row_form b = lattice_form(lattice, body->centre, x, y, body->b_shift);
    struct sphere_line line = {b.start,       b.step, lattice_square(lattice, x, y), body->c_disc, body->c_top,
                               body->t_shift, count};

    if (body->c < 0)
        kernel_sphere_inside(&line, t);
    else
        kernel_sphere(&line, t);
}
