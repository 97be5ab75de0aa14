/* span_error.c - the bounds that span_proved.h derives. */
#include "span_error.h"

#include "math/integer.h"
#include "math/noinline.h"
#include "span_proved.h"

/* ---- logarithms ---- */

#define ONE 256
#define COARSE 14              /* the exponent of a struct coarse_ball */
#define COARSE_MOST (20 * ONE) /* a choice: with larger errors no shadow is decided */

static ONCE_IN_FLASH int log_down(num_wide x)
{
    return num_log(x);
}

/* log2(1 + f) - f is at most .0861. */
static ONCE_IN_FLASH int log_up(num_wide x)
{
    return num_log(x) + 24;
}

/* log2(1 + 2^-n) for n = 0..9, rounded up, less 1. */
static const TIA_FLASH uint8_t sums[10] = {255, 149, 82, 43, 22, 11, 5, 2, 1, 0};

/* Returns an upper limit of the logarithm of a sum. */
static ONCE_IN_FLASH int sum_of(int a, int b)
{
    int larger = a > b ? a : b, apart = (larger - (a > b ? b : a)) >> 8;

    return larger + sums[apart < 9 ? apart : 9] + 1;
}

/* Returns the logarithm of the length of a, whose exponent is 16, rounded up. */
static int log_length(struct num_vec a)
{
    return (log_up(span_square30(&a) + 1) + 2 * ONE + 1) / 2 - 16 * ONE;
}

/* ---- t ---- */

struct span_depth span_depth_of(const struct span_sphere *sphere, num_u top, num_u square, num_u t)
{
    struct span_depth d = {0, top, t};

    d.root = num_sqrt(sphere->c < 0 ? num_mul_u(sphere->c_disc, square)
                                    : num_excess(num_mul_u(top, top), num_mul_u(sphere->c_disc, square)));
    d.sum += d.root;
    return d;
}

static num_wide lesser(num_u a, num_u b)
{
    return (num_wide)(a < b ? a : b);
}

/* Returns a lower limit of S over the run: b is linear, and sqrt(D) least at an end. */
static num_wide least_sum(const struct span_depth *a, const struct span_depth *b)
{
    return lesser(a->sum - a->root, b->sum - b->root) + lesser(a->root, b->root);
}

/* Returns the bound of t from outside. */
static int bound_t(const struct primary_rays *primary, const struct span_sphere *sphere, const struct span_depth *a,
                   const struct span_depth *b)
{
    int root = log_down(lesser(a->root, b->root)), sum = log_down(least_sum(a, b));
    int b_bit = (sphere->b_shift - 32) * ONE, t = SPAN_LOG(SPAN_ERROR_ROOT) - root - sum;

    t = sum_of(t, SPAN_LOG(SPAN_ERROR_SUM) - sum);
    t = sum_of(t, SPAN_LOG(SPAN_ERROR_ROUNDED) - log_down(lesser(a->t, b->t)));
    t = sum_of(t, SPAN_LOG(SPAN_ERROR_INVERSE));
    if (primary->exact)
        return t;
    t = sum_of(t, SPAN_LOG(SPAN_ERROR_TURNED_ROOT) + log_up(sphere->radius) + b_bit - root);
    t = sum_of(t, SPAN_LOG(SPAN_ERROR_TURNED_SUM) + log_up(num_abs(sphere->centre.z)) + b_bit - sum);
    return sum_of(t, SPAN_LOG(SPAN_ERROR_TURNED) - log_down(primary->depth));
}

/* Returns the bound of t from inside, as a part of 2^31: D is at least |c| K^2, whose root this is. */
static int bound_t_inside(const struct primary_rays *primary, const struct span_sphere *sphere, num_u least_root)
{
    int root = log_down((num_wide)least_root), b_bit = (sphere->b_shift - 32) * ONE;
    int square = log_down(num_square(primary->depth)) + (primary->square_shift - 32) * ONE;
    int quotient = square + sphere->t_shift * ONE, t = SPAN_LOG(SPAN_ERROR_INSIDE_ROOT) - root - quotient;

    t = sum_of(t, SPAN_LOG(SPAN_ERROR_INSIDE_TURNED) + log_up(sphere->radius) + b_bit - root - quotient);
    t = sum_of(t, SPAN_LOG(SPAN_ERROR_INSIDE_SUM) + log_up(num_abs(sphere->centre.z)) + b_bit - quotient);
    t = sum_of(t, SPAN_LOG(SPAN_ERROR_INSIDE_UNITS) - quotient);
    t = sum_of(t, SPAN_LOG(SPAN_ERROR_INSIDE_SQUARE) - square);
    t = sum_of(t, SPAN_LOG(SPAN_ERROR_TURNED) - log_down(primary->depth));
    return sum_of(t, SPAN_LOG(SPAN_ERROR_INVERSE));
}

/* ---- exponents of the lines' numbers ---- */

/* That of A.w. */
static int exponent_of_toward(const struct light_source *source, const struct shadow_line *line)
{
    return 43 + (source->exponent >> 1) - line->bias_shift;
}

/* That of |A|^2 - R^2. */
static int exponent_of_power(const struct light_source *source, const struct shadow_line *line)
{
    return 2 * exponent_of_toward(source, line) - source->exponent - line->exponent;
}

/* ---- the bounds without light and shadows ---- */

