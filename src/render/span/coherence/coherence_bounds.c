/* coherence_bounds.c - bounds on the fixed-point errors of a run, derived in coherence_proved.h. */
#include "coherence_proved.h"
#include "coherence_run.h"
#include "math/noinline.h"

static NOINLINE num_u coherence_root(num_uwide x)
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
    return (span_bits(square) - 31) >> 1;
}

void coherence_go(struct coherence_run *run, int x)
{
    const struct primary_rays *primary = run->primary;
    num_wide ahead = (num_wide)(x - run->middle);
    num_wide first = num_pixel_coordinate(2 * x + 1 - primary->width, primary->exponent);

    run->body.b = run->b + ahead * run->body.b_step;
    run->light.g = run->g + ahead * run->light.g_step;
    run->light.q = run->q + ahead * run->light.q_step;
    run->body.square.start = num_up(num_square(first) + run->row_square, primary->square_shift) + NUM_HALF;
    run->light.square.start = run->body.square.start;
}

static struct span_depth depth_at(struct coherence_run *run, int x)
{
    num_u t;

    coherence_go(run, x);
    run->kernels->sphere(&run->body, &t);
    return span_depth_of(run->sphere, num_top_u(run->body.b), num_top_u(run->body.square.start), t);
}

static num_wide longer(const struct coherence_run *run, int first, int last)
{
    num_wide a = num_pixel_coordinate(2 * first + 1 - run->primary->width, run->primary->exponent);
    num_wide b = num_pixel_coordinate(2 * last + 1 - run->primary->width, run->primary->exponent);
    num_wide x = num_max(num_abs(a), num_abs(b)), y = primary_y(run->primary, run->y), z = run->primary->depth;

    return (num_wide)coherence_root((num_uwide)(num_square(x) + num_square(y) + num_square(z))) +
           num_bound(COHERENCE_BITS(COHERENCE_VIEW));
}

/* Returns a binary logarithm in 256ths as a whole number, rounded up. */
static int whole(int log)
{
    return (log + 255) >> 8;
}

bool coherence_bound(struct coherence_run *run, int first, int last)
{
    const struct light_source *source = &run->source;
    struct span_depth ends[2] = {depth_at(run, first), depth_at(run, last)};
    int light = length_bits(span_dot(&source->light, &source->light));

    run->v_most = longer(run, first, last);
    span_error_of(run->primary, source, &run->light, ends, run->v_most, &run->error);
    const struct span_error *e = &run->error;
    int away = 1 + num_larger(light, whole(e->point));
    run->square_slack = span_power(
        COHERENCE_BITS(COHERENCE_TURN) +
        num_larger(whole(e->square), COHERENCE_BITS(COHERENCE_MOVES) + away + whole(e->point) + whole(e->t)) +
        source->exponent);
    return span_power(whole(e->t) + 32) <= num_bound(COHERENCE_KNOWN);
}

num_wide coherence_lambert_slack(const struct coherence_run *run, num_wide square)
{
    struct span_error error = run->error;

    span_error_lambert(&run->source, square, &error);
    return !NUM_CERTIFIED || error.lambert < 0 ? span_error_number(30 * 256 + error.lambert) : (num_wide)NUM_ONE;
}

/* Returns an upper limit of the path: half of the arc between the samples' points. The chord of the arc is |t2 v2 - t1
 * v1| <= |t2 - t1| |v1| + t2 |v2 - v1|. */
num_wide coherence_path(const struct coherence_run *run, const struct coherence_sample *a,
                        const struct coherence_sample *b)
{
    int shift = run->exponent - run->sphere->t_exponent - run->primary->exponent;
    num_wide t = (num_wide)(a->t > b->t ? a->t : b->t), less = (num_wide)(a->t > b->t ? b->t : a->t);
    const struct span_error *e = &run->error;
    num_wide off = span_power(whole(e->t) + whole(e->mantissa) + COHERENCE_BITS(COHERENCE_STEP));
    num_wide half_step = num_pixel_coordinate(b->x - a->x, run->primary->exponent);
    num_wide chord = span_shift((t - less + off) * run->v_most, shift) + 2 * span_shift((t + off) * half_step, shift) +
                     num_bound(COHERENCE_BITS(COHERENCE_SHIFTS));

    return 4 * chord <= run->chord ? COHERENCE_WIDE(COHERENCE_SHORT, COHERENCE_SHORT(chord))
                                   : COHERENCE_WIDE(COHERENCE_ARC, COHERENCE_ARC(chord));
}

