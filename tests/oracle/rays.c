#include "rays.h"

#include "light.h"
#include "media.h"

#define FAINT (1.0 / 65536.0)

/* State of a sample. */
struct look {
    const struct tia_scene *scene;
    unsigned pixel_class;
    uint32_t path; /* FNV-1a hash of the hits */
    uint32_t rays; /* number of rays of the sample so far */
};

/* History of a ray: the product of its factors; the numbers of bends and of straight layers so far; and the media that
 * contain it. */
struct way {
    struct colour weight;
    unsigned bounces, layers;
    struct media media;
};

/* A hit, prepared for shading. */
struct surface {
    const struct tia_material *material;
    struct oracle_vec p, g, n, v; /* the point, the normals and the direction to the viewer */
    double cosine;                /* N.V */
    struct colour colour;         /* diffuse colour with its texture */
    double opacity;
    bool front;
    uint32_t object;
    uint32_t cell, opaque_cell; /* texels of the two textures */
};

static struct colour trace(struct look *look, struct ray ray, const struct way *way);

static void feed(uint32_t *path, uint32_t word)
{
    for (int i = 0; i < 4; i++)
        *path = (*path ^ (word >> 8 * i & 255)) * UINT32_C(16777619);
}

/* Adds s b to a. */
static void add(struct colour *a, double s, struct colour b)
{
    for (int i = 0; i < 3; i++)
        a->channel[i] += s * b.channel[i];
}

static bool is_faint(struct colour c)
{
    return c.channel[0] < FAINT && c.channel[1] < FAINT && c.channel[2] < FAINT;
}

/* Returns the nearest object, the lower index on a tie; hit->t is infinite if there is none. */
static uint32_t nearest_object(const struct tia_scene *scene, struct ray ray, struct hit *hit)
{
    uint32_t nearest = TIA_NO_OBJECT;
    struct hit h;

    *hit = (struct hit){.t = INFINITY};
    for (uint32_t i = 0; i < scene->sphere_count + scene->shape_count; i++)
        if (object_hit(scene, i, ray, &h) && h.t < hit->t) {
            *hit = h;
            nearest = i;
        }
    return nearest;
}

/* Returns the nearest light whose surface the ray meets before `distance`, or TIA_NO_OBJECT. */
static uint32_t nearest_light(const struct tia_scene *scene, struct ray ray, double distance)
{
    uint32_t nearest = TIA_NO_OBJECT;
    double t;

    for (uint32_t i = 0; i < scene->light_count; i++)
        if (light_hit(&scene->lights[i], ray, &t) && t < distance) {
            distance = t;
            nearest = i;
        }
    return nearest;
}

/* Returns max(0, R.L)^exponent, R being V's mirror image. */
static double highlight(const struct surface *s, struct oracle_vec l)
{
    struct oracle_vec r = along(scaled(s->v, -1), 2.0 * s->cosine, s->n);
    double cosine = dot(r, l);

    return cosine > 0 ? pow(cosine, q16(s->material->exponent)) : 0.0;
}

/* Adds the light of one beam to *sum. True if any light arrives. */
static bool add_beam(const struct look *look, const struct tia_light *light, const struct beam *beam,
                     const struct surface *s, struct colour *sum)
{
    double cosine = dot(s->n, beam->direction);

    if (!(dot(s->g, beam->direction) > 0) || !(cosine > 0) || !(beam->strength > 0))
        return false;
    struct ray shadow = {along(s->p, oracle_bias(look->scene), s->g), beam->direction};
    double distance = INFINITY;
    if (!isinf(beam->distance)) {
        struct oracle_vec way = sub(beam->source, shadow.origin);
        distance = length(way);
        shadow.direction = divide(way, distance);
    }
    struct colour left = distance > 0 ? oracle_transmission(look->scene, shadow, distance) : (struct colour){{1, 1, 1}};
    struct colour arrives = product(left, rgb(light->emission));
    add(sum, beam->strength * cosine, product(arrives, s->colour));
    if (!is_black(rgb(s->material->specular)))
        add(sum, beam->strength * highlight(s, beam->direction), product(arrives, rgb(s->material->specular)));
    return !is_black(left);
}

