#include "estimate.h"

#include <tia/tone.h>

#include "render/core/dither.h"

#define PATIENCE 16 /* number of rays between two calls of `stop`, which may read a clock or a keyboard */
#define RADIANCE_MAX (16384 * NUM_LENGTH_ONE)
#define LAYER_QUAD UINT32_C(0x40000000) /* the first quad of random numbers for opacities */
#define ONE (INT64_C(1) << 24)
#define HASH UINT32_C(2166136261)

bool estimate_stops(struct estimate *e)
{
    if (!e->stopped && ++e->rays >= PATIENCE) {
        e->rays = 0;
        e->stopped = view_stops(e->view->view);
    }
    return e->stopped;
}

/* True if a ray passes the surface: a random choice with the probability 1 - opacity. */
static bool goes_past(struct estimate *e, const struct shading *s)
{
    uint32_t u[2];

    if (s->opacity >= NUM_LENGTH_ONE || e->layers >= TIA_LAYERS_MAX)
        return false;
    sampler_pair(&e->sampler, LAYER_QUAD + e->layers++, 0, u);
    return !num_happens(num_chance(num_fraction(s->opacity, NUM_LENGTH_ONE)), u[0]);
}

/* Computes the next hit if it is known what the ray meets. */
static bool recall(const struct estimate *e, uint32_t ray_number, const struct ray *ray, struct hit *hit)
{
    const struct estimate_known *known = e->known;

    if (!known || ray_number >= known->count)
        return false;
    ray_intersect_object(e->view, ray, known->hit[ray_number].object, hit);
    hit->light = known->hit[ray_number].light;
    return hit->light == TIA_NO_OBJECT ||
           ray_light_intersect(&e->view->lights[hit->light], ray, NUM_LENGTH_MAX, &hit->t);
}

static void find_hit(struct estimate *e, const struct ray *ray, unsigned lights, struct hit *hit)
{
    if (recall(e, e->met++, ray, hit))
        return;
    ray_intersect(e->view, ray, hit);
    if (lights)
        ray_intersect_lights_of(e->view, ray, lights, hit);
}

bool estimate_meet(struct estimate *e, struct ray *ray, unsigned lights, struct hit *hit, struct shading *s)
{
    for (;;) {
        find_hit(e, ray, lights, hit);
        estimate_note(e, hit->object);
        estimate_note(e, hit->element);
        if (hit->object == TIA_NO_OBJECT || estimate_stops(e))
            return false;
        shading_prepare(e->view, e->bias, ray, hit, s);
        if (!goes_past(e, s))
            return true;
        ray->origin = num_point_at(s->point, ray->direction, e->bias);
    }
}

void estimate_guide(struct estimate *e, const num_length albedo[3], const struct num_dir *normal, num_length depth)
{
    struct tia_guide *guide = e->guide;

    e->guide = NULL;
    if (!guide)
        return;
    for (int c = 0; c < 3; c++)
        guide->albedo[c] += num_q24(num_length_clamp(albedo[c], 0, RADIANCE_MAX));
    if (!normal)
        return;
    guide->depth += num_q24(depth / 256);
    guide->normal[0] += num_q24(num_length_of_unit(normal->x) + NUM_LENGTH_ONE) - ONE;
    guide->normal[1] += num_q24(num_length_of_unit(normal->y) + NUM_LENGTH_ONE) - ONE;
    guide->normal[2] += num_q24(num_length_of_unit(normal->z) + NUM_LENGTH_ONE) - ONE;
}

/* Computes sample number `index` of a channel's pixel `at`. */
static void sample_of(struct estimate *e, const struct light_pixel *at, uint32_t index, estimate_radiance *radiance,
                      num_length rgb[3])
{
    struct ray ray;
    uint32_t u[2];

    e->sampler = sampler_of(e->view->scene->integration.seed, at->x, at->y, index);
    e->layers = e->met = 0;
    sampler_pair(&e->sampler, ESTIMATE_FIRST_QUAD, 0, u);
    ray_camera_ray_within(&e->view->camera, at, index, u, &ray);
    radiance(e, &ray, rgb);
}

/* Adds sample number `index` of a pixel to the sum, and writes it to `rounded`, both in units of 2^-24. If there are
 * three channels, each has a separate ray. */
static void add_sample(struct estimate *e, int x, int y, uint32_t index, estimate_radiance *radiance,
                       struct tia_sum *sum, int64_t rounded[3])
{
    const struct ray_camera *camera = &e->view->camera;
    num_length rgb[3] = {0, 0, 0};

    for (int channel = 0; channel < camera->channels; channel++) {
        num_length all[3] = {0, 0, 0};
        struct light_pixel at;

        if (ray_camera_pixel(camera, x, y, channel, &at))
            sample_of(e, &at, index, radiance, all);
        for (int c = 0; c < 3; c++)
            rgb[c] = camera->channels == 1 || c == channel ? all[c] : rgb[c];
    }
    for (int c = 0; c < 3; c++) {
        rounded[c] = num_q24(num_length_clamp(rgb[c], 0, RADIANCE_MAX));
        sum->rgb[c] += rounded[c];
    }
}

