/* span_exact.c - a pixel of a sphere that the kernels leave in doubt, computed with balls; and pixels that no sphere
 * shades. */
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

static num_wide distance_between(const struct coarse_ball *a, const struct coarse_ball *b)
{
    return num_abs((num_wide)a->x - b->x) + num_abs((num_wide)a->y - b->y) + num_abs((num_wide)a->z - b->z);
}

/* The points of a row lie on less than half of a circle, so that of all points none is farther from the middle one's
 * than those of the ends. Each may be off by the radius of its ball. */
bool span_is_unshaded(const struct tia_view *view, uint32_t object, int x, int y, int count)
{
    const struct span_view *spans = view->prepared;
    const int at[3] = {x, x + count - 1, x + count / 2};
    struct span_lit lit[3];
    num_wide radius = 0;

    for (int i = 0; i < 3; i++) {
        num_u t;
        struct shaded_span one = {object, at[i], y, 1, &t, NULL, NULL};
        span_distances(spans, object, y, at[i], 1, &t);
        surround_point(view, &one, &lit[i]);
        if (!lit[i].surrounded)
            return false;
    }
    for (int i = 0; i < 2; i++)
        radius = num_max(radius, distance_between(&lit[i].around, &lit[2].around) + lit[i].around.radius);
    radius += 2 * (num_wide)lit[2].around.radius;
    if (span_bits(radius) >= 29)
        return false;
    lit[2].around.radius = (num)radius;
    return span_next_caster(&lit[2], 0, 0) >= view->scene->sphere_count;
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
