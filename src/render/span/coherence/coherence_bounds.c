/* coherence_bounds.c - bounds on the fixed-point errors of a run, derived in coherence_proved.h. */
#include "coherence_proved.h"
#include "coherence_run.h"

#if defined(__GNUC__)
#define OUT_OF_LINE __attribute__((noinline))
#else
#define OUT_OF_LINE
#endif

OUT_OF_LINE num_wide coherence_shift(num_wide x, int s)
{
    return num_shift(x, s);
}

OUT_OF_LINE int coherence_bits(num_wide x)
{
    return num_bits(x);
}

OUT_OF_LINE num_wide coherence_power(int bits)
{
    return num_bound(bits);
}

static OUT_OF_LINE num_u coherence_root(num_uwide x)
{
    return num_sqrt(x);
}

static int larger3(int a, int b, int c)
{
    return num_larger(num_larger(a, b), c);
}

/* Returns b with |a| < 2^b, for `square` = a.a with the exponent 32. */
static int length_bits(num_wide square)
{
    return (coherence_bits(square) - 31) >> 1;
}

static num_wide sum_of_sizes(struct num_vec a)
{
    return num_abs(a.x) + num_abs(a.y) + num_abs(a.z);
}

void coherence_go(struct coherence_run *run, int x)
{
    const struct primary_rays *primary = run->primary;
    num_wide ahead = (num_wide)(x - run->middle);
    num_wide first = num_pixel_coordinate(2 * x + 1 - primary->width, primary->exponent);

    run->body.b = run->b + ahead * run->body.b_step;
    run->light.g = run->g + ahead * run->light.g_step;
    run->light.q = run->q + ahead * run->light.q_step;
    run->body.square.start = coherence_shift(first * first + run->row_square, primary->square_shift) + NUM_HALF;
    run->light.square.start = run->body.square.start;
}

/* sqrt(D), S and t at a pixel. */
struct depth {
    num_u root, sum, t;
};

static struct depth depth_at(struct coherence_run *run, int x)
{
    struct depth d;

    coherence_go(run, x);
    num_u top = num_top_u(run->body.b), square = num_top_u(run->body.square.start);
    d.root = coherence_root(num_excess(num_mul_u(top, top), num_mul_u(run->body.c_disc, square)));
    d.sum = top + d.root;
    run->kernels->sphere(&run->body, &d.t);
    return d;
}

static int least_bits(num_u a, num_u b)
{
    return coherence_bits((num_wide)(a < b ? a : b));
}

#define NO_BOUND 40

static int bound_t(const struct depth *a, const struct depth *b)
{
    int root = least_bits(a->root, b->root);

    if (root < COHERENCE_SMALLEST)
        return NO_BOUND;
    return COHERENCE_BITS(COHERENCE_DEPTH) + larger3(COHERENCE_BITS(COHERENCE_ROOT) - root - least_bits(a->sum, b->sum),
                                                     COHERENCE_BITS(COHERENCE_ROUNDED) - least_bits(a->t, b->t),
                                                     COHERENCE_BELOW(COHERENCE_INVERSE));
}

static num_wide longer(const struct coherence_run *run, int first, int last)
{
    num_wide a = num_pixel_coordinate(2 * first + 1 - run->primary->width, run->primary->exponent);
    num_wide b = num_pixel_coordinate(2 * last + 1 - run->primary->width, run->primary->exponent);
    num_wide x = num_max(num_abs(a), num_abs(b)), y = primary_y(run->primary, run->y), z = run->primary->depth;

    return (num_wide)coherence_root((num_uwide)(x * x + y * y + z * z)) +
           coherence_power(COHERENCE_BITS(COHERENCE_VIEW));
}

bool coherence_bound(struct coherence_run *run, int first, int last)
{
    const struct span_sphere *sphere = run->sphere;
    const struct light_source *source = &run->source;
    struct coherence_bounds *b = &run->bounds;
    struct depth left = depth_at(run, first), right = depth_at(run, last);
    int tangent = length_bits(sphere->c), light = length_bits(num_dot(source->light, source->light));

    run->v_most = longer(run, first, last);
    b->t = bound_t(&left, &right);
    b->mantissa = num_larger(coherence_bits((num_wide)left.t), coherence_bits((num_wide)right.t));
    b->point = b->mantissa + coherence_bits(run->v_most) - sphere->t_exponent - run->primary->exponent;
    b->point = b->point < tangent ? b->point : tangent;
    b->radius = sphere->radius_bits - 17;
    b->reach = COHERENCE_BITS(COHERENCE_REACH) + num_larger(b->mantissa, 2 * b->mantissa - run->light.reach_down) -
               source->reach_exponent;
    b->square = COHERENCE_BITS(COHERENCE_SQUARE) + num_larger(b->mantissa + 1 - source->exponent, b->reach);
    int facing_exponent = 15 - sphere->radius_bits + (source->exponent >> 1) - run->light.scale;
    int between = coherence_bits(sum_of_sizes(num_vec_sub(source->light, sphere->centre))) - 16;
    b->facing = COHERENCE_BITS(COHERENCE_FACING) + num_larger(b->mantissa - facing_exponent, between + b->point + b->t);
    int away = 1 + num_larger(light, b->point);
    b->square_slack = coherence_power(COHERENCE_BITS(COHERENCE_TURN) +
                                      num_larger(b->square, COHERENCE_BITS(COHERENCE_MOVES) + away + b->point + b->t) +
                                      source->exponent);
    return coherence_power(b->t + 32) <= coherence_power(COHERENCE_KNOWN);
}

/* Lower limits of |Q - P| and |Q - P|^2, as binary logarithms. */
struct distance {
    int once, twice;
};

