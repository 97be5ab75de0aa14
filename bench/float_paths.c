#include "float_paths.h"

#include <stdlib.h>

#define PI 3.14159265F

enum { ROULETTE = 3, BOUNCES_MAX = 1024 };

struct material {
    float colour[3], specular[3], mirror[3], emission[3], exponent;
    float below[2]; /* cumulative probabilities: of a mirror ray, and of a mirror ray or a glossy one */
    bool black;
};

struct light {
    bool plane;
    struct vec centre, side[2], normal;
    float area, emission[3];
};

struct float_paths {
    struct float_world world;
    struct material *materials;
    struct light *lights;
    uint32_t light_count;
    unsigned width, height;
    struct vec eye, ahead, right, up;
    float background[3];
};

struct path {
    const struct float_paths *scene;
    const struct float_meeting *meeting;
    struct float_ray ray;
    float throughput[3], sum[3], density; /* probability density of the ray, times pi; 0 if it comes from a mirror or
                                             the eye */
    unsigned bounce;
    uint64_t rays, state;
};

/* ---- a scene as floats ---- */

static void rgb_of(const struct tia_rgb *c, uint8_t bits, float out[3])
{
    float scale = (float)(1u << bits) / 1073741824;

    out[0] = (float)c->r * scale;
    out[1] = (float)c->g * scale;
    out[2] = (float)c->b * scale;
}

static float largest(const float c[3])
{
    return fmaxf(c[0], fmaxf(c[1], c[2]));
}

static bool take_material(const struct tia_material *given, struct material *m)
{
    rgb_of(&given->colour, 0, m->colour);
    rgb_of(&given->specular, 0, m->specular);
    rgb_of(&given->mirror, 0, m->mirror);
    rgb_of(&given->emission, given->emission_bits, m->emission);
    m->exponent = (float)given->exponent / 65536;
    float parts[3] = {largest(m->mirror), largest(m->specular), largest(m->colour)};
    float all = parts[0] + parts[1] + parts[2];
    m->black = all <= 0;
    m->below[0] = m->black ? 0 : parts[0] / all;
    m->below[1] = m->black ? 0 : (parts[0] + parts[1]) / all;
    return !given->texture && !given->opacity && !(given->refraction.r | given->refraction.g | given->refraction.b);
}

static bool take_light(const struct tia_light *given, struct light *l)
{
    *l = (struct light){.plane = given->kind == TIA_RECTANGLE_LIGHT, .centre = float_place(given->centre)};
    rgb_of(&given->emission, given->emission_bits, l->emission);
    for (int i = 0; i < 2; i++)
        l->side[i] = float_place(given->side[i]);
    struct vec normal = vec_cross(l->side[0], l->side[1]);
    l->area = 4 * sqrtf(vec_dot(normal, normal));
    l->normal = l->plane ? vec_unit(normal) : normal;
    return l->plane ||
           (given->kind == TIA_POINT_LIGHT && !given->radius && !(given->constant | given->linear | given->quadratic));
}

static bool take_scene(struct float_paths *p, const struct tia_scene *scene)
{
    const struct tia_camera *camera = &scene->camera;
    bool known = camera->projection == TIA_PERSPECTIVE;

    p->materials = calloc(scene->material_count + 1, sizeof *p->materials);
    p->lights = calloc(scene->light_count + 1, sizeof *p->lights);
    if (!p->materials || !p->lights)
        return false;
    for (uint32_t i = 0; i < scene->material_count; i++)
        known = take_material(&scene->materials[i], &p->materials[i]) && known;
    for (p->light_count = 0; p->light_count < scene->light_count; p->light_count++)
        known = take_light(&scene->lights[p->light_count], &p->lights[p->light_count]) && known;
    rgb_of(&scene->background, 0, p->background);
    p->eye = float_place(camera->eye);
    p->ahead = vec_unit(vec_sub(float_place(camera->reference), p->eye));
    float half = tanf((float)camera->fov / 65536 * PI / 360);
    struct vec right = vec_unit(vec_cross(p->ahead, float_place(camera->up)));
    p->right = vec_scaled(right, half * (float)p->width / (float)p->height);
    p->up = vec_scaled(vec_cross(right, p->ahead), half);
    return known && float_world_build(&p->world, scene);
}

struct float_paths *float_paths_open(const struct tia_scene *scene, unsigned width, unsigned height)
{
    struct float_paths *p = calloc(1, sizeof *p);

    if (!p)
        return NULL;
    p->width = width;
    p->height = height;
    if (take_scene(p, scene))
        return p;
    float_paths_close(p);
    return NULL;
}

