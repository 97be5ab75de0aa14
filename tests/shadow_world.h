/* shadow_world.h - random scenes of all kinds of shapes over a ground plane, with lights and cameras of all kinds. */
#ifndef TESTS_SHADOW_WORLD_H
#define TESTS_SHADOW_WORLD_H

#include <tia/scene.h>

#include "random.h"

#define Q TIA_Q16

enum { SHAPES = 24, SPHERES = 6 };

static const struct tia_vec3 tetrahedron_points[] = {{0, 0, 0}, {Q(1), 0, 0}, {0, Q(1), 0}, {0, 0, Q(1)}};
#define NO TIA_NO_INDEX
#define FACE(a, b, c)                                                                                                  \
    {                                                                                                                  \
        {                                                                                                              \
            {a, NO, NO}, {b, NO, NO},                                                                                  \
            {                                                                                                          \
                c, NO, NO                                                                                              \
            }                                                                                                          \
        }                                                                                                              \
    }
static const struct tia_face tetrahedron_faces[] = {FACE(0, 2, 1), FACE(0, 1, 3), FACE(0, 3, 2), FACE(1, 2, 3)};
static const struct tia_mesh tetrahedron = {
    .vertices = tetrahedron_points, .faces = tetrahedron_faces, .vertex_count = 4, .face_count = 4};
static const uint8_t cells[8] = {1, 0, 1, 1, 0, 1, 0, 1};
static const struct tia_grid grid = {{Q(-0.5), Q(-0.5), Q(-0.5)}, Q(0.5), {2, 2, 2}, cells};
static const struct tia_material white = {.colour = {TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE}};
static const struct tia_light lights[] = {
    {.kind = TIA_POINT_LIGHT, .centre = {Q(3), Q(7), Q(5)}, .emission = {1 << 29, 1 << 29, 1 << 29}},
    {.kind = TIA_DIRECTIONAL_LIGHT,
     .direction = {TIA_Q30(0.5), TIA_Q30(-0.75), TIA_Q30(-0.25)},
     .emission = {1 << 28, 1 << 28, 1 << 28}},
    {.kind = TIA_SPOT_LIGHT,
     .centre = {Q(-4), Q(6), Q(2)},
     .direction = {TIA_Q30(0.5), TIA_Q30(-0.75), TIA_Q30(-0.25)},
     .inner = Q(20),
     .outer = Q(40),
     .emission = {1 << 28, 1 << 28, 1 << 28}},
};

struct world {
    struct tia_scene scene;
    struct tia_sphere spheres[SPHERES];
    struct tia_shape shapes[SHAPES];
    struct tia_transform transforms[SHAPES];
};

static tia_q16 within(double range)
{
    return (tia_q16)(random_double() * range * 65536);
}

static tia_q16 between(double low, double high)
{
    return (tia_q16)((low + (high - low) * (random_double() + 1) / 2) * 65536);
}

static struct tia_vec3 somewhere(double range)
{
    return (struct tia_vec3){within(range), within(range), within(range)};
}

static void make_shape(struct tia_shape *s, enum tia_shape_kind kind)
{
    static const struct tia_shape plain[] = {
        [TIA_SPHERE] = {.kind = TIA_SPHERE, .sphere = {{0, 0, 0}, Q(0.7)}},
        [TIA_PLANE] = {.kind = TIA_PLANE, .plane = {{0, Q(-2.5), 0}, {0, TIA_Q30_ONE, 0}}},
        [TIA_DISC] = {.kind = TIA_DISC, .disc = {{0, 0, 0}, {0, TIA_Q30_ONE, 0}, Q(0.8)}},
        [TIA_CYLINDER] = {.kind = TIA_CYLINDER, .cylinder = {{0, Q(-0.7), 0}, {0, Q(0.7), 0}, Q(0.4), true}},
        [TIA_CONE] = {.kind = TIA_CONE, .cone = {{0, Q(-0.7), 0}, {0, Q(0.7), 0}, Q(0.6), Q(0.1), false}},
        [TIA_BOX] = {.kind = TIA_BOX, .box = {{Q(-0.5), Q(-0.4), Q(-0.6)}, {Q(0.5), Q(0.4), Q(0.6)}}},
        [TIA_TRIANGLE] = {.kind = TIA_TRIANGLE, .triangle = {{{Q(-1), 0, 0}, {Q(1), 0, Q(0.3)}, {0, Q(1), 0}}}},
        [TIA_MESH] = {.kind = TIA_MESH, .mesh = 0},
        [TIA_GRID] = {.kind = TIA_GRID, .grid = 0},
    };

    *s = plain[kind];
}

/* Makes a ground plane, and two or three shapes of every other kind. */
static void make_world(struct world *w, struct tia_camera camera)
{
    *w = (struct world){.scene = {.camera = camera,
                                  .materials = &white,
                                  .material_count = 1,
                                  .lights = lights,
                                  .light_count = 3,
                                  .meshes = &tetrahedron,
                                  .mesh_count = 1,
                                  .grids = &grid,
                                  .grid_count = 1,
                                  .sphere_count = SPHERES,
                                  .shape_count = SHAPES,
                                  .transform_count = SHAPES}};
    w->scene.spheres = w->spheres;
    w->scene.shapes = w->shapes;
    w->scene.transforms = w->transforms;
    for (int i = 0; i < SPHERES; i++)
        w->spheres[i] = (struct tia_sphere){somewhere(2.5), between(0.2, 0.8), 0};
    for (uint32_t i = 0; i < SHAPES; i++) {
        enum tia_shape_kind kind = (enum tia_shape_kind)(i % (TIA_GRID + 1));
        make_shape(&w->shapes[i], i && kind == TIA_PLANE && i > TIA_PLANE ? TIA_BOX : kind);
        w->shapes[i].transform = w->shapes[i].kind == TIA_PLANE ? 0 : i + 1;
        w->transforms[i] = (struct tia_transform){somewhere(2.5), somewhere(180), {Q(1), Q(1), Q(1)}};
        if (i % 2)
            w->transforms[i].scale = (struct tia_vec3){between(0.3, 1.5), between(0.3, 1.5), between(0.3, 1.5)};
    }
}

static struct tia_camera make_camera(enum tia_projection projection)
{
    static const struct tia_window windows[] = {
        [TIA_FRUSTUM] = {Q(-0.7), Q(0.5), Q(-0.3), Q(0.6), Q(0.75)}, [TIA_ORTHOGRAPHIC] = {0, 0, Q(-4), Q(3.5), 0}};
    struct tia_camera camera = {.fov = Q(60), .projection = projection, .up = {within(0.2), Q(1), 0}};

    camera.eye = (struct tia_vec3){within(4), Q(2) + within(1), Q(7) + within(3)};
    camera.reference = somewhere(1);
    if (projection != TIA_PERSPECTIVE)
        camera.window = windows[projection];
    return camera;
}

#endif
