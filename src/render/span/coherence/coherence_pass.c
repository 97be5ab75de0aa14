/* coherence_pass.c - spheres that cast no shadow on a whole span, found by the shadow ray of one of its points.
 *
 * Let e bound the distances of the points where the span's shadow rays begin from that of this point. Each point of
 * another ray is within e of a point of this one. So if the sphere is farther from the ray's line than its radius and
 * e, it meets none of the rays. */
#include "coherence.h"

#include "render/span/span_error.h"

/* Finds the lit pixel next to the middle. From outside a row's points lie on less than half of a circle: that at an end
 * is the farthest. */
void coherence_find_middle(const struct span_view *spans, const struct shaded_span *span, const struct lit *lit,
                           const struct span_error *error, struct span_middle *middle)
{
    const struct span_sphere *sphere = &spans->spheres[span->object];
    int last = span->count - 1, i = last / 2;

    while (i < last && lit->facing[i] == 0)
        i++;
    while (i > 0 && lit->facing[i] == 0)
        i--;
    *middle = (struct span_middle){i, lit->facing[i], SPAN_APART_NONE};
    for (int end = 0; end < 2 && middle->facing > 0 && sphere->c > 0; end++) {
        const int x[2] = {span->x + i, span->x + (end ? last : 0)};
        const num_u t[2] = {span->t[i], span->t[end ? last : 0]};
        int apart = span_error_apart(&spans->primary, sphere, span->y, x, t, error);
        middle->apart = end == 0 || apart > middle->apart ? apart : middle->apart;
    }
}

/* A sphere larger by e has (|A'|^2 - (R + e)^2)/(1 + bias/r) less by at most span_error_spread(). */
bool coherence_passes(const struct span_middle *middle, const struct light_source *source,
                      const struct span_sphere *caster, const struct shadow_line *line, const num_u *t,
                      const struct lit *lit)
{
    int i = middle->pixel;
    num distance = num_signed(t[i]);
    num_wide product = num_mul(distance, num_top(line->a + (num_wide)i * line->a_step));
    num_wide turn = num_mul(distance, num_top(line->c + (num_wide)i * line->c_step));
    num_wide a = shadow_toward(line, product, lit->reach[i]) - shadow_bias(line, middle->facing, lit->half[i]);
    num_wide k = shadow_power(line, turn, lit->reach[i]) - line->k_doubt;

    k -= span_error_spread(source, caster, line, middle->apart);
    return k > 0 && num_cover_order(num_abs(a) + line->a_doubt, lit->near[i], lit->half[i], k, line->swell,
                                    line->exponent, line->margin) < 0;
}