void span_error_points(const struct primary_rays *primary, const struct span_sphere *sphere,
                       const struct span_depth ends[2], num_wide v_most, struct span_error *error)
{
    int v = log_up(v_most) - (sphere->t_exponent + primary->exponent) * ONE;

    error->t = 0;
    if (span_bits(lesser(ends[0].root, ends[1].root)) < SPAN_ERROR_ROOT_BITS)
        return;
    if (sphere->c < 0) {
        error->t = bound_t_inside(primary, sphere, ends[0].root);
        error->mantissa = 31 * ONE;
        error->point = error->mantissa + v;
    } else {
        int tangent = (log_up(sphere->c) - 32 * ONE) / 2 + 1;
        error->t = bound_t(primary, sphere, &ends[0], &ends[1]);
        error->mantissa = log_up((num_wide)ends[0].t) + log_up((num_wide)ends[0].sum) -
                          log_down(least_sum(&ends[0], &ends[1])) + SPAN_LOG(SPAN_ERROR_MANTISSA);
        error->point = error->mantissa + v < tangent ? error->mantissa + v : tangent;
    }
    error->radius = log_down(sphere->radius) - 16 * ONE;
}

num span_error_coarse(const struct span_error *error)
{
    if (error->t >= 0)
        return 0;
    int moved = error->point + error->t + COARSE * ONE;
    return moved < COARSE_MOST ? (num)num_bound_of_log(moved) + 2 : 0;
}

void span_error_of(const struct light_source *source, const struct light_line *line, struct span_error *error)
{
    struct num_vec g = span_difference(&source->light, &source->sphere->centre);

    error->lambert = 0;
    if (error->t >= 0)
        return;
    error->reach = sum_of(SPAN_LOG(SPAN_ERROR_REACH) + error->mantissa,
                          SPAN_LOG(SPAN_ERROR_REACH_SQUARE) + 2 * error->mantissa - line->reach_down * ONE) -
                   source->reach_exponent * ONE;
    error->square = sum_of(SPAN_LOG(SPAN_ERROR_SQUARE) + error->mantissa - source->exponent * ONE, error->reach);
    error->facing = sum_of(SPAN_LOG(SPAN_ERROR_FACING) + error->mantissa - light_facing_exponent(source, line) * ONE,
                           log_length(g) + error->point + error->t);
}

num_wide span_error_facing(const struct light_source *source, const struct light_line *line,
                           const struct span_error *error)
{
    return num_bound_of_log(error->facing + light_facing_exponent(source, line) * ONE);
}

/* ---- light and shadows ---- */

void span_error_lambert(const struct light_source *source, num_wide square, struct span_error *error)
{
    int twice = log_down(square) - source->exponent * ONE - SPAN_LOG(SPAN_ERROR_DISTANCE);
    int once = twice >= 0 ? twice / 2 : (twice - 1) / 2;

    error->lambert = 0;
    if (error->t >= 0)
        return;
    error->relative = sum_of(error->square - twice, SPAN_LOG(SPAN_ERROR_MOVED) + error->point + error->t - once);
    if (error->relative > SPAN_LOG(SPAN_ERROR_CLOSE))
        return;
    int cosine = sum_of(error->facing - error->radius - once, error->relative - ONE);
    error->lambert = sum_of(SPAN_LOG(SPAN_ERROR_COSINE) + cosine, SPAN_LOG(SPAN_ERROR_KERNELS));
}

bool span_error_shadow(const struct light_source *source, const struct span_sphere *caster,
                       const struct span_error *error, struct shadow_line *line)
{
    int e_d = source->exponent, e_a = exponent_of_toward(source, line), e_k = exponent_of_power(source, line);
    int w = sum_of(log_length(source->light), error->point), size = sum_of(log_length(caster->centre), error->point);
    int moved = error->point + error->t;
    int radii = sum_of(log_up(caster->radius), log_up(source->sphere->radius)) - 16 * ONE;
    int apart = 2 * sum_of(sum_of(log_length(source->sphere->centre), size), radii);
    int toward = sum_of(SPAN_LOG(SPAN_ERROR_TOWARD) + error->mantissa - e_a * ONE, error->reach);
    int power = sum_of(SPAN_LOG(SPAN_ERROR_POWER) + error->mantissa - e_k * ONE, error->reach);

    toward = sum_of(toward, SPAN_LOG(SPAN_ERROR_TOWARD_MOVED) + sum_of(size, w) + moved);
    toward = sum_of(toward, SPAN_LOG(SPAN_ERROR_BIAS) + w + error->lambert);
    power = sum_of(power, SPAN_LOG(SPAN_ERROR_POWER_MOVED) + size + moved);
    power = sum_of(power, SPAN_LOG(SPAN_ERROR_APART) + apart - error->radius);
    power = sum_of(power, SPAN_LOG(SPAN_ERROR_APART_UNITS));
    int beyond = sum_of(sum_of(toward, error->square), SPAN_LOG(SPAN_ERROR_MOVED) + w + moved);
    beyond += (e_a < e_d ? e_a : e_d) * ONE;
    toward += e_a * ONE;
    power += e_k * ONE;
    line->a_doubt = num_bound_of_log(toward);
    line->k_doubt = num_bound_of_log(power);
    line->beyond_doubt = num_bound_of_log(beyond);
    bool rough = error->relative <= SPAN_LOG(SPAN_ERROR_COVER);
    line->a_clear = rough ? num_bound_of_log(toward + NUM_CLEAR) : num_bound(62);
    line->k_clear = rough ? num_bound_of_log(power + NUM_CLEAR) : num_bound(62);
    line->margin = num_limited(-error->relative / ONE, 0, 26);
    return toward <= SPAN_ERROR_DOUBT_MOST && power <= SPAN_ERROR_DOUBT_MOST && beyond <= SPAN_ERROR_DOUBT_MOST;
}
