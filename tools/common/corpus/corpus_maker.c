#include "corpus_maker.h"

#include <string.h>

void maker_begin(struct maker *m, struct corpus_scene *out, uint64_t seed, unsigned index)
{
    static const struct tia_rgb colours[MATERIALS] = {{FULL, 0, 0},       {0, FULL, 0}, {FULL / 2, FULL / 2, FULL / 2},
                                                      {FULL, FULL, FULL}, {0, 0, 0},    {FULL, FULL, FULL}};

    m->out = out;
    m->dice = seed;
    m->dice = dice_next(&m->dice) + index;
    memset(out, 0, sizeof *out);
    out->scene.materials = out->materials;
    out->scene.spheres = out->spheres;
    out->scene.lights = out->lights;
    out->scene.material_count = MATERIALS;
    for (uint32_t i = 0; i < MATERIALS; i++)
        out->materials[i].colour = colours[i];
    out->materials[CLEAR].transmission = (struct tia_rgb){FULL / 2, FULL / 4, FULL};
    out->scene.background = (struct tia_rgb){FULL / 3, FULL / 7 * 3, FULL / 9 * 7};
}

void maker_end(struct maker *m)
{
    struct tia_vec3 eye = {0, 0, 0};

    if (heads(m))
        eye = dice_vec3(&m->dice, vec(-99 * ONE, -99 * ONE, -99 * ONE), vec(99 * ONE, 99 * ONE, 99 * ONE));
    m->out->scene.camera.eye = eye;
    for (uint32_t i = 0; i < m->out->scene.sphere_count; i++)
        m->out->spheres[i].centre = sum(m->out->spheres[i].centre, eye, 1);
    for (uint32_t i = 0; i < m->out->scene.light_count; i++)
        m->out->lights[i].centre = sum(m->out->lights[i].centre, eye, 1);
}
