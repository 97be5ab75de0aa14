/* edge_scene.h - scenes beyond those of the corpora: spheres and lights of any magnitude, lights on, in and behind
 * spheres, all fields of view, narrow and very wide images. Some are refused by tia_scene_check. */
#ifndef TESTS_EDGE_SCENE_H
#define TESTS_EDGE_SCENE_H

#include <tia/tia.h>

#include "common/corpus/dice.h"

#define EDGE_SPHERES 6
#define EDGE_LIGHTS 4

struct edge_scene {
    struct tia_scene scene;
    unsigned width, height;
    bool dither;
    struct tia_sphere spheres[EDGE_SPHERES];
    struct tia_material materials[EDGE_SPHERES];
    struct tia_light lights[EDGE_LIGHTS];
};

static inline uint32_t edge_below(uint64_t *state, uint32_t limit)
{
    return (uint32_t)(dice_next(state) % limit);
}

/* Returns a number of random magnitude below 2^bits, with a random sign. */
static inline int32_t edge_any(uint64_t *state, int bits)
{
    uint64_t range = UINT64_C(2) << edge_below(state, (uint32_t)bits);
    int32_t x = (int32_t)(dice_next(state) & (range - 1));

    return edge_below(state, 2) ? x : -x;
}

static inline struct tia_vec3 edge_point(uint64_t *state, int bits)
{
    int32_t x = edge_any(state, bits), y = edge_any(state, bits), z = edge_any(state, bits); /* in this order */

    return (struct tia_vec3){x, y, z};
}

static inline struct tia_rgb edge_colour(uint64_t *state, bool grey)
{
    tia_q30 r = (tia_q30)edge_below(state, TIA_Q30_ONE + 1u);
    struct tia_rgb colour = {r, r, r};

    if (!grey) {
        colour.g = (tia_q30)edge_below(state, TIA_Q30_ONE + 1u);
        colour.b = (tia_q30)edge_below(state, TIA_Q30_ONE + 1u);
    }
    return colour;
}

static inline void edge_sphere(uint64_t *state, struct edge_scene *e, unsigned i, int reach)
{
    const struct tia_vec3 *eye = &e->scene.camera.eye;
    struct tia_sphere *s = &e->spheres[i];
    int32_t away = edge_any(state, reach), radius = edge_any(state, reach - 1);

    away = away < 0 ? -away : away;
    s->radius = (radius < 0 ? -radius : radius) + 64;
    s->material = i;
    s->centre.x = eye->x + away / 4 * ((int32_t)edge_below(state, 3) - 1);
    s->centre.x += edge_any(state, 12);
    s->centre.y = eye->y + away / 4 * ((int32_t)edge_below(state, 3) - 1);
    s->centre.y += edge_any(state, 12);
    s->centre.z = eye->z - away - (edge_below(state, 8) ? s->radius : 0); /* in most cases in front of the eye */
    if (i > 0 && edge_below(state, 3) == 0) {                             /* the sphere touches the previous one */
        s->centre = e->spheres[i - 1].centre;
        s->centre.y += s->radius + e->spheres[i - 1].radius;
    }
}

static inline void edge_light(uint64_t *state, struct edge_scene *e, unsigned i, int reach, bool grey)
{
    const struct tia_sphere *at = &e->spheres[edge_below(state, e->scene.sphere_count)];
    struct tia_light *light = &e->lights[i];

    *light = (struct tia_light){.kind = TIA_POINT_LIGHT, .emission = edge_colour(state, grey)};
    light->centre = edge_point(state, reach);
    if (edge_below(state, 3) == 0) { /* on a sphere, or near its surface */
        light->centre = at->centre;
        light->centre.y += at->radius + edge_any(state, 16);
    }
    if (edge_below(state, 2))
        light->radius = 64 + (tia_q16)edge_below(state, UINT32_C(1) << (reach - 4));
    if (edge_below(state, 2))
        light->emission = (struct tia_rgb){TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE};
}

static inline void edge_make(struct edge_scene *e, uint64_t seed)
{
    uint64_t state = seed * UINT64_C(1000003);
    int reach = 16 + (int)edge_below(&state, 14);
    bool grey = edge_below(&state, 2), clear = edge_below(&state, 4) == 0, glow = edge_below(&state, 8) == 0;

    *e = (struct edge_scene){.scene = {.camera = {.eye = edge_point(&state, reach)}}};
    e->scene.spheres = e->spheres;
    e->scene.materials = e->materials;
    e->scene.lights = e->lights;
    e->scene.camera.fov =
        (tia_q16)(TIA_Q16_ONE + edge_below(&state, TIA_Q16_ONE * (edge_below(&state, 2) ? 168u : 30u)));
    e->scene.sphere_count = e->scene.material_count = 1 + edge_below(&state, EDGE_SPHERES);
    e->scene.light_count = edge_below(&state, EDGE_LIGHTS + 1);
    for (unsigned i = 0; i < e->scene.sphere_count; i++) {
        edge_sphere(&state, e, i, reach);
        e->materials[i].colour = edge_colour(&state, grey);
        if (clear && i & 1)
            e->materials[i].transmission = edge_colour(&state, grey);
        if (glow)
            e->materials[i].emission = edge_colour(&state, grey);
    }
    for (unsigned i = 0; i < e->scene.light_count; i++)
        edge_light(&state, e, i, reach, grey);
    e->width = 1 + edge_below(&state, 300);
    e->height = 1 + edge_below(&state, 40);
    if (edge_below(&state, 16) == 0) {
        e->width = TIA_SIZE_MAX;
        e->height = 2;
    }
    e->dither = edge_below(&state, 4) == 0;
}

#endif
