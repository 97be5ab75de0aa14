/* crowd_scene.h - random crowds: many spheres, which block many lights. */
#ifndef TESTS_CROWD_SCENE_H
#define TESTS_CROWD_SCENE_H

#include "edge_scene.h"

enum { CROWD_SPHERES = 254, CROWD_LIGHTS = 70, CROWD_MATERIALS = 6 };

struct crowd_scene {
    struct tia_scene scene;
    unsigned width, height;
    bool dither;
    struct tia_sphere spheres[CROWD_SPHERES];
    struct tia_material materials[CROWD_MATERIALS];
    struct tia_light lights[CROWD_LIGHTS];
};

/* Returns a number from least to most, in 1/16. */
static inline tia_q16 crowd_between(uint64_t *state, int least, int most)
{
    return (tia_q16)(least * 4096 + (int32_t)edge_below(state, (uint32_t)(most - least) * 4096u));
}

static inline void crowd_materials(uint64_t *state, struct crowd_scene *c, bool grey)
{
    bool clear = edge_below(state, 2) == 0;

    for (int i = 0; i < CROWD_MATERIALS; i++) {
        struct tia_material *m = &c->materials[i];
        *m = (struct tia_material){.colour = edge_colour(state, grey)};
        if (edge_below(state, 4) == 0) /* half a level more than a level: a tie */
            m->emission.r = m->emission.g = m->emission.b = TIA_Q30_ONE / 2;
        if (clear && i & 1)
            m->transmission = edge_colour(state, grey);
    }
}

/* Balls in front of each other, above a ground or in front of a wall that no light reaches, with an emission that is a
 * tie. */
static inline void crowd_spheres(uint64_t *state, struct crowd_scene *c, bool ground, bool wall)
{
    for (uint32_t i = 0; i < c->scene.sphere_count; i++) {
        tia_q16 x = crowd_between(state, -96, 96), y = crowd_between(state, -32, 64),
                z = crowd_between(state, -480, -190);
        c->spheres[i] = (struct tia_sphere){{x, y, z}, crowd_between(state, 2, 16), i % CROWD_MATERIALS};
    }
    if (wall) {
        c->spheres[0] = (struct tia_sphere){{0, 0, TIA_Q16(-340)}, TIA_Q16(300), 0};
        c->materials[0].emission = (struct tia_rgb){TIA_Q30_ONE / 2, TIA_Q30_ONE / 2, TIA_Q30_ONE / 2};
    } else if (ground)
        c->spheres[0] = (struct tia_sphere){{0, TIA_Q16(-1003), TIA_Q16(-20)}, TIA_Q16(1000), 0};
}

/* Lights above, behind, between and in the spheres, or all behind them. A quarter of the pictures are brighter than
 * white. */
static inline void crowd_lights(uint64_t *state, struct crowd_scene *c, bool grey, bool behind)
{
    int32_t count = (int32_t)c->scene.light_count, part = edge_below(state, 4) ? count : 3;

    for (int i = 0; i < count; i++) {
        struct tia_light *l = &c->lights[i];
        tia_q16 x = crowd_between(state, -400, 400), y = crowd_between(state, -60, 400),
                z = crowd_between(state, -560, 200);
        *l = (struct tia_light){.centre = {x, y, z}, .emission = edge_colour(state, grey)};
        l->emission.r = 2 * (l->emission.r / part);
        l->emission.g = 2 * (l->emission.g / part);
        l->emission.b = 2 * (l->emission.b / part);
        if (behind) {
            l->centre.z -= TIA_Q16(500);
        } else if (edge_below(state, 6) == 0) {
            l->centre = c->spheres[edge_below(state, c->scene.sphere_count)].centre;
            l->centre.x += crowd_between(state, -4, 4);
        }
    }
}

/* Makes crowd number `number`. */
static inline void crowd_make(struct crowd_scene *c, unsigned number)
{
    static const uint8_t spheres[] = {254, 3, 30, 90, 9, 192}, lights[] = {17, 9, 64, 33, 8, 16, 70, 3};
    uint64_t state = UINT64_C(0x9e3779b97f4a7c15) * (number + 1);
    bool grey = edge_below(&state, 3) == 0;

    c->scene = (struct tia_scene){.camera = {.fov = TIA_Q16(40)},
                                  .background = edge_colour(&state, grey),
                                  .materials = c->materials,
                                  .material_count = CROWD_MATERIALS,
                                  .spheres = c->spheres,
                                  .sphere_count = spheres[number % 6],
                                  .lights = c->lights,
                                  .light_count = lights[number % 8]};
    c->width = 33 + edge_below(&state, number % 6 ? 200 : 60);
    c->height = 21 + edge_below(&state, 40);
    c->dither = edge_below(&state, 4) == 0;
    crowd_materials(&state, c, grey);
    crowd_spheres(&state, c, number % 3 != 2, number % 5 == 4);
    crowd_lights(&state, c, grey, number % 5 == 4);
}

#endif
