/* path.c - the radiance along a ray, one path per sample; see tia/integrator.h. */
#include "path.h"

#include "guide.h"
#include "math/align.h"
#include "render/trace/fog.h"
#include "scatter.h"

/* A path being followed. */
struct walk {
    struct estimate *e;
    const struct path_view *view;
    struct ray ray;
    struct num_point from;      /* position of the last scattering */
    struct num_density density; /* density of the direction at the last scattering */
    bool specular;              /* the last scattering had a single direction, or was at the eye: it sampled no light */
    num_length throughput[3], sum[3];
    num_length depth; /* length of the path to the last scattering, while only mirrors and glass were met */
    struct media media;
    uint32_t bounce, layers;
};

static uint32_t quad_of(const struct walk *w, unsigned which)
{
    return PATH_QUAD(w->bounce, which);
}

static void draw_direction(const struct walk *w, uint32_t u[2])
{
    sampler_pair(&w->e->sampler, w->bounce ? quad_of(w, 0) : ESTIMATE_FIRST_QUAD, 2, u);
}

/* Returns the random number of one of a bounce's choices, see PATH_QUAD. */
static uint32_t draw_choice(const struct walk *w, enum path_choice choice)
{
    const struct sampler_quad quad = sampler_quad(&w->e->sampler, quad_of(w, 1));

    return sampler_number(&quad, choice);
}

static void add(struct walk *w, const num_length radiance[3], num_unit weight)
{
    for (int c = 0; c < 3; c++) {
        num_length part = num_times(num_product_within(w->throughput[c], radiance[c]), weight);
        w->sum[c] = num_sum_within(w->sum[c], part);
    }
}

static void multiply(struct walk *w, const num_length factor[3])
{
    for (int c = 0; c < 3; c++)
        w->throughput[c] = num_product_within(w->throughput[c], factor[c]);
}

static unsigned left_out(const struct walk *w)
{
    return w->e->view->scene->integration.without;
}

/* Returns the balance heuristic's weight of an emitter that the path meets. */
static num_unit weight_of(const struct walk *w, const struct emitter *emitter, num_length t)
{
    if (w->specular || left_out(w) == TIA_STRATEGY_LIGHTS)
        return NUM_UNIT_ONE;
    if (left_out(w) == TIA_STRATEGY_SCATTERING)
        return 0;
    struct num_point way = num_point_sub(num_point_at(w->ray.origin, w->ray.direction, t), w->from);
    struct num_density chosen = emitter_density(emitter, w->from, w->ray.direction, num_norm(way));
    if (num_density_share(chosen, w->density) == 0)
        return NUM_UNIT_ONE;
    return num_density_share(w->density, num_density_product(chosen, w->view->emitters.one_of));
}

static void add_light(struct walk *w, const struct hit *hit, const struct emitter *emitter)
{
    bool is_surface = PATH_SURFACES >> w->e->view->lights[hit->light].kind & 1;

    estimate_note(w->e, TIA_NO_OBJECT - 1 - hit->light);
    add(w, emitter->radiance, is_surface ? weight_of(w, emitter, hit->t) : NUM_UNIT_ONE);
}

/* Returns the length of the path from the eye to the point `at`, via mirrors and glass. */
static num_length depth_at(const struct walk *w, struct num_point at)
{
    return num_sum_within(w->depth, num_norm(num_point_sub(at, w->from)));
}

/* Adds the light that the ray meets, or the background, if the ray meets no surface. */
static void add_beyond(struct walk *w, const struct hit *hit)
{
    const struct num_dir back = num_dir_negated(w->ray.direction);
    num_length background[3];
    struct emitter emitter;

    if (hit->light != TIA_NO_OBJECT) {
        emitter_of_light(&w->e->view->lights[hit->light], &w->e->view->view->lights[hit->light], &emitter);
        if (w->e->guide)
            guide_add(w->e, w->throughput, emitter.radiance, &back,
                      depth_at(w, num_point_at(w->ray.origin, w->ray.direction, hit->t)));
        add_light(w, hit, &emitter);
        return;
    }
    ray_rgb(&w->e->view->scene->background, background);
    guide_add(w->e, w->throughput, background, NULL, 0);
    add(w, background, NUM_UNIT_ONE);
}

/* Adds the surface's own emission. */
static void add_glow(struct walk *w, const struct hit *hit, const struct shading *s)
{
    const struct tia_scene *scene = w->e->view->scene;
    struct emitter emitter;
    num_length glow[3], facing[3];

    if (!guide_glows(s, glow, facing))
        return;
    if (glow[0] > 0 || glow[1] > 0 || glow[2] > 0) {
        bool is_sphere = hit->object < scene->sphere_count;
        if (is_sphere)
            emitter_of_sphere(scene, hit->object, &emitter);
        add(w, glow, is_sphere ? weight_of(w, &emitter, hit->t) : NUM_UNIT_ONE);
    }
    if (s->facing > 0 && (facing[0] > 0 || facing[1] > 0 || facing[2] > 0))
        add(w, facing, s->facing);
}

/* True if the light at the end of the shadow ray is visible. Multiplies the sample's radiance by the part that opacity
 * textures let pass. */