static void add_lights(struct look *look, const struct surface *s, struct colour *sum)
{
    for (uint32_t i = 0; i < look->scene->light_count; i++) {
        const struct tia_light *light = &look->scene->lights[i];
        if (light->kind == TIA_AMBIENT_LIGHT) {
            add(sum, 1, product(s->colour, rgb(light->emission)));
            continue;
        }
        for (unsigned k = 0; k < light_samples(light); k++) {
            struct beam beam;
            feed(&look->path,
                 light_beam(light, ldexp(1, (int)look->scene->scale_bits), s->p, look->pixel_class, k, &beam) &&
                     add_beam(look, light, &beam, s, sum));
        }
    }
}

double oracle_fresnel(double cosine, double n1, double n2)
{
    double ci = cosine > 0 ? cosine : 0, square = 1 - n1 / n2 * (n1 / n2) * (1 - ci * ci);

    if (square < 0)
        return 1;
    double ct = sqrt(square);
    double rs = (n1 * ci - n2 * ct) / (n1 * ci + n2 * ct), rp = (n1 * ct - n2 * ci) / (n1 * ct + n2 * ci);
    return (rs * rs + rp * rp) / 2;
}

/* Computes the refracted direction by Snell's law, for the ratio n1/n2. Returns false in total reflection, and if the
 * interpolated normal points away from the viewer. */
static bool refract(const struct surface *s, double ratio, struct oracle_vec *way)
{
    double square = 1 - ratio * ratio * (1 - s->cosine * s->cosine);

    if (s->cosine <= 0 || square < 0)
        return false;
    *way = along(scaled(s->v, -ratio), ratio * s->cosine - sqrt(square), s->n);
    return true;
}

/* Adds the colour along `ray`, whose direction may have any length. */
static void add_ray(struct look *look, struct ray ray, struct colour factor, struct way way, struct colour *sum)
{
    unsigned depth = look->scene->depth == 0 ? TIA_DEPTH_DEFAULT : look->scene->depth;

    way.weight = product(way.weight, factor);
    if (way.bounces > depth || way.layers > TIA_LAYERS_MAX || is_faint(way.weight))
        return;
    ray.direction = unit(ray.direction);
    add(sum, 1, product(factor, trace(look, ray, &way)));
}

/* Computes the refracted ray and its history. Moves the fraction F of the refraction from kt to kr. */
static void bend(const struct tia_scene *scene, const struct surface *s, struct way *way, struct ray *ray,
                 struct colour *kr, struct colour *kt)
{
    const struct tia_material *m = s->material;
    struct crossing c = media_cross(scene, &way->media, s->object, s->front, m);
    double n1 = q16(c.from), n2 = q16(c.to);

    if (c.from == c.to || is_black(rgb(m->refraction))) {
        *ray = (struct ray){along(s->p, -oracle_bias(scene), s->v), scaled(s->v, -1)};
        way->layers++;
        return;
    }
    way->bounces++;
    bool passes = refract(s, n1 / n2, &ray->direction);
    double f = !passes ? 1 : m->fresnel ? oracle_fresnel(s->cosine, n1, n2) : 0;
    add(kr, f, rgb(m->refraction));
    add(kt, -f, rgb(m->refraction));
}

static void add_secondary(struct look *look, const struct surface *s, const struct way *way, struct colour *sum)
{
    struct ray mirrored = {along(s->p, oracle_bias(look->scene), s->g), along(scaled(s->v, -1), 2.0 * s->cosine, s->n)};
    struct ray on = {along(s->p, -oracle_bias(look->scene), s->g), {0, 0, 0}};
    struct colour kr = rgb(s->material->mirror), kt = rgb(s->material->refraction);
    struct way reflected = *way, refracted = *way, past = *way;

    reflected.bounces++;
    if (!is_black(kt) || s->opacity < 1)
        bend(look->scene, s, &refracted, &on, &kr, &kt);
    bool straight = refracted.layers > way->layers;
    double o = s->opacity;
    add_ray(look, mirrored, product(grey(o), kr), reflected, sum);
    add_ray(look, on, straight ? mixed(o, kt) : product(grey(o), kt), refracted, sum);
    if (straight || !(o < 1))
        return;
    past.layers++;
    past.media = refracted.media;
    add_ray(look, (struct ray){along(s->p, -oracle_bias(look->scene), s->v), scaled(s->v, -1)}, grey(1 - o), past, sum);
}

