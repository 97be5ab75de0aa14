/* thesis.tia, as tia-compile wrote it: do not edit. */
// clang-format off
#include <tia/scene.h>

extern const struct tia_scene tia_thesis_scene;

static const struct tia_material tia_thesis_scene_materials[] = {
    {.colour = {644245094, 644245094, 644245094},},
    {.colour = {1073741824, 1073741824, 1073741824},},
};

static const struct tia_sphere tia_thesis_scene_spheres[] = {
    {{0, -655622144, -1310720}, 655360000, 0u}, {{0, -65536, -1310720}, 196608, 1u},
};

static const struct tia_binding tia_thesis_scene_bindings[] = {
    {.key = 'a', .state = {.centre = {-1310720, 1310720, -1310720}, .radius = 196608,
    .emission = {1073741824, 1073741824, 1073741824}, .kind = TIA_POINT_LIGHT,}},
    {.key = 'd', .state = {.centre = {1310720, 1310720, -1310720}, .radius = 196608,
    .emission = {1073741824, 1073741824, 1073741824}, .kind = TIA_POINT_LIGHT,}},
    {.key = 's', .state = {.centre = {0, 1310720, -524288}, .radius = 196608,
    .emission = {1073741824, 1073741824, 1073741824}, .kind = TIA_POINT_LIGHT,}},
    {.key = 'w', .state = {.centre = {0, 1310720, -2097152}, .radius = 196608,
    .emission = {1073741824, 1073741824, 1073741824}, .kind = TIA_POINT_LIGHT,}},
};

const struct tia_scene tia_thesis_scene = {
    .camera = {.fov = 1638400, .projection = TIA_PERSPECTIVE,},
    .background = {858993459, 858993459, 858993459}, .materials = tia_thesis_scene_materials,
    .spheres = tia_thesis_scene_spheres, .bindings = tia_thesis_scene_bindings, .material_count = 2u,
    .sphere_count = 2u, .binding_count = 4u,
};
