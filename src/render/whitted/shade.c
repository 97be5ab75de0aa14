#include "shade.h"

#include "footprint.h"
#include "observe.h"
#include "samples/sobol.h"
#include "scene/colour.h"

void path_hash_word(struct path *path, uint32_t word)
{
    for (int i = 0; path->hashed && i < 4; i++)
        path->hash = (path->hash ^ (word >> (8 * i) & 0xff)) * UINT32_C(16777619);
}

void shade_prepare(struct path *path, const struct ray *ray, const struct hit *hit, struct shading *s)
{
    path_hash_word(path, hit->object);
    path_hash_word(path, hit->element);
    shading_prepare(path->view, path->view->bias, ray, hit, s);
    if (TIA_FOOTPRINTS && path->view->filtered)
        footprint_filter(path, ray, hit, s);
    for (int i = 0; i < 2; i++)
        if (s->textured[i])
            path_hash_word(path, s->texels[i]);
}

/* Returns max(0, R.L)^exponent with R = 2 (N.V) N - V. */
static num_length highlight(const struct shading *s, struct num_dir to, num_unit lambert)
{
    num_unit half = num_times(s->facing, lambert) - num_dir_dot(s->viewer, to) / 2;

    if (half <= 0)
        return 0;
    return num_power_length(half < NUM_UNIT_ONE / 2 ? 2 * half : NUM_UNIT_ONE, s->material->exponent);
}

/* Computes the part of the light from `to` that the material reflects towards the viewer. */
static void reflectance(const struct shading *s, struct num_dir to, num_unit lambert, num_length rgb[3])
{
    const struct tia_rgb *specular = &s->material->specular;
    num_length glossy[3], shine;

    for (int c = 0; c < 3; c++)
        rgb[c] = num_times(s->colour[c], lambert);
    if (colour_is_black(specular))
        return;
    ray_rgb(specular, glossy);
    shine = highlight(s, to, lambert);
    for (int c = 0; c < 3; c++)
        rgb[c] += num_product(glossy[c], shine);
}

/* Computes the part of a sample's light that reaches the point. Returns false if none does. `bit` is the sample's
 * number in path->lit. */
static bool arrives(const struct path *path, const struct shading *s, const struct ray_light *light,
                    const struct ray_sample *sample, unsigned bit, uint32_t *blocker, num_length through[3])
{
    struct ray shadow;
    num_length distance;

    if (path->known && !(path->lit.bits >> bit & 1))
        return false;
    bool partly = path->known && path->lit.shares;
    num_length part = partly ? num_length_of_q45((int64_t)path->lit.shares[bit] << 30) : NUM_LENGTH_ONE;
    through[0] = through[1] = through[2] = part;
    if ((path->known && !path->first->passes) || !ray_light_shadow(light, sample, s->outside, &shadow, &distance))
        return true;
    observe_count(path, &shadow);
    return path->known ? path->first->passes(path->first, &shadow, distance, blocker)
                       : ray_transmittance(path->view, &shadow, distance, blocker, through);
}

static bool is_white(const num_length rgb[3])
{
    return rgb[0] == NUM_LENGTH_ONE && rgb[1] == NUM_LENGTH_ONE && rgb[2] == NUM_LENGTH_ONE;
}

/* Multiplies a colour by a factor. A white factor, which is frequent, changes nothing and is skipped. */
static void multiply(num_length rgb[3], const num_length factor[3])
{
    for (int c = 0; c < 3 && !is_white(factor); c++)
        rgb[c] = num_product(rgb[c], factor[c]);
}

/* Adds the light of sample i, not yet multiplied by the emission, to the mean of the samples. Returns false if none
 * arrives. */
static bool add_sample(struct path *path, const struct shading *s, const struct ray_aim *aim, unsigned i, unsigned bit,
                       uint32_t *blocker, num_length mean[3])
{
    struct ray_sample sample;
    num_length through[3], rgb[3];

    if (!ray_light_sample(aim, i, &sample))
        return false;
    num_unit lambert = num_dir_dot(s->normal, sample.to);
    if (lambert <= 0 || num_dir_dot(s->geometric, sample.to) <= 0)
        return false;
    bool reached = arrives(path, s, aim->light, &sample, bit, blocker, through);
    if (path_is_watched(path))
        observe_shadow(path, &(struct observed_shadow){s->object, s->outside, s->normal, aim->light, &sample, reached});
    if (!reached)
        return false;
    reflectance(s, sample.to, lambert, rgb);
    multiply(rgb, through);
    for (int c = 0; c < 3; c++) {
        num_length faded = sample.factor == NUM_LENGTH_ONE ? rgb[c] : num_product_within(rgb[c], sample.factor);
        mean[c] += aim->light->samples == 1 ? faded : num_times(faded, 32 * aim->light->part);
    }
    return true;
}

static void note_reached(struct path *path, bool reached)
{
    if (path->next_reached < PATH_REACHED)
        path->reached |= (uint64_t)reached << path->next_reached++;
}

/* Returns the part of an ambient light that reaches the point: all of it or, if the light has a radius, the mean
 * openness of rays of that length. */