static bool is_seen(struct walk *w, const struct ray *shadow, struct emitter_sample *sample)
{
    struct hit light = {sample->distance, TIA_NO_OBJECT, 0, TIA_NO_OBJECT};
    num_length through = NUM_LENGTH_ONE;
    bool seen;

    if (!estimate_recalls(w->e, &seen)) {
        ray_intersect_lights_of(w->e->view, shadow, PATH_SURFACES, &light);
        seen = light.light == TIA_NO_OBJECT &&
               ray_visibility(w->e->view, shadow, sample->distance, &w->e->blocker, &through);
    }
    estimate_note(w->e, seen);
    (void)estimate_stops(w->e);
    for (int c = 0; seen && through < NUM_LENGTH_ONE && c < 3; c++)
        sample->radiance[c] = num_product_within(sample->radiance[c], through);
    return seen;
}

/* Chooses an emitter at random. */
static const struct emitter *choose_emitter(const struct walk *w, const struct emitters *emitters)
{
    uint32_t number = emitters->count > 1 ? draw_choice(w, CHOICE_LIGHT) : 0;

    return &emitters->first[(uint64_t)number * emitters->count >> 32];
}

/* Samples an emitter, and adds its reflected light: reflectance times radiance, divided by the sum of the densities
 * with which the path could have chosen the sampled point. */
static void look_for_light(struct walk *w, const struct scatter *scatter)
{
    const struct emitters *emitters = &w->view->emitters;
    const struct shading *s = scatter->surface;
    struct emitter_sample sample;
    struct num_density density, scattered;
    num_length reflected[3], part[3];
    uint32_t u[2];
    bool seen;

    if (!emitters->count || left_out(w) == TIA_STRATEGY_LIGHTS || (estimate_recalls(w->e, &seen) && !seen))
        return;
    sampler_pair(&w->e->sampler, quad_of(w, 0), 0, u);
    const struct emitter *emitter = choose_emitter(w, emitters);
    if (!emitter_sample(emitter, s->outside, s->normal, w->e->bias, u, &sample))
        return;
    num_unit cosine = num_dir_dot(sample.to, s->normal);
    const struct ray shadow = {.origin = s->outside, .direction = sample.to};
    if (cosine <= 0 || num_dir_dot(sample.to, s->geometric) <= 0 || !is_seen(w, &shadow, &sample))
        return;
    scatter_evaluate(scatter, sample.to, cosine, reflected, &scattered);
    density = emitters->one_of;
    if (emitter->kind != EMITTER_POINT) {
        density = num_density_product(sample.density, density);
        if (left_out(w) != TIA_STRATEGY_SCATTERING)
            density = num_density_sum(density, scattered);
    }
    for (int c = 0; c < 3; c++)
        part[c] = num_product_within(num_density_over(reflected[c], density), sample.radiance[c]);
    add(w, part, NUM_UNIT_ONE);
}

/* Divides the throughput by the probability of the path's choice. */
static void divide(struct walk *w, num_unit probability)
{
    for (int c = 0; probability < NUM_UNIT_ONE && c < 3; c++)
        w->throughput[c] = num_div(w->throughput[c], probability);
}

static void go_on(struct walk *w, struct num_point origin, struct num_dir to, bool specular)
{
    if (w->e->guide)
        w->depth = depth_at(w, origin);
    w->ray = (struct ray){.origin = origin, .direction = to};
    w->from = origin;
    w->specular = specular;
    w->bounce++;
}

/* Passes through glass, or reflects from it by Fresnel's equations. Returns false after too many undeflected
 * passages. */
static bool go_through(struct walk *w, const struct scatter *scatter)
{
    const struct shading *s = scatter->surface;
    struct media media = w->media;
    struct boundary between = media_cross(w->e->view, &media, s->object, s->material, s->back);
    struct num_dir to;

    multiply(w, scatter->refraction);
    divide(w, scatter_chance(scatter, LOBE_GLASS));
    if (between.from == between.to) {
        w->media = media;
        go_on(w, num_point_at(s->point, s->viewer, -w->e->bias), num_dir_negated(s->viewer), true);
        w->bounce--;
        return ++w->layers <= TIA_LAYERS_MAX;
    }
    num_unit fresnel = shading_refract(s, between, &to);
    bool reflected = fresnel == NUM_UNIT_ONE ||
                     (s->material->fresnel && num_happens(num_chance(fresnel), draw_choice(w, CHOICE_REFLECTION)));
    estimate_note(w->e, reflected);
    if (!reflected)
        w->media = media;
    go_on(w, reflected ? s->outside : num_point_at(s->point, s->geometric, -w->e->bias),
          reflected ? scatter->mirrored : to, true);
    return true;
}

