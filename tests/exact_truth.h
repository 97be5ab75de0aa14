/* exact_truth.h - a pixel by the formulas of docs/definition.md in 113 bits, with the page's quotients and roots. No
 * code is shared with src/exact. A pixel is open where the sides of a comparison differ by no more than roundings
 * may. */
#ifndef TESTS_EXACT_TRUTH_H
#define TESTS_EXACT_TRUTH_H

#include "exact/pixel.h"
#include "simd_truth.h"

#if TRUTH_KNOWN

/* The roundings of D are below 2^-108 of its larger term. Where D is at least NEAR_D of that, its root is off by less
 * than 2^-78 of the term's root, and all that depends on it by less than NEAR. */
#define NEAR_D ((quad)0x1p-60)
#define NEAR ((quad)0x1p-45)

/* A picture, and whether the pixel computed last is open. */
struct truth_pixel {
    const struct exact_picture *picture;
    int size[2];
    quad depth;
    bool open;
};

static inline void truth_picture(const struct exact_picture *picture, struct truth_pixel *p)
{
    *p = (struct truth_pixel){picture, {picture->width, picture->height}, 0, false};
    p->depth = picture->scene->camera.fov == TIA_Q16(90)
                   ? picture->height
                   : truth_depth((unsigned)picture->height, picture->scene->camera.fov);
}

/* Returns the sign of x. Where |x| <= near scale, it is open, and 0 is returned. */
static inline int truth_sign(struct truth_pixel *p, quad x, quad scale, quad near)
{
    bool open = quad_size(x) <= near * scale;

    p->open = p->open || open;
    return open ? 0 : x < 0 ? -1 : 1;
}

static inline quad quad_largest(const quad a[3], const quad b[3])
{
    quad most = 0;

    for (int i = 0; i < 3; i++) {
        most = quad_size(a[i]) > most ? quad_size(a[i]) : most;
        most = quad_size(b[i]) > most ? quad_size(b[i]) : most;
    }
    return most;
}

/* True if b is in the ball around a, or on it. The result is exact, as the sum of squares is below 2^66 in units of
 * 2^-32. */
static inline bool truth_encloses(struct tia_vec3 a, tia_q16 radius, struct tia_vec3 b)
{
    quad d[3] = {(quad)a.x - b.x, (quad)a.y - b.y, (quad)a.z - b.z};

    return quad_dot(d, d) <= (quad)radius * radius;
}

/* True if the eye is in the ball. */
static inline bool truth_around(const struct tia_scene *scene, struct tia_vec3 centre, tia_q16 radius)
{
    const struct tia_vec3 *eye = &scene->camera.eye;
    quad d[3] = {(quad)centre.x - eye->x, (quad)centre.y - eye->y, (quad)centre.z - eye->z};

    return quad_dot(d, d) < (quad)radius * radius;
}

/* True if the ray meets the ball; *o is the ray and the point. */
static inline bool truth_meets(struct truth_pixel *p, int x, int y, struct tia_vec3 centre, tia_q16 radius,
                               struct truth *o)
{
    const struct tia_scene *scene = p->picture->scene;
    quad l[3], parts[3], zero[3] = {0, 0, 0};

    truth_meet(scene, p->size, p->depth, x, y, centre, radius, o);
    if (truth_around(scene, centre, radius))
        return true;
    truth_place(scene, centre, l);
    for (int i = 0; i < 3; i++)
        parts[i] = l[i] * o->v[i];
    return truth_sign(p, o->b, quad_largest(parts, zero), NEAR) > 0 && truth_sign(p, o->d, o->b * o->b, NEAR_D) > 0;
}

static inline bool truth_blocks(struct truth_pixel *p, const struct tia_sphere *caster, struct tia_vec3 light,
                                const struct truth *o, const struct truth_way *way)
{
    const struct tia_scene *scene = p->picture->scene;
    bool enclosed = truth_encloses(caster->centre, caster->radius, light);
    quad c[3], a[3];
    struct truth_caster cast;

    if (truth_around(scene, caster->centre, caster->radius))
        return !enclosed;
    truth_place(scene, caster->centre, c);
    truth_approach(o, way, c, (quad)caster->radius / 65536, &cast);
    for (int i = 0; i < 3; i++)
        a[i] = c[i] - o->start[i];
    quad s = quad_largest(a, way->w), square = s * s;
    if (truth_sign(p, cast.a, square, NEAR) <= 0)
        return false;
    if (truth_sign(p, cast.a * cast.a - cast.h * way->square, square * square, NEAR) <= 0)
        return false;
    return enclosed || truth_sign(p, way->square - cast.a, square, NEAR) > 0;
}

