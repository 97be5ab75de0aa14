/* thesis.c - the built-in scene: a white ball on a grey ground, and the four keys of its light. */
#include <tia/scene.h>

#define WHITE                                                                                                          \
    {                                                                                                                  \
        TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE                                                                          \
    }

static const struct tia_material materials[] = {
    {.colour = TIA_RGB(0.6, 0.6, 0.6)},
    {.colour = WHITE},
};

static const struct tia_sphere spheres[] = {
    {TIA_VEC3(0, -10004, -20), TIA_Q16(10000), 0},
    {TIA_VEC3(0, -1, -20), TIA_Q16(3), 1},
};

static const struct tia_binding bindings[] = {
    {'a', 0, {.centre = TIA_VEC3(-20, 20, -20), .radius = TIA_Q16(3), .emission = WHITE}}, /* above left */
    {'d', 0, {.centre = TIA_VEC3(20, 20, -20), .radius = TIA_Q16(3), .emission = WHITE}},  /* above right */
    {'s', 0, {.centre = TIA_VEC3(0, 20, -8), .radius = TIA_Q16(3), .emission = WHITE}},    /* above, near the eye */
    {'w', 0, {.centre = TIA_VEC3(0, 20, -32), .radius = TIA_Q16(3), .emission = WHITE}},   /* above, far from the eye */
};

const struct tia_scene tia_thesis_scene = {
    .camera = {.eye = TIA_VEC3(0, 0, 0), .fov = TIA_Q16(25)},
    .background = TIA_RGB(0.8, 0.8, 0.8),
    .materials = materials,
    .spheres = spheres,
    .bindings = bindings,
    .material_count = 2,
    .sphere_count = 2,
    .binding_count = 4,
};