/* Returns the colour of the material's texture at a hit. */
static struct colour textured(const struct tia_texture *t, const struct hit *hit, uint32_t *cell)
{
    if (t->kind != TIA_NOISE)
        return oracle_texture(t, hit->u, hit->v, cell);
    double high = fmin(1, fmax(0, oracle_noise(t, hit->own)));
    struct colour sum = {{0, 0, 0}};
    add(&sum, 1 - high, rgb(t->cells[0]));
    add(&sum, high, rgb(t->cells[1]));
    return sum;
}

static struct surface surface_at(const struct tia_scene *scene, struct ray ray, uint32_t object, const struct hit *hit)
{
    struct surface s = {.material = &scene->materials[hit->material], .p = at(ray, hit->t), .object = object};

    s.v = scaled(ray.direction, -1);
    s.front = dot(hit->normal, s.v) >= 0;
    s.g = scaled(hit->normal, s.front ? 1 : -1);
    s.n = scaled(hit->smooth, s.front ? 1 : -1);
    s.cosine = dot(s.n, s.v);
    s.colour = rgb(s.material->colour);
    s.cell = ORACLE_BLENDED;
    if (s.material->texture != 0 && !is_black(s.colour))
        s.colour = product(s.colour, textured(&scene->textures[s.material->texture - 1], hit, &s.cell));
    s.opacity = oracle_opacity(scene, hit, &s.opaque_cell);
    return s;
}

static struct colour shade(struct look *look, struct ray ray, uint32_t object, const struct hit *hit,
                           const struct way *way)
{
    struct surface s = surface_at(look->scene, ray, object, hit);
    struct colour sum = rgb(s.material->emission);

    feed(&look->path, hit->part);
    if (s.cell != ORACLE_BLENDED)
        feed(&look->path, s.cell);
    if (s.opaque_cell != ORACLE_BLENDED)
        feed(&look->path, s.opaque_cell);
    add(&sum, s.cosine > 0 ? s.cosine : 0, rgb(s.material->facing));
    if (s.opacity > 0)
        add_lights(look, &s, &sum);
    sum = product(grey(s.opacity), sum);
    add_secondary(look, &s, way, &sum);
    return sum;
}

/* Returns the integral of the fog's density from its level to a height above it. */
static double fog_below(const struct tia_fog *fog, double h)
{
    return h <= 0 ? h : q16(fog->height) * atan(h / q16(fog->height));
}

/* Returns the integral of the density up to t, which may be infinite. */
static double fog_along(const struct tia_fog *fog, struct ray ray, double t)
{
    double h = ray.origin.y - q16(fog->level), slope = ray.direction.y;

    if (fog->height == 0)
        return t;
    if (fabs(slope) * t < 1e-6 * q16(fog->height))
        return h <= 0 ? t : t / (1 + pow(h / q16(fog->height), 2));
    return (fog_below(fog, h + slope * t) - fog_below(fog, h)) / slope;
}

static double fog_share(const struct tia_fog *fog, struct ray ray, double t)
{
    if (isinf(t) && (fog->height == 0 || ray.direction.y <= 0))
        return 0;
    return exp(-fog_along(fog, ray, t) / q16(fog->distance));
}

static struct colour trace(struct look *look, struct ray ray, const struct way *way)
{
    const struct tia_fog *fog = look->scene->fog;
    struct way beyond = *way;
    struct hit hit;

    if (look->rays++ >= TIA_RAYS_MAX)
        return (struct colour){{0, 0, 0}};
    uint32_t object = nearest_object(look->scene, ray, &hit), light = nearest_light(look->scene, ray, hit.t);