static num_wide side(const struct coherence_run *run, const struct coherence_sample *s)
{
    int shift = run->exponent - run->sphere->t_exponent - run->primary->exponent;

    return span_shift((num_wide)s->t * num_pixel_coordinate(2 * s->x + 1 - run->primary->width, run->primary->exponent),
                      shift);
}

/* Sets the chord to the distance of the two points along x alone, less the error bound of this distance. */
void coherence_measure(struct coherence_run *run, const struct coherence_sample *a, const struct coherence_sample *b)
{
    const struct span_error *e = &run->error;
    num_wide off = span_power(whole(e->t) + whole(e->point) + run->exponent + COHERENCE_BITS(COHERENCE_ENDS)) +
                   num_bound(COHERENCE_BITS(COHERENCE_ENDS_SHIFTS));

    run->chord = side(run, b) - side(run, a) - off;
}

/* Sets a caster's bounds, without the error of t, which coherence_path() includes. The bias is 2^-13. */
void coherence_bound_caster(const struct coherence_run *run, const struct span_sphere *caster,
                            struct coherence_caster *cast)
{
    const struct span_error *e = &run->error;
    struct num_vec away = num_vec_sub(caster->centre, run->source.light);
    int size = 30 - run->exponent, centre = length_bits(span_dot(&run->sphere->centre, &run->sphere->centre));
    int e_d = run->source.exponent, e_a = 43 + (e_d >> 1) - cast->line.bias_shift;
    int apart = 2 * (2 + num_larger(centre, size)) - 13 + COHERENCE_BELOW(COHERENCE_APART) - (e->radius >> 8),
        swell = 2 * size - 13 - (e->radius >> 8);
    int off_sphere = size - 12 + whole(e->point) + whole(e->t) - (e->radius >> 8);

    cast->power_exponent = 2 * e_a - e_d - cast->line.exponent;
    cast->radius = span_shift(caster->radius, run->exponent - 16) + num_bound(COHERENCE_BITS(COHERENCE_RADIUS));
    cast->away = span_shift((num_wide)coherence_root((num_uwide)span_square30(&away)), run->exponent - 15) +
                 span_power(num_larger(run->exponent - 15, 0) + COHERENCE_BITS(COHERENCE_AWAY));
    cast->scale = run->exponent - 31 - e_a + (e_d >> 1);
    cast->toward_error = COHERENCE_BITS(COHERENCE_TOWARD) + num_larger(whole(e->mantissa) - e_a, whole(e->reach));
    cast->power_error = COHERENCE_BITS(COHERENCE_POWER) +
                        num_larger(larger3(whole(e->mantissa) + 1 - cast->power_exponent, whole(e->reach), off_sphere),
                                   larger3(apart, swell, COHERENCE_BELOW(COHERENCE_APART_UNITS)));
}

struct coherence_slack coherence_shadow_slack(const struct coherence_run *run, const struct coherence_caster *cast,
                                              num_wide square, num_wide lambert_slack)
{
    const struct span_error *e = &run->error;
    int twice = span_bits(square) - COHERENCE_BITS(COHERENCE_DISTANCE) - run->source.exponent, once = twice >> 1;
    int size = 30 - run->exponent, bias = size - 43 + span_bits(lambert_slack);
    int length = COHERENCE_BITS(COHERENCE_LENGTH) + larger3(1 + num_larger(cast->toward_error, bias) - once,
                                                            size + whole(e->square) - twice,
                                                            size + COHERENCE_BELOW(COHERENCE_FOOT));
    struct coherence_slack slack = {span_power(length + run->exponent),
                                    span_power(cast->power_error + 2 * run->exponent)};

    return slack;
}
