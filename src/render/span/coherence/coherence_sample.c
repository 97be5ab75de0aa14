/* coherence_sample.c - computes single pixels of a run. */
#include "coherence_run.h"

static void sample_caster(const struct coherence_run *run, const struct lit *lit, struct coherence_sample *s, int j)
{
    const struct coherence_caster *cast = &run->caster[j];
    const struct shadow_line *line = &cast->line;
    num_wide ahead = (num_wide)(s->x - run->middle);
    num t = num_signed(s->t);
    num_wide product = num_mul(t, num_top(cast->a + ahead * line->a_step));
    num_wide turn = num_mul(t, num_top(cast->c + ahead * line->c_step));
    num_wide toward = shadow_toward(line, product, lit->reach[0]) - shadow_bias(line, lit->facing[0], lit->half[0]);
    num_wide power = shadow_power(line, turn, lit->reach[0]);
    num_u foot = num_mul_top(num_scale_within(num_abs(toward), cast->scale + lit->half[0]), lit->inverse[0]);

    s->foot[j] = toward < 0 ? -num_signed(foot) : num_signed(foot);
    s->clear[j] = span_shift(power, 2 * run->exponent - cast->power_exponent) - (num_wide)num_mul_u(foot, foot);
}

static void sample_casters(const struct coherence_run *run, const struct lit *lit, struct coherence_sample *s)
{
    int far_shift = run->exponent - (run->source.exponent >> 1) + 1;

    s->far = (num)span_shift((num_wide)num_mul_top(lit->near[0], lit->inverse[0]), far_shift - lit->half[0]);
    for (int j = 0; j < run->caster_count; j++)
        sample_caster(run, lit, s, j);
}

static num_wide square_here(const struct coherence_run *run, num_u distance)
{
    num t = num_signed(distance);

    return light_square(&run->light, t, run->light.q, light_reach(&run->light, t, run->light.square.start));
}

num_wide coherence_square_at(struct coherence_run *run, int x)
{
    num_u t;

    coherence_go(run, x);
    run->kernels->sphere(&run->body, &t);
    return square_here(run, t);
}

void coherence_sample_at(struct coherence_run *run, int x, bool shadows, struct coherence_sample *s)
{
    struct lit lit;

    coherence_go(run, x);
    run->kernels->sphere(&run->body, &s->t);
    s->x = x;
    s->lambert = 0;
    s->faces = run->kernels->light(&run->light, &s->t, &lit);
    if (s->faces) {
        s->square = lit.square[0];
        if (shadows)
            sample_casters(run, &lit, s);
        run->kernels->lambert(&lit, run->sphere->inverse, 1, &s->lambert);
    } else {
        s->square = square_here(run, s->t);
    }
}

num_u coherence_lambert_at(struct coherence_run *run, int x, bool *open)
{
    num_wide ahead = (num_wide)(x - run->middle);
    num_u t, lambert = 0;
    struct lit lit;

    coherence_go(run, x);
    run->kernels->sphere(&run->body, &t);
    if (run->kernels->light(&run->light, &t, &lit)) {
        for (int j = 0; j < run->caster_count; j++) {
            struct shadow_line *line = &run->caster[j].line;
            line->a = run->caster[j].a + ahead * line->a_step;
            line->c = run->caster[j].c + ahead * line->c_step;
            run->kernels->shadow(line, &t, &lit);
        }
        run->kernels->lambert(&lit, run->sphere->inverse, 1, &lambert);
    }
    *open = lit.open != 0;
    return lambert;
}