static num_length ambient_part(struct path *path, const struct shading *s, const struct ray_light *light, uint32_t n)
{
    const struct ray_place place = {s->outside, s->geometric, s->normal};
    num_length sum = 0;

    if (!(light->radius > 0))
        return NUM_LENGTH_ONE;
    for (unsigned i = 0; i < light->samples && !path_stops(path); i++) {
        const struct sampler sampler = {path->seed, i};
        uint32_t u[2];

        sampler_pair(&sampler, n, 0, u);
        num_length open = ray_openness(path->view, &place, u, light->radius, &path->blocker[n % PATH_BLOCKERS]);
        path_hash_word(path, open > 0);
        sum += open;
    }
    return num_ratio(sum, num_integer((int32_t)light->samples));
}

static void add_light(struct path *path, const struct shading *s, uint32_t n, num_length own[3])
{
    const struct ray_light *light = &path->view->lights[n];
    uint32_t *blocker = &path->blocker[n % PATH_BLOCKERS];
    unsigned bit = path->known ? path->first->first_bit[n] : 0, step = path->known && !path->first->whole;
    num_length mean[3] = {0, 0, 0};
    struct ray_aim aim;

    if (tia_light_has(light->kind, TIA_LIGHT_EVERYWHERE)) {
        num_length part = ambient_part(path, s, light, n);
        for (int c = 0; c < 3; c++) {
            num_length sent = part < NUM_LENGTH_ONE ? num_product(light->emission[c], part) : light->emission[c];
            own[c] = num_sum_within(own[c], num_product(s->colour[c], sent));
        }
        return;
    }
    ray_light_aim(&aim, light, s->point, s->normal, path->class);
    for (unsigned i = 0; i < light->samples && !path_stops(path); i++) {
        bool reached = add_sample(path, s, &aim, i, bit + step * i, blocker, mean);
        path_hash_word(path, reached);
        note_reached(path, reached);
    }
    for (int c = 0; c < 3; c++)
        own[c] = num_sum_within(own[c], num_product_within(mean[c], light->emission[c]));
}

void shade_light(struct path *path, const struct shading *s, const num_length throughput[3], num_length colour[3])
{
    num_length own[3], facing[3];

    if (s->opacity == 0)
        return;
    ray_rgb(&s->material->emission, own);
    ray_rgb(&s->material->facing, facing);
    for (int c = 0; c < 3 && s->facing > 0; c++)
        own[c] += num_times(facing[c], s->facing);
    for (uint32_t n = 0; n < path->view->light_count; n++)
        add_light(path, s, n, own);
    for (int c = 0; c < 3; c++) {
        if (s->opacity < NUM_LENGTH_ONE)
            own[c] = num_product_within(own[c], s->opacity);
        if (throughput[c] != NUM_LENGTH_ONE)
            own[c] = num_product_within(own[c], throughput[c]);
        colour[c] = num_sum_within(colour[c], own[c]);
    }
}

static struct ray straight_on(const struct ray_view *view, const struct shading *s)
{
    return (struct ray){.origin = num_point_at(s->point, s->viewer, -view->bias),
                        .direction = num_dir_negated(s->viewer)};
}

/* Sets the refracted ray. Returns the reflected part of the light. */
static num_unit pass(const struct ray_view *view, const struct shading *s, struct bounces *b)
{
    const struct tia_material *m = s->material;
    struct boundary between = media_cross(view, &b->media, s->object, m, s->back);

    b->between = between;
    b->straight = between.from == between.to || colour_is_black(&m->refraction);
    b->refracted = straight_on(view, s);
    if (b->straight)
        return 0;
    b->refracted.origin = num_point_at(s->point, s->geometric, -view->bias);
    num_unit fresnel = shading_refract(s, between, &b->refracted.direction);
    return m->fresnel || fresnel == NUM_UNIT_ONE ? fresnel : 0;
}

/* Sets the undeflected ray behind the surface, and multiplies the factors of the other rays by the opacity. */
static void let_past(const struct ray_view *view, const struct shading *s, struct bounces *b)
{
    num_length *passes = b->straight ? b->refracts : b->passes;

    b->past = straight_on(view, s);
    for (int c = 0; c < 3; c++) {
        b->reflects[c] = num_product(b->reflects[c], s->opacity);
        b->refracts[c] = num_product(b->refracts[c], s->opacity);
        passes[c] += NUM_LENGTH_ONE - s->opacity;
    }
}

static bool is_zero(const num_length rgb[3])
{
    return rgb[0] == 0 && rgb[1] == 0 && rgb[2] == 0;
}

void shade_bounce(const struct ray_view *view, const struct shading *s, const struct media *media, struct bounces *b)
{
    const struct tia_material *m = s->material;

    ray_rgb(&m->mirror, b->reflects);
    ray_rgb(&m->refraction, b->refracts);
    b->media = *media;
    b->straight = false;
    b->passes[0] = b->passes[1] = b->passes[2] = 0;
    if (!colour_is_black(&m->refraction) || s->opacity < NUM_LENGTH_ONE) {
        num_unit fresnel = pass(view, s, b);
        for (int c = 0; c < 3; c++) {
            num_length back = num_times(b->refracts[c], fresnel);
            b->reflects[c] += back;
            b->refracts[c] -= back;
        }
    }
    if (s->opacity < NUM_LENGTH_ONE)
        let_past(view, s, b);
    if (is_zero(b->reflects))
        return;
    b->reflected.origin = s->outside;
    b->reflected.direction = shading_mirrored(s);
}