static inline void truth_light(struct truth_pixel *p, uint32_t object, const struct tia_light *light,
                               const struct truth *o, quad sum[3])
{
    const struct tia_scene *scene = p->picture->scene;
    const struct tia_rgb *colour = &scene->materials[scene->spheres[object].material].colour;
    quad q[3], nq[3], np[3];
    quad part[3] = {(quad)colour->r * light->emission.r, (quad)colour->g * light->emission.g,
                    (quad)colour->b * light->emission.b};
    struct truth_way way;

    truth_place(scene, light->centre, q);
    truth_look(o, q, &way);
    for (int i = 0; i < 3; i++) {
        nq[i] = o->n[i] * q[i];
        np[i] = o->n[i] * o->p[i];
    }
    if (truth_sign(p, quad_dot(o->n, way.w), quad_largest(nq, np), NEAR) <= 0)
        return;
    for (uint32_t j = 0; j < scene->sphere_count; j++) {
        const struct tia_rgb *through = &scene->materials[scene->spheres[j].material].transmission;
        if ((j == object && !truth_around(scene, scene->spheres[j].centre, scene->spheres[j].radius)) ||
            !truth_blocks(p, &scene->spheres[j], light->centre, o, &way))
            continue;
        part[0] *= (quad)through->r * (quad)0x1p-30;
        part[1] *= (quad)through->g * (quad)0x1p-30;
        part[2] *= (quad)through->b * (quad)0x1p-30;
    }
    for (int c = 0; c < 3; c++)
        sum[c] += part[c] * (quad)0x1p-60 * way.cosine;
}

/* Returns floor(k min(1, S) + d). An unlit channel is rounded in integers. */
static inline unsigned truth_level(struct truth_pixel *p, quad sum, tia_q30 flat, unsigned most, tia_q30 threshold)
{
    quad base = (quad)flat * (quad)0x1p-30;

    if (sum == base)
        return (unsigned)(((uint64_t)(flat < TIA_Q30_ONE ? flat : TIA_Q30_ONE) * most + (uint64_t)threshold) >> 30);
    quad level = most * (sum < 1 ? sum : 1) + threshold * (quad)0x1p-30;
    unsigned below = (unsigned)level;
    (void)truth_sign(p, level - below, most, NEAR);
    (void)truth_sign(p, level - (below + 1), most, NEAR);
    return below;
}

/* Returns pixel (x, y), and sets p->open where it is not certain. */
static inline tia_rgb565 truth_pixel_at(struct truth_pixel *p, int x, int y, tia_q30 threshold)
{
    const struct tia_scene *scene = p->picture->scene;
    uint32_t count = scene->sphere_count, all = count + p->picture->light_count, seen = all;
    struct tia_rgb flat = scene->background;
    struct truth nearest = {.t = 0}, o;

    p->open = false;
    for (uint32_t i = 0; i < all; i++) {
        bool light = i >= count;
        struct tia_vec3 centre = light ? p->picture->lights[i - count].centre : scene->spheres[i].centre;
        tia_q16 radius = light ? p->picture->lights[i - count].radius : scene->spheres[i].radius;
        if (!radius || !truth_meets(p, x, y, centre, radius, &o))
            continue;
        if (seen < all && truth_sign(p, nearest.t - o.t, nearest.t, NEAR) <= 0)
            continue;
        nearest = o;
        seen = i;
    }
    if (seen < count)
        flat = scene->materials[scene->spheres[seen].material].emission;
    else if (seen < all)
        flat = p->picture->lights[seen - count].emission;
    quad sum[3] = {(quad)flat.r * (quad)0x1p-30, (quad)flat.g * (quad)0x1p-30, (quad)flat.b * (quad)0x1p-30};
    for (uint32_t l = 0; seen < count && l < p->picture->light_count; l++)
        truth_light(p, seen, &p->picture->lights[l], &nearest, sum);
    unsigned r = truth_level(p, sum[0], flat.r, 31, threshold), g = truth_level(p, sum[1], flat.g, 63, threshold);
    return (tia_rgb565)(r << 11 | g << 5 | truth_level(p, sum[2], flat.b, 31, threshold));
}

#endif

#endif