void float_paths_close(struct float_paths *p)
{
    float_world_free(&p->world);
    free(p->materials);
    free(p->lights);
    free(p);
}

/* ---- samples ---- */

/* Returns a random number from 0 up to 1, by xorshift64*. */
static float uniform(struct path *p)
{
    p->state ^= p->state >> 12;
    p->state ^= p->state << 25;
    p->state ^= p->state >> 27;
    return (float)(uint32_t)(p->state * UINT64_C(0x2545f4914f6cdd1d) >> 40) / 16777216;
}

static void add(struct path *p, const float radiance[3], float weight)
{
    for (int c = 0; c < 3; c++)
        p->sum[c] += p->throughput[c] * radiance[c] * weight;
}

static bool meets_light(const struct light *l, const struct float_ray *ray, float *t)
{
    float down = vec_dot(ray->direction, l->normal);
    float first = vec_dot(vec_sub(l->centre, ray->origin), l->normal) / down;

    if (!l->plane || !(first > 0 && first < *t))
        return false;
    struct vec x = vec_sub(vec_along(ray->origin, first, ray->direction), l->centre);
    struct vec a = vec_cross(x, l->side[1]), b = vec_cross(l->side[0], x);
    float whole = l->area / 4;
    if (fabsf(vec_dot(a, l->normal)) > whole || fabsf(vec_dot(b, l->normal)) > whole)
        return false;
    *t = first;
    return true;
}

/* Returns the probability density, per solid angle, of a sample on the light, times pi. */
static float density_of(const struct light *l, struct vec direction, float t)
{
    return PI * t * t / (l->area * fabsf(vec_dot(direction, l->normal)));
}

/* Adds the emission of a light that the ray has hit, with the weight of the balance heuristic. */
static void add_light(struct path *p, const struct light *l, float t)
{
    float chosen = density_of(l, p->ray.direction, t) / (float)p->scene->light_count;

    add(p, l->emission, p->density > 0 ? p->density / (p->density + chosen) : 1);
}

static struct vec reflected(struct vec d, struct vec n)
{
    return vec_along(d, -2 * vec_dot(d, n), n);
}

/* Stores the reflectance times the cosine in f, and returns the probability density of `to`; both are multiplied by
 * pi. */
static float evaluate(const struct material *m, struct vec from, struct vec n, struct vec to, float f[3])
{
    float cosine = vec_dot(to, n), along = vec_dot(to, reflected(from, n));
    float power = m->below[1] > m->below[0] && along > 0 ? powf(along, m->exponent) / 2 : 0;

    for (int c = 0; c < 3; c++)
        f[c] = (m->colour[c] + m->specular[c] * (m->exponent + 2) * power) * cosine;
    return (1 - m->below[1]) * cosine + (m->below[1] - m->below[0]) * (m->exponent + 1) * power;
}

static void look_for_light(struct path *p, const struct material *m, struct vec at, struct vec n)
{
    const struct float_paths *s = p->scene;
    const struct light *l = &s->lights[(uint32_t)(uniform(p) * (float)s->light_count)];
    float u = 2 * uniform(p) - 1, v = 2 * uniform(p) - 1, f[3];
    struct vec way = vec_sub(vec_along(vec_along(l->centre, u, l->side[0]), v, l->side[1]), at);
    float distance = sqrtf(vec_dot(way, way));
    struct float_ray shadow = {at, vec_scaled(way, 1 / distance)};
    struct float_hit hit = {.t = distance * 0.9999F};

    if (vec_dot(shadow.direction, n) <= 0)
        return;
    p->rays++;
    p->meeting->meet(p->meeting->world, &shadow, true, &hit);
    for (uint32_t i = 0; i < s->light_count && !hit.item; i++)
        if (meets_light(&s->lights[i], &shadow, &hit.t))
            return;
    if (hit.item)
        return;
    float density = 1 / (float)s->light_count, other = evaluate(m, p->ray.direction, n, shadow.direction, f);
    if (l->plane)
        density = density * density_of(l, shadow.direction, distance) + other;
    for (int c = 0; c < 3; c++)
        f[c] *= l->emission[c] / density;
    add(p, f, 1);
}