/* Continues the path from a surface. Returns false if it ends there. */
static bool bounce(struct walk *w, const struct scatter *scatter)
{
    const struct shading *s = scatter->surface;
    enum lobe lobe = scatter_choose(scatter, scatter->below[2] ? draw_choice(w, CHOICE_LOBE) : 0);
    num_length factor[3];
    struct num_dir to;
    uint32_t u[2];

    estimate_note(w->e, lobe);
    if (lobe == LOBE_GLASS)
        return go_through(w, scatter);
    if (lobe == LOBE_MIRROR) {
        multiply(w, scatter->mirror);
        divide(w, scatter_chance(scatter, LOBE_MIRROR));
        go_on(w, s->outside, scatter->mirrored, true);
        return true;
    }
    draw_direction(w, u);
    if (lobe == LOBE_NONE || !scatter_sample(scatter, lobe, u, &to, factor, &w->density))
        return false;
    multiply(w, factor);
    go_on(w, s->outside, to, false);
    return true;
}

/* Plays Russian roulette. Returns false if the path ends. */
static bool survives(struct walk *w)
{
    num_length most = w->throughput[0];

    if (w->bounce < PATH_ROULETTE)
        return true;
    most = most > w->throughput[1] ? most : w->throughput[1];
    most = most > w->throughput[2] ? most : w->throughput[2];
    uint32_t chance = most < NUM_LENGTH_ONE ? num_chance(num_fraction(most, NUM_LENGTH_ONE)) : UINT32_MAX;
    bool goes_on = num_happens(chance, draw_choice(w, CHOICE_SURVIVAL));
    estimate_note(w->e, goes_on);
    if (goes_on)
        divide(w, num_of_chance(chance));
    return goes_on;
}

/* Adds the fog along a ray whose end is seen from the eye, in a mirror or through glass. */
static void add_fog(struct walk *w, const struct hit *hit)
{
    const struct tia_fog *fog = w->e->view->scene->fog;

    if (fog && w->specular && !w->media.count)
        ray_fog_veil(fog, &w->ray, hit, w->throughput, w->sum);
}

/* Follows one ray, and adds the light at its end. Returns false if the path ends there. */
static bool step(struct walk *w)
{
    uint32_t given = w->e->view->scene->integration.bounces;
    struct hit hit;
    struct shading s;
    struct scatter scatter;

    bool meets = estimate_meet(w->e, &w->ray, w->specular ? PATH_SEEN : PATH_SURFACES, &hit, &s);
    add_fog(w, &hit);
    if (!meets) {
        add_beyond(w, &hit);
        return false;
    }
    add_glow(w, &hit, &s);
    scatter_prepare(&scatter, &s);
    if (w->e->guide)
        guide_add_surface(w->e, w->throughput, &scatter, depth_at(w, s.point));
    if (scatter.black || w->bounce >= (given ? given : TIA_BOUNCES_MAX) || !survives(w))
        return false;
    if (scatter.rough)
        look_for_light(w, &scatter);
    return bounce(w, &scatter) && (w->throughput[0] > 0 || w->throughput[1] > 0 || w->throughput[2] > 0);
}

const struct path_view *path_view_of(const struct tia_view *view)
{
    size_t before = ALIGN(ray_prepared_size(view->scene, view->light_capacity));

    return (const struct path_view *)(const void *)((const char *)view->prepared + before);
}

void path_radiance(struct estimate *e, const struct ray *first, num_length rgb[3])
{
    struct walk w = {.e = e,
                     .view = path_view_of(e->view->view),
                     .ray = *first,
                     .from = first->origin,
                     .specular = true,
                     .throughput = {NUM_LENGTH_ONE, NUM_LENGTH_ONE, NUM_LENGTH_ONE}};

    while (step(&w) && !e->stopped)
        ;
    for (int c = 0; c < 3; c++)
        rgb[c] = w.sum[c];
}

static size_t prepared_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t rays = ray_prepared_size(scene, light_capacity);
    uint64_t size = ALIGN(rays) + ALIGN(sizeof(struct path_view)) + emitters_size(scene, light_capacity);

    return rays < SIZE_MAX / 2 && size < SIZE_MAX / 2 ? (size_t)size : SIZE_MAX;
}

static int prepare(struct tia_view *view)
{
    int status = ray_prepare(view);
    struct path_view *path = (struct path_view *)(void *)(uintptr_t)path_view_of(view);

    if (status)
        return status;
    return emitters_prepare(&path->emitters, view->prepared, (char *)path + ALIGN(sizeof *path));
}

static int set_lights(struct tia_view *view)
{
    struct path_view *path = (struct path_view *)(void *)(uintptr_t)path_view_of(view);
    int status = ray_set_lights(view);

    if (!status)
        emitters_set(&path->emitters, view->prepared);
    return status;
}

static void light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    (void)hits;
    estimate_light_tile(view, tile, surface, options, path_radiance);
}

static void sample_tile(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                        const struct tia_gathered *gathered)
{
    estimate_sample_tile(view, tile, first, end, gathered, path_radiance);
}

static bool draws(const struct tia_scene *scene)
{
    return scene->integration.integrator == TIA_PATHS;
}

const struct renderer path_renderer = {
    .draws = draws,
    .prepared_size = prepared_size,
    .prepare = prepare,
    .set_lights = set_lights,
    .trace = ray_trace_tile,
    .light = light_tile,
    .by_pixel = true,
    .part = SIMD_SAMPLES,
    .sample = sample_tile,
};
