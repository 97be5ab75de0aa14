/* ao.c - ambient occlusion: the openness of the visible points. */
#include "render/estimate/estimate.h"

static void radiance(struct estimate *e, const struct ray *first, num_length rgb[3])
{
    tia_q16 given = e->view->scene->integration.distance;
    struct ray ray = *first;
    struct hit hit;
    struct shading s;
    uint32_t u[2];

    rgb[0] = rgb[1] = rgb[2] = NUM_LENGTH_ONE;
    if (!estimate_meet(e, &ray, 0, &hit, &s)) {
        estimate_guide(e, rgb, NULL, 0);
        return;
    }
    if (e->guide)
        estimate_guide(e, rgb, &s.normal, num_norm(num_point_sub(s.point, first->origin)));
    const struct ray_place place = {s.outside, s.geometric, s.normal};
    sampler_pair(&e->sampler, ESTIMATE_FIRST_QUAD, 2, u);
    rgb[0] = ray_openness(e->view, &place, u, given ? num_length_of(given) : NUM_LENGTH_MAX, &e->blocker);
    rgb[1] = rgb[2] = rgb[0];
    estimate_note(e, rgb[0] > 0);
    (void)estimate_stops(e);
}

static void light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    (void)hits;
    estimate_light_tile(view, tile, surface, options, radiance);
}

static void sample_tile(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                        const struct tia_gathered *gathered)
{
    estimate_sample_tile(view, tile, first, end, gathered, radiance);
}

static bool draws(const struct tia_scene *scene)
{
    return scene->integration.integrator == TIA_OCCLUSION;
}

const struct renderer ao_renderer = {
    .draws = draws,
    .prepared_size = ray_prepared_size,
    .prepare = ray_prepare,
    .set_lights = ray_set_lights,
    .trace = ray_trace_tile,
    .light = light_tile,
    .by_pixel = true,
    .part = SIMD_SAMPLES,
    .sample = sample_tile,
};