/* Continues the path. Returns false if it ends. */
static bool bounce(struct path *p, const struct material *m, struct vec n)
{
    float choice = uniform(p), turn = 2 * PI * uniform(p), u = uniform(p), f[3];
    struct vec axis = reflected(p->ray.direction, n), from = p->ray.direction;
    bool glossy = choice < m->below[1];

    p->bounce++;
    if (choice < m->below[0]) {
        for (int c = 0; c < 3; c++)
            p->throughput[c] *= m->mirror[c] / m->below[0];
        p->density = 0;
        p->ray.direction = axis;
        return true;
    }
    float z = powf(u, glossy ? 1 / (m->exponent + 1) : 0.5F), r = sqrtf(fmaxf(0, 1 - z * z));
    p->ray.direction = vec_around(glossy ? axis : n, (struct vec){r * cosf(turn), r * sinf(turn), z});
    if (vec_dot(p->ray.direction, n) <= 0)
        return false;
    p->density = evaluate(m, from, n, p->ray.direction, f);
    for (int c = 0; c < 3; c++)
        p->throughput[c] *= f[c] / p->density;
    return true;
}

static bool survives(struct path *p)
{
    float chance = fminf(largest(p->throughput), 1);

    if (p->bounce < ROULETTE)
        return true;
    if (uniform(p) >= chance)
        return false;
    for (int c = 0; c < 3; c++)
        p->throughput[c] /= chance;
    return true;
}

/* Follows one ray, and adds the light at its end. Returns false if the path ends. */
static bool step(struct path *p)
{
    const struct float_paths *s = p->scene;
    const struct light *light = NULL;
    struct float_hit hit = {.t = 1e30F};

    p->rays++;
    p->meeting->meet(p->meeting->world, &p->ray, false, &hit);
    for (uint32_t i = 0; i < s->light_count; i++)
        light = meets_light(&s->lights[i], &p->ray, &hit.t) ? &s->lights[i] : light;
    if (light)
        add_light(p, light, hit.t);
    else if (!hit.item)
        add(p, s->background, 1);
    if (light || !hit.item)
        return false;
    const struct material *m = &s->materials[hit.item->material];
    struct vec at = vec_along(p->ray.origin, hit.t, p->ray.direction);
    struct vec n = vec_unit(hit.item->radius > 0 ? vec_sub(at, hit.item->corner)
                                                 : vec_cross(hit.item->side[0], hit.item->side[1]));
    n = vec_dot(n, p->ray.direction) > 0 ? vec_scaled(n, -1) : n;
    at = vec_along(at, 2e-5F * fmaxf(hit.t / 16, fmaxf(fabsf(at.x), fmaxf(fabsf(at.y), fabsf(at.z)))), n);
    add(p, m->emission, 1);
    if (m->black || p->bounce >= BOUNCES_MAX || !survives(p))
        return false;
    if (m->below[0] < 1 && s->light_count)
        look_for_light(p, m, at, n);
    p->ray.origin = at;
    return bounce(p, m, n);
}

static uint64_t draw_pixel(const struct float_paths *s, const struct float_meeting *meeting, unsigned x, unsigned y,
                           unsigned spp, float rgb[3])
{
    struct path p = {
        .scene = s, .meeting = meeting, .state = ((uint64_t)y << 32 | x) * UINT64_C(0x9e3779b97f4a7c15) + 1};
    float sum[3] = {0, 0, 0};

    for (unsigned i = 0; i < spp; i++) {
        float across = 2 * ((float)x + uniform(&p)) / (float)s->width - 1;
        float down = 1 - 2 * ((float)y + uniform(&p)) / (float)s->height;
        p.ray = (struct float_ray){s->eye, vec_unit(vec_along(vec_along(s->ahead, across, s->right), down, s->up))};
        p.density = 0;
        p.bounce = 0;
        for (int c = 0; c < 3; c++) {
            p.throughput[c] = 1;
            p.sum[c] = 0;
        }
        while (step(&p))
            ;
        for (int c = 0; c < 3; c++)
            sum[c] += p.sum[c];
    }
    for (int c = 0; c < 3; c++)
        rgb[c] = sum[c] / (float)spp;
    return p.rays;
}

static void meet_world(const void *world, const struct float_ray *ray, bool any, struct float_hit *hit)
{
    float_world_meet(world, ray, any, hit);
}

const struct float_world *float_paths_world(const struct float_paths *paths)
{
    return &paths->world;
}

uint64_t float_paths_draw(const struct float_paths *paths, const struct float_meeting *meeting, unsigned spp,
                          float *rgb)
{
    const struct float_meeting own = {meet_world, &paths->world};
    uint64_t rays = 0;

    for (unsigned y = 0; y < paths->height; y++)
        for (unsigned x = 0; x < paths->width; x++)
            rays += draw_pixel(paths, meeting ? meeting : &own, x, y, spp, rgb + 3 * ((size_t)y * paths->width + x));
    return rays;
}
