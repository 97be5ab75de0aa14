/* flat_scene.h - random scenes of flat faces, which techniques for shadows draw. */
#ifndef TESTS_FLAT_SCENE_H
#define TESTS_FLAT_SCENE_H

#include <tia/scene.h>

#include "random.h"

#define FLAT_SHAPES 9
#define FLAT_LIGHTS 5

static struct tia_material flat_materials[5];
static struct tia_shape flat_shapes[FLAT_SHAPES];
static struct tia_light flat_lights[FLAT_LIGHTS];

/* Returns a random number in from..to, in units of 1/`one`. */
static inline int32_t flat_between(double from, double to, double one)
{
    return (int32_t)((from + (to - from) * (double)(random_bits() % 65537) / 65536) * one);
}

static inline struct tia_vec3 flat_place(double from, double to, double size)
{
    return (struct tia_vec3){flat_between(from, to, size * 65536), flat_between(from, to, size * 65536),
                             flat_between(from, to, size * 65536)};
}

static inline struct tia_rgb flat_colour(double most)
{
    double one = 1 << 30;

    return (struct tia_rgb){flat_between(0, most, one), flat_between(0, most, one), flat_between(0, most, one)};
}

static inline void flat_make_materials(void)
{
    for (int i = 0; i < 5; i++)
        flat_materials[i] = (struct tia_material){.colour = flat_colour(1), .emission = flat_colour(i % 2 ? .2 : 0)};
    flat_materials[4].specular = flat_colour(.5);
    flat_materials[4].exponent = TIA_Q16(20);
}

static inline void flat_make_shapes(double size)
{
    flat_shapes[0] = (struct tia_shape){TIA_PLANE, .plane = {.normal = {flat_between(-.1, .1, 1 << 30), 1 << 30, 0}}};
    for (uint32_t i = 1; i < FLAT_SHAPES; i++) {
        struct tia_vec3 low = flat_place(-4, 3, size);
        flat_shapes[i] = (struct tia_shape){TIA_TRIANGLE, .material = i % 5};
        for (int k = 0; k < 3; k++)
            flat_shapes[i].triangle.corner[k] = flat_place(-4, 4, size);
        if (i % 2 == 0)
            continue;
        flat_shapes[i].kind = TIA_BOX;
        flat_shapes[i].box = (struct tia_box){
            low, {low.x + (int32_t)(size * 50000), low.y + (int32_t)(size * 90000), low.z + (int32_t)(size * 70000)}};
    }
}

static inline uint32_t flat_make_lights(double size)
{
    uint32_t count = 1 + (uint32_t)(random_bits() % FLAT_LIGHTS);

    for (uint32_t i = 0; i < count; i++) {
        flat_lights[i] = (struct tia_light){.centre = flat_place(-6, 8, size), .emission = flat_colour(i ? .6 : 1.3)};
        if (i == 2)
            flat_lights[i].kind = TIA_AMBIENT_LIGHT;
        if (i == 3) {
            flat_lights[i].kind = TIA_DIRECTIONAL_LIGHT;
            flat_lights[i].direction =
                (struct tia_dir3){flat_between(-.5, .5, 1 << 30), -(1 << 29) - (1 << 28), 1 << 28};
        }
        if (i == 4) {
            flat_lights[i].kind = TIA_SPOT_LIGHT;
            flat_lights[i].direction =
                (struct tia_dir3){flat_between(-.5, .5, 1 << 30), -(1 << 29) - (1 << 28), 1 << 28};
            flat_lights[i].outer = flat_between(20, 90, 65536);
            flat_lights[i].inner = flat_between(1, 20, 65536);
        }
    }
    return count;
}

/* Makes a scene with any technique for shadows but traced rays. */
static inline struct tia_scene flat_scene(void)
{
    static const double sizes[] = {1, 1, .05, 40}, fovs[] = {20, 45, 110};
    static const enum tia_shadows techniques[] = {TIA_SHADOWS_RAYS, TIA_SHADOWS_ZPASS, TIA_SHADOWS_ZFAIL,
                                                  TIA_SHADOWS_MAP, TIA_SHADOWS_MAP_EXACT};
    double size = sizes[random_bits() % 4], fov = fovs[random_bits() % 3];

    flat_make_materials();
    flat_make_shapes(size);
    return (struct tia_scene){.camera = {.eye = flat_place(1, 7, size),
                                         .reference = flat_place(-1, 1, size),
                                         .up = {0, TIA_Q16(1), 0},
                                         .fov = (tia_q16)(fov * 65536)},
                              .background = flat_colour(1),
                              .materials = flat_materials,
                              .material_count = 5,
                              .shapes = flat_shapes,
                              .shape_count = FLAT_SHAPES,
                              .lights = flat_lights,
                              .light_count = flat_make_lights(size),
                              .shadows = techniques[random_bits() % 5],
                              .shadow_map = {.size = 64}};
}

#endif