    feed(&look->path, light == TIA_NO_OBJECT ? object : TIA_NO_OBJECT - 1 - light);
    if (light != TIA_NO_OBJECT)
        (void)light_hit(&look->scene->lights[light], ray, &hit.t);
    double share = fog && way->media.count == 0 ? fog_share(fog, ray, hit.t) : 1;
    struct colour sum = fog ? product(grey(1 - share), rgb(fog->colour)) : grey(0);
    beyond.weight = product(grey(share), way->weight);
    if (light != TIA_NO_OBJECT)
        add(&sum, share, rgb(look->scene->lights[light].emission));
    else if (object == TIA_NO_OBJECT)
        add(&sum, share, rgb(look->scene->background));
    else
        add(&sum, share, shade(look, ray, object, &hit, &beyond));
    return sum;
}

/* Returns the colour along a ray from the eye. */
static struct colour see(struct look *look, struct ray ray)
{
    const struct way way = {.weight = {{1, 1, 1}}};

    look->rays = 0;
    return trace(look, ray, &way);
}

struct colour oracle_ray(const struct tia_scene *scene, struct ray ray, unsigned x, unsigned y)
{
    struct look look = {scene, light_class(x, y), UINT32_C(2166136261), 0};

    return see(&look, ray);
}

/* Finds the first sample's hit, without shading it. */
static void see_first(const struct tia_scene *scene, struct ray ray, struct oracle_pixel *pixel)
{
    struct hit hit;

    pixel->sphere = nearest_object(scene, ray, &hit);
    uint32_t light = nearest_light(scene, ray, hit.t);
    pixel->object = light == TIA_NO_OBJECT ? pixel->sphere : scene->sphere_count + scene->shape_count + light;
    pixel->depth = hit.t;
    if (light != TIA_NO_OBJECT)
        (void)light_hit(&scene->lights[light], ray, &pixel->depth);
}

struct oracle_pixel oracle_rays_look(const struct tia_scene *scene, unsigned width, unsigned height, double x, double y)
{
    struct look look = {scene, light_class((unsigned)floor(x + 0.5), (unsigned)floor(y + 0.5)), UINT32_C(2166136261),
                        0};
    unsigned samples = scene->camera.samples == 0 ? 1 : scene->camera.samples;
    struct oracle_pixel pixel = {0};

    for (unsigned i = 0; i < samples; i++) {
        double dx, dy;
        oracle_sample(samples, i, &dx, &dy);
        struct ray ray = oracle_camera(&scene->camera, scene->fine, width, height, x + dx, y + dy);
        if (i == 0)
            see_first(scene, ray, &pixel);
        struct colour c = see(&look, ray);
        for (int k = 0; k < 3; k++)
            pixel.linear[k] += fmin(fmax(c.channel[k], 0), 1) / samples;
    }
    pixel.path_hash = look.path;
    return pixel;
}

static bool is_plain_material(const struct tia_material *m)
{
    return m->texture == 0 && m->opacity == 0 && is_black(rgb(m->specular)) && is_black(rgb(m->mirror)) &&
           is_black(rgb(m->refraction)) && is_black(rgb(m->facing));
}

static bool is_plain_light(const struct tia_light *l)
{
    return l->kind == TIA_POINT_LIGHT && l->constant == 0 && l->linear == 0 && l->quadratic == 0;
}

bool oracle_needs_rays(const struct tia_scene *scene)
{
    const struct tia_camera *camera = &scene->camera;
    bool plain = scene->shape_count == 0 && scene->sphere_count <= TIA_SPAN_SPHERES &&
                 camera->projection == TIA_PERSPECTIVE && !(length(position(camera->up)) > 0) && camera->samples <= 1;

    for (uint32_t i = 0; i < scene->material_count; i++)
        plain = plain && is_plain_material(&scene->materials[i]);
    for (uint32_t i = 0; i < scene->light_count; i++)
        plain = plain && is_plain_light(&scene->lights[i]);
    for (uint32_t i = 0; i < scene->binding_count; i++)
        plain = plain && is_plain_light(&scene->bindings[i].state);
    return !plain;
}
