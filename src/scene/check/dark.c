/* dark.c - warns of scenes whose lights or materials are all too dark to be visible. The likely mistake is a colour
 * written as Q16.16 instead of Q2.30: it is 2^14 times too small and, since colours are below 2, below 2^-13. */
#include <tia/motion.h>

#include "scene_check.h"

/* The brightest of several colours, and the index of its light or material. */
struct brightest {
    uint64_t channel; /* largest channel, Q2.30, times 2^bits of emission and exposure */
    uint32_t index;
};

static void add(struct brightest *b, uint32_t index, const struct tia_rgb *colour, unsigned bits)
{
    int32_t most = colour->r > colour->g ? colour->r : colour->g;
    uint64_t channel = (uint64_t)(most > colour->b ? most : colour->b) << bits;

    if (channel > b->channel)
        *b = (struct brightest){channel, index};
}

/* Returns the number of stops by which the exposure brightens the picture, rounded up; 0 if the integrator ignores the
 * exposure. */
static unsigned exposure_bits(const struct tia_integration *i)
{
    return i->integrator == TIA_WHITTED || i->exposure <= 0 ? 0 : (unsigned)(((uint32_t)i->exposure + 65535) >> 16);
}

static unsigned bits_of(const struct tia_scene *scene, uint8_t emission_bits)
{
    return exposure_bits(&scene->integration) + (scene->integration.integrator == TIA_PATHS ? emission_bits : 0);
}

/* Adds a light. A light with attenuation counts as bright, since a small divisor brightens it. */
static void add_light(struct brightest *b, uint32_t index, const struct tia_scene *scene, const struct tia_light *light)
{
    if (light->constant || light->linear || light->quadratic)
        b->channel = TIA_Q30_ONE;
    add(b, index, &light->emission, bits_of(scene, light->emission_bits));
}

static bool is_dark(const struct brightest *b)
{
    return b->channel > 0 && b->channel < TIA_DARK;
}

static bool are_lights_dark(const struct tia_scene *scene, struct tia_fault *fault)
{
    struct brightest lights = {0, 0}, keys = {0, 0};

    for (uint32_t i = 0; i < scene->light_count; i++)
        add_light(&lights, i, scene, &scene->lights[i]);
    for (uint32_t i = 0; i < scene->binding_count; i++)
        add_light(&keys, i, scene, &scene->bindings[i].state);
    bool in_keys = keys.channel > lights.channel;
    *fault = (struct tia_fault){in_keys ? "key" : "light", in_keys ? keys.index : lights.index, "emission",
                                "all lights are darker than 2^-13: nothing is seen by them"};
    return is_dark(in_keys ? &keys : &lights);
}

static bool have_colour_tracks(const struct tia_scene *scene)
{
    for (uint32_t i = 0; i < scene->track_count; i++)
        if (scene->tracks[i].target >= TIA_SETS_COLOUR && scene->tracks[i].target <= TIA_SETS_FACING)
            return true;
    return false;
}

static bool are_materials_dark(const struct tia_scene *scene, struct tia_fault *fault)
{
    struct brightest all = {0, 0};
    unsigned exposure = exposure_bits(&scene->integration);

    for (uint32_t i = 0; i < scene->material_count; i++) {
        const struct tia_material *m = &scene->materials[i];
        const struct tia_rgb *const colours[] = {&m->colour, &m->specular, &m->mirror, &m->refraction, &m->facing};
        for (unsigned k = 0; k < sizeof colours / sizeof *colours; k++)
            add(&all, i, colours[k], exposure);
        add(&all, i, &m->emission, bits_of(scene, m->emission_bits));
    }
    *fault = (struct tia_fault){"material", all.index, "colour",
                                "all materials are darker than 2^-13: nothing is seen of them"};
    return is_dark(&all) && !have_colour_tracks(scene);
}

void tia_check_warn(const struct tia_scene *scene, struct tia_fault *fault)
{
    if (!are_lights_dark(scene, fault) && !are_materials_dark(scene, fault))
        *fault = (struct tia_fault){NULL, 0, NULL, NULL};
}
