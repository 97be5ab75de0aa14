/* span_exact.c - a pixel of a sphere that the kernels leave in doubt, computed with balls. */
#include "span_shade.h"

tia_rgb565 span_shade_exactly(const struct tia_view *view, const struct shaded_span *one, num_u threshold)
{
    const struct span_view *spans = view->prepared;
    struct exact_picture picture = span_picture_of(view);
    struct span_lit lit = {.casters = &spans->casters, .object = one->object};

    lit.surrounded =
        span_coarse_point(&spans->primary, &spans->spheres[one->object], one->x, one->y, one->t[0], &lit.around);
    picture.next_caster = span_next_caster;
    picture.lit = &lit;
    return tia_exact_shade(&picture, one->x, one->y, one->object, (tia_q30)threshold, one->colours, one->path_hash);
}
