/* span_exact.c - a pixel of a sphere that the kernels leave in doubt, computed with balls. */
#include "span_shade.h"

/* Surrounds the point of a single pixel, whose t has a doubt; |v| is below 2^30. */
static void surround_point(const struct tia_view *view, const struct shaded_span *span, struct span_lit *lit)
{
    const struct span_view *spans = view->prepared;
    const struct span_sphere *sphere = &spans->spheres[span->object];
    num_u doubt = num_distance_doubt(span->t[0], sphere->doubt_shift, sphere->doubt);
    num_wide radius = span_shift(num_up((num_wide)doubt, 30), 14 - sphere->t_exponent - spans->primary.exponent);

    lit->casters = &spans->casters;
    lit->object = span->object;
    lit->surrounded = span_bits(radius) < 29;
    lit->around.radius = (num)radius + 2;
    if (lit->surrounded)
        span_coarse_point(&spans->primary, sphere, span->x, span->y, span->t[0], &lit->around);
}

tia_rgb565 span_shade_exactly(const struct tia_view *view, const struct shaded_span *one, num_u threshold)
{
    struct exact_picture picture = span_picture_of(view);
    struct span_lit lit;

    surround_point(view, one, &lit);
    picture.next_caster = span_next_caster;
    picture.lit = &lit;
    return tia_exact_shade(&picture, one->x, one->y, one->object, (tia_q30)threshold, one->colours, one->path_hash);
}
