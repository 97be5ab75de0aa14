#include "span_sphere.h"

#include <stddef.h>

/* Prepares the exponents of the discriminant b^2 - c v.v. The accumulator of b is L.v * 2^b_shift, below 2^63. The
 * mantissa of b is its upper half, with the exponent e_b = 16 + f + b_shift - 32; that of v.v has e_v = 2f +
 * square_shift - 32. Both products need the same exponent, so c has the exponent 2 e_b - e_v = 2 b_shift -
 * square_shift. The mantissas of b and c must stay below 2^31. From inside, -c v.v is positive: one bit less keeps the
 * sum b + sqrt(...) below 2^32. */
static void prepare_discriminant(const struct primary_rays *primary, struct span_sphere *sphere)
{
    num_wide b_reach = primary_reach(primary, &sphere->centre);
    int spare = sphere->c < 0, b_shift = 63 - span_bits(b_reach) - spare;
    int c_limit = ((primary->square_shift + 63 - span_bits(sphere->c)) >> 1) - spare;

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
    int depth_bits = span_bits(num_square(primary->depth)) - 1 - 2 * primary->exponent;

    int c_bits = span_bits(sphere->c);

    c_bits += span_bits(span_shift(num_abs(sphere->c), 32 - c_bits)) > 32; /* all ones: rounded up to 2^32 */
    sphere->c_top = num_scale(num_abs(sphere->c), 32 - c_bits);
    int reach_bits = sphere->c < 0 ? span_bits(num_square(sphere->radius)) + 2 : c_bits;
    sphere->t_exponent = (61 - (reach_bits - 32) + depth_bits) >> 1;
    int by_c = 64 - c_bits - b_exponent + 63 - sphere->t_exponent;
    int by_square = b_exponent - v_exponent + 63 - sphere->t_exponent;
    sphere->t_shift = sphere->c < 0 ? by_square : by_c;
    sphere->behind_shift = by_c;
}

/* Prepares the doubts. K is off by .51 of its last bit, so b by that of L.z, v.v by 1.02 K, and D = b^2 - c v.v by less
 * than 1.1 (|b L.z| + |c| K), |b| being below its reach.
 *
 * In b's last bits D is off by 1.3 2^32 by rounding (COHERENCE_ROOT), and by K, of which 2^-bits of K is the relative
 * error: where D is small, b^2 is c v.v, and L without its part along v is at most r long, so that D is off by
 * 2.04 2^-bits (b K r + D). So S is off by at most the root of that sum, and t by as much of itself as S.
 *
 * Where S is at least 2^24, that is 2^16.2 and 2 by rounding, and by K the root of 1.02 b r, b at most S and r below
 * 2^6 of b's last bits: together less than 2^-7.2 of S. As S is at least 2^(94 - t_shift)/t, so much is t off up to
 * 2^(70 - t_shift). */
static void prepare_doubts(const struct primary_rays *primary, struct span_sphere *sphere)
{
    num_wide b_reach = primary_reach(primary, &sphere->centre), depth = primary->depth;
    bool accurate = sphere->c >= 0 && span_bits(sphere->radius) + sphere->b_shift - 32 <= 6;
    sphere->depth_bits = primary->exact ? 62 : span_bits(depth);
    sphere->turn = span_bits(depth * sphere->radius) + sphere->b_shift - 32 - sphere->depth_bits;
    int root = (35 + num_larger(sphere->turn, 0)) >> 1, shift = 61 - root - sphere->t_shift;
    int square_bits = span_bits(num_square(depth)) + primary->square_shift - 32;
    int inside = root + 64 - sphere->t_shift - square_bits;

    sphere->cone_doubt =
        primary->exact ? -1 : num_high(b_reach, num_abs(sphere->centre.z)) + num_high(num_abs(sphere->c), depth) + 3;
    sphere->doubt_shift = sphere->c < 0 || shift < 0 ? 31 : num_limited(shift, 0, 31);
    sphere->accurate = (num_u)span_power(accurate ? num_limited(70 - sphere->t_shift, 0, 31) : 0);
    if (sphere->c < 0 ? inside > 30 : shift < 0)
        sphere->doubt = (num_u)span_power(29) * 3;
    else
        sphere->doubt = (num_u)span_power(sphere->c < 0 ? inside : 0);
}

/* Returns the rows that may show the sphere. They are treated as a line of pixels, one pixel for each row, with X =
 * -Y. */
static struct span rows_that_see(const struct primary_rays *primary, const struct span_sphere *sphere)
{
    struct span none = {0, 0}, all = {0, primary->height};
    struct cone_row s = {-sphere->centre.y,
                         -sphere->centre.z * primary->depth,
                         num_square(primary->depth),
                         sphere->c - sphere->centre.x * sphere->centre.x,
                         primary->exponent,
                         primary->height,
                         sphere->cone_doubt,
                         NULL,
                         NULL,
                         0,
                         0};

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
    sphere->c = span_dot(&sphere->centre, &sphere->centre) - num_square(sphere->radius);
    sphere->rows = none;
    if (radius == 0)
        return;
    sphere->radius_bits = span_bits(sphere->radius);
    sphere->inverse = num_inverse(sphere->radius);
    prepare_discriminant(primary, sphere);
    prepare_distance(primary, sphere);
    prepare_doubts(primary, sphere);
    sphere->rows = rows_that_see(primary, sphere);
}

void span_sphere_line(const struct primary_rays *primary, const struct span_sphere *sphere, int y, int x,
                      struct sphere_line *line)
{
    struct row_form b = primary_form(primary, &sphere->centre, x, y, sphere->b_shift);

    line->b = b.start;
    line->b_step = b.step;
    line->square = primary_square(primary, x, y);
    line->c_disc = sphere->c_disc;
    line->c_top = sphere->c_top;
    line->t_shift = sphere->t_shift;
    line->behind_shift = sphere->behind_shift;
}
