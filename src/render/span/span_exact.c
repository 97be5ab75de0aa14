/* span_exact.c - a pixel of a sphere that the kernels leave in doubt, computed with balls. */
#include "span_shade.h"

/* What next_caster_until_stopped() needs. */
struct polled {
    struct span_lit lit; /* must be first */
    const struct tia_view *view;
};

/* Polls `stop` for each caster, as one takes thousands of instructions with balls; there is none any more after it. */
static uint32_t next_caster_until_stopped(const void *lit, uint32_t light, uint32_t from)
{
    const struct polled *polled = lit;

    return view_stops(polled->view) ? polled->lit.casters->count : span_next_caster(lit, light, from);
}

tia_rgb565 span_shade_exactly(const struct tia_view *view, const struct shaded_span *one, num_u threshold)
{
    const struct span_view *spans = view->prepared;
    struct exact_picture picture = span_picture_of(view);
    struct polled polled = {.lit = {.casters = &spans->casters, .object = one->object}, .view = view};

    polled.lit.surrounded = span_coarse_point(&spans->primary, &spans->spheres[one->object], one->x, one->y, one->t[0],
                                              0, &polled.lit.around);
    picture.next_caster = next_caster_until_stopped;
    picture.lit = &polled;
    return tia_exact_shade(&picture, one->x, one->y, one->object, (tia_q30)threshold, one->colours, one->path_hash);
}
