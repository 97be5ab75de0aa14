/* coherence_bounds.c - bounds on the errors of a run's integers, derived.
 *
 * A bound here is the logarithm of a power of two: sums of up to four terms are below four times the largest. That is
 * coarse, by a few bits, and costs next to nothing; a level is 2^-6, and the errors are near 2^-20.
 *
 * T is the mantissa of t, below 2^31; an accumulator's upper half is off by .51 of its last bit.
 *
 * t = c/S, S = b + sqrt(D). b, v.v and c as mantissas are below 2^31, 2^31 and 2^32: in units of b's last bit D is off
 * by .51 (2^32 + 2^32 + 2^31 + 2) < 1.3 2^32, so sqrt(D) by that over itself and one bit for rounding down. D is
 * concave along the run: it is least at an end, where it was computed; so is S, which is concave as well. From 2^19 on
 * the computed root is within 1/32 of the true one. So with roots of B and sums of S bits, S is off by less than 1.4
 * 2^(33 - B) + 1.51 of more than .98 2^(S - 1), together less than 2^(36 - B - S) relative. T, which is at least half
 * of its value at an end since S is at most 2 b and b is largest at an end, is rounded by 1/2; the reciprocal and c add
 * 2^-30. All are in `t` below.
 *
 * The point at which the fixed-point code computes the light is P (1 + e), |e| < 2^t. That moves |Q - P|^2 by up to 2.1
 * |w| |P| e, r N.w, as computed c - L.Q + G.P, by |G| |P| e, A.w by 1.1 (|A| + |w|) |P| e and |A|^2 by 2.1 |A| |P| e.
 * Products of T with a form are off by .51 T of their last bit, constants and shifts by half a bit, |P|^2 by T/2 + .51
 * T^2 / 2^reach_down of its last bit. */
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

/* Returns b, |a| < 2^b, from a.a, which has the exponent 32. */
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

/* sqrt(D) and S at a pixel, and t. */
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

    if (root < 20)
        return NO_BOUND;
    return COHERENCE_DEPTH +
           larger3(COHERENCE_ROOT - root - least_bits(a->sum, b->sum), 1 - least_bits(a->t, b->t), -COHERENCE_INVERSE);
}

static num_wide longer(const struct coherence_run *run, int first, int last)
{
    num_wide a = num_pixel_coordinate(2 * first + 1 - run->primary->width, run->primary->exponent);
    num_wide b = num_pixel_coordinate(2 * last + 1 - run->primary->width, run->primary->exponent);
    num_wide x = num_max(num_abs(a), num_abs(b)), y = primary_y(run->primary, run->y), z = run->primary->depth;

    return (num_wide)coherence_root((num_uwide)(x * x + y * y + z * z)) + coherence_power(0);
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
    b->reach =
        COHERENCE_REACH + num_larger(b->mantissa, 2 * b->mantissa - run->light.reach_down) - source->reach_exponent;
    b->square = COHERENCE_SQUARE + num_larger(b->mantissa + 1 - source->exponent, b->reach);
    int facing_exponent = 15 - sphere->radius_bits + (source->exponent >> 1) - run->light.scale;
    int between = coherence_bits(sum_of_sizes(num_vec_sub(source->light, sphere->centre))) - 16;
    b->facing = COHERENCE_FACING + num_larger(b->mantissa - facing_exponent, between + b->point + b->t);
    int away = 1 + num_larger(light, b->point);
    b->square_slack = coherence_power(COHERENCE_TURN + num_larger(b->square, COHERENCE_MOVES + away + b->point + b->t) +
                                      source->exponent);
    return coherence_power(b->t + 32) <= coherence_power(20);
}

/* Gives d, where d^2 is at most `square` plus its error bound. */
struct distance {
    int once, twice;
};

static struct distance distance_of(const struct coherence_run *run, num_wide square)
{
    int twice = coherence_bits(square) - 2 - run->source.exponent;
    struct distance d = {twice >> 1, twice};

    return d;
}

/* Returns the bound: the errors of r N.w over r d, half the relative one of |w|^2, and 2^-26 for the kernels' products,
 * which add up to 2^-27.9. Twice that, between two pixels. |w|^2 must be accurate to 1/32. */
num_wide coherence_lambert_slack(const struct coherence_run *run, num_wide square)
{
    const struct coherence_bounds *b = &run->bounds;
    struct distance d = distance_of(run, square);
    int relative = COHERENCE_RELATIVE + num_larger(b->square - d.twice, COHERENCE_MOVES + b->point + b->t - d.once);

    if (coherence_power(relative + 25) > coherence_power(20))
        return (num_wide)NUM_ONE;
    return coherence_power(30 + COHERENCE_LAMBERT +
                           larger3(b->facing - b->radius - d.once, relative - 1, -COHERENCE_KERNELS));
}

