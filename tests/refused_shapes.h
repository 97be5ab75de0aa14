/* refused_shapes.h - a scene of one shape, with a transform, a mesh, a grid and a solid. */
#ifndef TESTS_REFUSED_SHAPES_H
#define TESTS_REFUSED_SHAPES_H

#include "refusals.h"

#define ONE 65536
#define LENGTH "its length must be in 0.5..1.5"
#define RADIUS "must be at least 2^-10"
#define PARTS 40

static struct tia_material materials[3];
static struct tia_shape shapes[PARTS];
static struct tia_shape *const shape = &shapes[0];
static struct tia_transform transform;
static struct tia_mesh meshes[PARTS];
static struct tia_grid grids[PARTS];
static struct tia_vec3 vertices[3];
static struct tia_dir3 normals[2];
static struct tia_uv uvs[2];
static struct tia_face face;
static uint8_t cells[4];
static const struct tia_shape member = {.kind = TIA_SPHERE, .sphere = {.radius = ONE}};
static const uint8_t step = TIA_SOLID_MEMBER;
static const struct tia_solid solid = {&member, &step, 1, 1};

static inline struct tia_shape sample(enum tia_shape_kind kind)
{
    struct tia_shape s = {.kind = kind};

    if (kind == TIA_SPHERE)
        s.sphere.radius = ONE;
    if (kind == TIA_PLANE)
        s.plane.normal.y = TIA_Q30_ONE;
    if (kind == TIA_DISC)
        s.disc = (struct tia_disc){{0, 0, 0}, {0, TIA_Q30_ONE, 0}, ONE};
    if (kind == TIA_CYLINDER)
        s.cylinder = (struct tia_cylinder){{0, 0, 0}, {0, ONE, 0}, ONE, true};
    if (kind == TIA_CONE)
        s.cone = (struct tia_cone){{0, 0, 0}, {0, ONE, 0}, ONE, 0, true};
    if (kind == TIA_BOX)
        s.box = (struct tia_box){{0, 0, 0}, {ONE, ONE, ONE}};
    if (kind == TIA_TORUS)
        s.torus = (struct tia_torus){{0, 0, 0}, {0, TIA_Q30_ONE, 0}, 2 * ONE, ONE};
    if (kind == TIA_ROUNDED)
        s.rounded = (struct tia_rounded){{0, 0, 0}, {ONE, ONE, ONE}, ONE / 4};
    if (kind == TIA_TRIANGLE)
        s.triangle = (struct tia_triangle){{{0, 0, 0}, {ONE, 0, 0}, {0, ONE, 0}}};
    return s;
}

static inline void set_up(enum tia_shape_kind kind)
{
    const struct tia_transform unit = {{0, 0, 0}, {0, 0, 0}, {ONE, ONE, ONE}};

    memset(materials, 0, sizeof materials);
    vertices[0] = (struct tia_vec3){0, 0, 0};
    vertices[1] = (struct tia_vec3){ONE, 0, 0};
    vertices[2] = (struct tia_vec3){0, ONE, 0};
    normals[0] = normals[1] = (struct tia_dir3){0, 0, TIA_Q30_ONE};
    for (uint32_t i = 0; i < 3; i++)
        face.corner[i] = (struct tia_corner){i, TIA_NO_INDEX, TIA_NO_INDEX};
    memset(cells, 0, sizeof cells);
    meshes[0] = (struct tia_mesh){vertices, normals, uvs, &face, 3, 2, 2, 1, NULL};
    grids[0] = (struct tia_grid){{0, 0, 0}, ONE, {2, 1, 2}, cells};
    shapes[0] = sample(kind);
    transform = unit;
    scene = (struct tia_scene){.camera = {.fov = 25 * ONE},
                               .materials = materials,
                               .material_count = 3,
                               .shapes = shapes,
                               .shape_count = 1,
                               .transforms = &transform,
                               .transform_count = 1,
                               .meshes = meshes,
                               .mesh_count = 1,
                               .grids = grids,
                               .grid_count = 1,
                               .solids = &solid,
                               .solid_count = 1};
    check_accepted();
}

#endif
