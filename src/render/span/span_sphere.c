#include "span_sphere.h"

/* Prepares the exponents of the discriminant b^2 - c v.v. The accumulator of b is L.v * 2^b_shift, below 2^63. The
 * mantissa of b is its upper half, with the exponent e_b = 16 + f + b_shift - 32; that of v.v has e_v = 2f +
 * square_shift - 32. Both products need the same exponent, so c has the exponent 2 e_b - e_v = 2 b_shift -
 * square_shift. The mantissas of b and c must stay below 2^31. From inside, -c v.v is positive: one bit less keeps the
 * sum b + sqrt(...) below 2^32. */
static void prepare_discriminant(const struct primary_rays *primary, struct span_sphere *sphere)
{
    num_wide b_reach = primary_reach(primary, sphere->centre);
    int spare = sphere->c < 0, b_shift = 63 - num_bits(b_reach) - spare;
    int c_limit = ((primary->square_shift + 63 - num_bits(sphere->c)) >> 1) - spare;

    sphere->b_shift = b_shift < c_limit ? b_shift : c_limit;
    sphere->c_disc = num_scale(num_abs(sphere->c), 2 * sphere->b_shift - primary->square_shift - 32);
}

/* Prepares the exponent e_t of t, which keeps t^2 below 2^61. t^2 <= c / v.v from outside (the tangent), t^2 <= (2r)^2
 * / v.v from inside; v.v is at least depth^2. num_quotient(a, b, s) is a/b * 2^(63 - s), so e_t = e_a - e_b + 63 -
 * s. */
static void prepare_distance(const struct primary_rays *primary, struct span_sphere *sphere)
{
    int b_exponent = sphere->b_shift + primary->exponent - 16;
    int v_exponent = primary->square_shift + 2 * primary->exponent - 32;
    int depth_bits = num_bits(primary->depth * primary->depth) - 1 - 2 * primary->exponent;

    if (sphere->c < 0) {
        int reach_bits = num_bits(sphere->radius * sphere->radius) + 2 - 32;
        sphere->t_exponent = (61 - reach_bits + depth_bits) >> 1;
        sphere->t_shift = b_exponent - v_exponent + 63 - sphere->t_exponent;
    } else {
        int c_bits = num_bits(sphere->c);
        c_bits += num_bits(num_shift(sphere->c, 32 - c_bits)) > 32; /* all ones: rounded up to 2^32 */
        sphere->c_top = num_scale(sphere->c, 32 - c_bits);
        sphere->t_exponent = (61 - (c_bits - 32) + depth_bits) >> 1;
        sphere->t_shift = 64 - c_bits - b_exponent + 63 - sphere->t_exponent;
    }
}

/* Returns the rows that may show the sphere. They are treated as a line of pixels, one pixel for each row, with X =
 * -Y. */
static struct span rows_that_see(const struct primary_rays *primary, const struct span_sphere *sphere)
{
    struct span none = {0, 0}, all = {0, primary->height};
    struct cone_row s = {-sphere->centre.y,
                         -sphere->centre.z * primary->depth,
                         primary->depth * primary->depth,
                         sphere->c - sphere->centre.x * sphere->centre.x,
                         primary->exponent,
                         primary->height};

    /* along row y the largest (L.v)^2 / v.v is L.x^2 + (L.y Y - L.z depth)^2 / (Y^2 + depth^2): the square of L's
     * projection on the plane of the row */
    return s.c > 0 ? cone_row_span(&s, none) : all;
}

void span_sphere_prepare(const struct primary_rays *primary, struct span_sphere *sphere, struct num_vec centre,
                         tia_q16 radius)
{
    struct span none = {0, 0};

    sphere->centre = centre;
    sphere->radius = num_coordinate(radius);
    sphere->c = num_dot(sphere->centre, sphere->centre) - sphere->radius * sphere->radius;
    sphere->rows = none;
    sphere->wide = false;
    if (radius == 0)
        return;
    sphere->radius_bits = num_bits(sphere->radius);
    sphere->inverse = num_inverse(sphere->radius);
    prepare_discriminant(primary, sphere);
    prepare_distance(primary, sphere);
    sphere->rows = rows_that_see(primary, sphere);
}

struct span span_sphere_row(const struct primary_rays *primary, const struct span_sphere *sphere, int y,
                            struct span guess)
{
    num_wide row = primary_y(primary, y);
    struct cone_row s = {sphere->centre.x,
                         sphere->centre.y * row - sphere->centre.z * primary->depth,
                         row * row + primary->depth * primary->depth,
                         sphere->c,
                         primary->exponent,
                         primary->width};

    return cone_row_span(&s, guess);
}

void span_sphere_line(const struct primary_rays *primary, const struct span_sphere *sphere, int y, int x,
                      struct sphere_line *line)
{
    struct row_form b = primary_form(primary, sphere->centre, x, y, sphere->b_shift);

    line->b = b.start;
    line->b_step = b.step;
    line->square = primary_square(primary, x, y);
    line->c_disc = sphere->c_disc;
    line->c_top = sphere->c_top;
    line->t_shift = sphere->t_shift;
}
