/* coherence_surround.c - a ball around the lit points of a span: spheres that span_is_clear_of() finds clear of it need
 * not be tried at its pixels. */
#include "coherence.h"

#include "render/span/span_error.h"

/* From outside a row's points lie on less than half of a circle: that at an end is the farthest. */
bool coherence_surround(const struct span_view *spans, const struct shaded_span *span, struct span part,
                        const struct lit *lit, const struct span_error *error, struct coarse_ball *ball)
{
    const struct span_sphere *sphere = &spans->spheres[span->object];
    int first = part.first, last = part.end - 1, apart = -SPAN_APART_MOST;

    if (sphere->c <= 0)
        return false;
    while (first < last && lit->facing[first] == 0)
        first++;
    while (last > first && lit->facing[last] == 0)
        last--;
    int middle = first + (last - first) / 2;
    for (int end = 0; end < 2; end++) {
        const int i = end ? last : first, x[2] = {span->x + middle, span->x + i};
        const num_u t[2] = {span->t[middle], span->t[i]};
        apart = num_larger(apart, span_error_apart(&spans->primary, sphere, span->y, x, t, error));
    }
    if (apart > SPAN_APART_MOST)
        return false;
    span_coarse_point(&spans->primary, sphere, span->x + middle, span->y, span->t[middle], ball);
    ball->radius = (num)span_error_number(apart + 14 * 256);
    return true;
}