static struct distance distance_of(const struct coherence_run *run, num_wide square)
{
    int twice = coherence_bits(square) - COHERENCE_BITS(COHERENCE_DISTANCE) - run->source.exponent;
    struct distance d = {twice >> 1, twice};

    return d;
}

num_wide coherence_lambert_slack(const struct coherence_run *run, num_wide square)
{
    const struct coherence_bounds *b = &run->bounds;
    struct distance d = distance_of(run, square);
    int relative = COHERENCE_BITS(COHERENCE_RELATIVE) +
                   num_larger(b->square - d.twice, COHERENCE_BITS(COHERENCE_MOVES) + b->point + b->t - d.once);

    if (coherence_power(relative + 25) > coherence_power(COHERENCE_CLOSE))
        return (num_wide)NUM_ONE;
    return coherence_power(30 + COHERENCE_BITS(COHERENCE_LAMBERT) +
                           larger3(b->facing - b->radius - d.once, relative - 1, COHERENCE_BELOW(COHERENCE_KERNELS)));
}

/* Returns an upper limit of the path: half of the arc between the samples' points. The chord of the arc is |t2 v2 - t1
 * v1| <= |t2 - t1| |v1| + t2 |v2 - v1|. */
num_wide coherence_path(const struct coherence_run *run, const struct coherence_sample *a,
                        const struct coherence_sample *b)
{
    int shift = run->exponent - run->sphere->t_exponent - run->primary->exponent;
    num_wide t = (num_wide)(a->t > b->t ? a->t : b->t), less = (num_wide)(a->t > b->t ? b->t : a->t);
    num_wide off = coherence_power(run->bounds.t + run->bounds.mantissa + COHERENCE_BITS(COHERENCE_STEP));
    num_wide half_step = num_pixel_coordinate(b->x - a->x, run->primary->exponent);
    num_wide chord = coherence_shift((t - less + off) * run->v_most, shift) +
                     2 * coherence_shift((t + off) * half_step, shift) +
                     coherence_power(COHERENCE_BITS(COHERENCE_SHIFTS));

    return 4 * chord <= run->chord ? COHERENCE_WIDE(COHERENCE_SHORT, COHERENCE_SHORT(chord))
                                   : COHERENCE_WIDE(COHERENCE_ARC, COHERENCE_ARC(chord));
}

static num_wide side(const struct coherence_run *run, const struct coherence_sample *s)
{
    int shift = run->exponent - run->sphere->t_exponent - run->primary->exponent;

    return coherence_shift(
        (num_wide)s->t * num_pixel_coordinate(2 * s->x + 1 - run->primary->width, run->primary->exponent), shift);
}

/* Sets the chord to the distance of the two points along x alone, less the error bound of this distance. */
void coherence_measure(struct coherence_run *run, const struct coherence_sample *a, const struct coherence_sample *b)
{
    num_wide off = coherence_power(run->bounds.t + run->bounds.point + run->exponent + COHERENCE_BITS(COHERENCE_ENDS)) +
                   coherence_power(COHERENCE_BITS(COHERENCE_ENDS_SHIFTS));

    run->chord = side(run, b) - side(run, a) - off;
}

/* Sets a caster's bounds, without the error of t, which coherence_path() includes. The bias is 2^-13. */
void coherence_bound_caster(const struct coherence_run *run, const struct span_sphere *caster,
                            struct coherence_caster *cast)
{
    const struct coherence_bounds *b = &run->bounds;
    struct num_vec away = num_vec_sub(caster->centre, run->source.light);
    int size = 30 - run->exponent, centre = length_bits(num_dot(run->sphere->centre, run->sphere->centre));
    int e_d = run->source.exponent, e_a = 43 + (e_d >> 1) - cast->line.bias_shift;
    int apart = 2 * (2 + num_larger(centre, size)) - 13 + COHERENCE_BELOW(COHERENCE_APART) - b->radius,
        swell = 2 * size - 13 - b->radius;
    int off_sphere = size - 12 + b->point + b->t - b->radius;

    cast->power_exponent = 2 * e_a - e_d - cast->line.exponent;
    cast->radius =
        coherence_shift(caster->radius, run->exponent - 16) + coherence_power(COHERENCE_BITS(COHERENCE_RADIUS));
    cast->away = coherence_shift((num_wide)coherence_root((num_uwide)num_square30(away)), run->exponent - 15) +
                 coherence_power(num_larger(run->exponent - 15, 0) + COHERENCE_BITS(COHERENCE_AWAY));
    cast->scale = run->exponent - 31 - e_a + (e_d >> 1);
    cast->toward_error = COHERENCE_BITS(COHERENCE_TOWARD) + num_larger(b->mantissa - e_a, b->reach);
    cast->power_error = COHERENCE_BITS(COHERENCE_POWER) +
                        num_larger(larger3(b->mantissa + 1 - cast->power_exponent, b->reach, off_sphere),
                                   larger3(apart, swell, COHERENCE_BELOW(COHERENCE_APART_UNITS)));
}

struct coherence_slack coherence_shadow_slack(const struct coherence_run *run, const struct coherence_caster *cast,
                                              num_wide square, num_wide lambert_slack)
{
    const struct coherence_bounds *b = &run->bounds;
    struct distance d = distance_of(run, square);
    int size = 30 - run->exponent, bias = size - 43 + coherence_bits(lambert_slack);
    int length =
        COHERENCE_BITS(COHERENCE_LENGTH) + larger3(1 + num_larger(cast->toward_error, bias) - d.once,
                                                   size + b->square - d.twice, size + COHERENCE_BELOW(COHERENCE_FOOT));
    struct coherence_slack slack = {coherence_power(length + run->exponent),
                                    coherence_power(cast->power_error + 2 * run->exponent)};

    return slack;
}