static struct estimate begin(const struct tia_view *view)
{
    const struct ray_view *rays = view->prepared;

    return (struct estimate){.view = rays, .bias = num_ray_bias(rays->bias), .blocker = TIA_NO_OBJECT};
}

/* Adds samples first..end - 1 of pixel (x, y), which has the index `at` in the gathered arrays. */
static void add_samples(struct estimate *e, int x, int y, uint32_t first, uint32_t end,
                        const struct tia_gathered *gathered, size_t at, estimate_radiance *radiance)
{
    int64_t rounded[3];

    for (uint32_t i = first; i < end && !e->stopped; i++) {
        e->guide = gathered->guides ? &gathered->guides[at] : NULL;
        add_sample(e, x, y, i, radiance, &gathered->sums[at], rounded);
        if (gathered->squares)
            estimate_add_square(rounded, &gathered->squares[at]);
    }
}

void estimate_sample_tile(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                          const struct tia_gathered *gathered, estimate_radiance *radiance)
{
    struct estimate e = begin(view);

    for (int y = 0; y < (int)tile.height; y++)
        for (int x = 0; x < (int)tile.width; x++)
            add_samples(&e, (int)tile.x + x, (int)tile.y + y, first, end, gathered,
                        (size_t)y * gathered->pitch + (size_t)x, radiance);
}

void estimate_resume(const struct tia_view *view, int x, int y, uint32_t index, const struct estimate_known *known,
                     const struct tia_gathered *pixel, estimate_radiance *radiance)
{
    struct estimate e = begin(view);

    e.known = known;
    add_samples(&e, x, y, index, index + 1, pixel, 0, radiance);
}

/* Parameters of the conversion of a row's sums to pixels. */
struct packing {
    enum tia_tone tone;
    struct tia_exposure exposure;
    uint32_t spp;
    bool dither;
    num_u threshold[8];
};

/* Returns a sum's display level, 0..2^bits - 1. If dithered, it is computed from the 8-bit level. */
static unsigned level(const struct packing *p, int64_t sum, unsigned bits, int x)
{
    uint32_t value = tia_exposed(&p->exposure, sum, p->spp);

    if (!p->dither)
        return tia_tone_level(p->tone, value, bits);
    num_length shown = num_ratio(num_integer((int32_t)tia_tone_level(p->tone, value, 8)), num_integer(255));
    return num_levels(num_length_clamp(shown, 0, NUM_LENGTH_ONE), (1u << bits) - 1, p->threshold[x & 7]);
}

static tia_rgb565 pack(const struct packing *p, const struct tia_sum *sum, int x)
{
    return (tia_rgb565)(level(p, sum->rgb[0], 5, x) << 11 | level(p, sum->rgb[1], 6, x) << 5 |
                        level(p, sum->rgb[2], 5, x));
}

static struct packing packing_of(const struct tia_integration *how, uint32_t count, bool dither, int y)
{
    struct packing p = {tia_tone_of(how), tia_exposure_of(how->exposure), count, dither, {0}};

    dither_thresholds(dither, y, p.threshold);
    return p;
}

void estimate_light_tile(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                         const struct tia_options *options, estimate_radiance *radiance)
{
    const struct tia_integration *how = &view->scene->integration;
    const struct tia_debug debug = options_debug(options);
    struct estimate e = begin(view);

    for (int y = (int)tile.y; y < tile_bottom(tile); y++) {
        struct packing packing = packing_of(how, how->spp ? how->spp : TIA_SPP_DEFAULT, options->dither, y);
        char *out = (char *)surface->pixels + (y - (int)tile.y) * surface->pitch;

        for (int x = (int)tile.x; x < tile_right(tile) && !e.stopped; x++, out += surface->step) {
            size_t at = (size_t)(y - (int)tile.y) * tile.width + (size_t)(x - (int)tile.x);
            struct tia_sum sum = {{0, 0, 0}};
            int64_t rounded[3];
            e.hash = HASH;
            for (uint32_t i = 0; i < packing.spp && !e.stopped; i++)
                add_sample(&e, x, y, i, radiance, &sum, rounded);
            *(tia_rgb565 *)(void *)out = surface_order(surface, pack(&packing, &sum, x));
            if (debug.path_hash)
                debug.path_hash[at] = e.hash;
            if (debug.lit)
                debug.lit[at] = 0;
        }
    }
}

void estimate_show(const struct tia_view *view, struct tia_tile row, const struct tia_sum *sums, uint32_t count,
                   const struct tia_surface *surface, bool dither)
{
    struct packing packing = packing_of(&view->scene->integration, count, dither, (int)row.y);
    char *out = (char *)surface->pixels;

    for (int x = 0; x < (int)row.width; x++, out += surface->step)
        *(tia_rgb565 *)(void *)out = surface_order(surface, pack(&packing, &sums[x], (int)row.x + x));
}