/* Returns a bound of the path. The chord from one point to the other is |t2 v2 - t1 v1| <= |t2 - t1| |v1| + t2 |v2 -
 * v1|. Half an arc that is less than half a circle is at most pi/4 of its chord, which is below 51/64; and 1/2 of it,
 * but for 1.1 %, where the chord is at most a quarter of another one, which is no longer than the diameter. */
num_wide coherence_path(const struct coherence_run *run, const struct coherence_sample *a,
                        const struct coherence_sample *b)
{
    int shift = run->exponent - run->sphere->t_exponent - run->primary->exponent;
    num_wide t = (num_wide)(a->t > b->t ? a->t : b->t), less = (num_wide)(a->t > b->t ? b->t : a->t);
    num_wide off = coherence_power(run->bounds.t + run->bounds.mantissa + 2);
    num_wide half_step = num_pixel_coordinate(b->x - a->x, run->primary->exponent);
    num_wide chord = coherence_shift((t - less + off) * run->v_most, shift) +
                     2 * coherence_shift((t + off) * half_step, shift) + coherence_power(2);

    return 4 * chord <= run->chord ? chord / 2 + chord / 64 + coherence_power(1)
                                   : chord - chord / 8 - chord / 16 - chord / 64;
}

static num_wide side(const struct coherence_run *run, const struct coherence_sample *s)
{
    int shift = run->exponent - run->sphere->t_exponent - run->primary->exponent;

    return coherence_shift(
        (num_wide)s->t * num_pixel_coordinate(2 * s->x + 1 - run->primary->width, run->primary->exponent), shift);
}

/* Finds the chord: the points' distance along x alone, less the error of t at both. */
void coherence_measure(struct coherence_run *run, const struct coherence_sample *a, const struct coherence_sample *b)
{
    num_wide off = coherence_power(run->bounds.t + run->bounds.point + run->exponent + 2) + coherence_power(1);

    run->chord = side(run, b) - side(run, a) - off;
}

/* Bounds a caster, without the error of t, which is part of the path. A foot's share of `size` 2^-28 is the inverse
 * root's. */
void coherence_bound_caster(const struct coherence_run *run, const struct span_sphere *caster,
                            struct coherence_caster *cast)
{
    const struct coherence_bounds *b = &run->bounds;
    struct num_vec away = num_vec_sub(caster->centre, run->source.light);
    int size = 30 - run->exponent, centre = length_bits(num_dot(run->sphere->centre, run->sphere->centre));
    int e_d = run->source.exponent, e_a = 43 + (e_d >> 1) - cast->line.bias_shift;
    int apart = 2 * (2 + num_larger(centre, size)) - 39 - b->radius, swell = 2 * size - 13 - b->radius;
    int off_sphere = size - 12 + b->point + b->t - b->radius;

    cast->power_exponent = 2 * e_a - e_d - cast->line.exponent;
    cast->radius = coherence_shift(caster->radius, run->exponent - 16) + coherence_power(0);
    cast->away = coherence_shift((num_wide)coherence_root((num_uwide)num_square30(away)), run->exponent - 15) +
                 coherence_power(num_larger(run->exponent - 15, 0) + 1);
    cast->scale = run->exponent - 31 - e_a + (e_d >> 1);
    cast->toward_error = COHERENCE_TOWARD + num_larger(b->mantissa - e_a, b->reach);
    cast->power_error =
        COHERENCE_POWER +
        num_larger(larger3(b->mantissa + 1 - cast->power_exponent, b->reach, off_sphere), larger3(apart, swell, -27));
}

struct coherence_slack coherence_shadow_slack(const struct coherence_run *run, const struct coherence_caster *cast,
                                              num_wide square, num_wide lambert_slack)
{
    const struct coherence_bounds *b = &run->bounds;
    struct distance d = distance_of(run, square);
    int size = 30 - run->exponent, bias = size - 43 + coherence_bits(lambert_slack);
    int length = COHERENCE_LENGTH +
                 larger3(1 + num_larger(cast->toward_error, bias) - d.once, size + b->square - d.twice, size - 28);
    struct coherence_slack slack = {coherence_power(length + run->exponent),
                                    coherence_power(cast->power_error + 2 * run->exponent)};

    return slack;
}
