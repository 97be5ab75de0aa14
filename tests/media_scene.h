/* media_scene.h - a few shapes on an eye's line of sight, drawn in fixed point, in double precision and by the
 * oracle. */
#ifndef TESTS_MEDIA_SCENE_H
#define TESTS_MEDIA_SCENE_H

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "oracle/oracle.h"

#define Q16(x) ((tia_q16)lround((x)*65536))
#define DEGREES (3.14159265358979323846 / 180)
#define RED 0xf800

enum { GLASS, WATER, AIR, LAMP, PANE, FLOOR, MATERIALS };

static struct tia_material materials[MATERIALS];
static struct tia_shape shapes[300];
static struct tia_light light;
static struct tia_mesh mesh;
static struct tia_grid grid;
static struct tia_scene scene;

static const struct tia_core *const cores[] = {&tia_core_q16, &oracle_core,
#ifdef TIA_HAVE_F64
                                               &tia_core_f64
#endif
};

/* Draws a square picture of an area 2 wide and high around the line of sight. */
static void draw(const struct tia_core *core, unsigned size, tia_rgb565 *pixels)
{
    const struct tia_tile all = {0, 0, (uint16_t)size, (uint16_t)size};
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = (ptrdiff_t)size * 2};
    size_t view_size = core->view_size(core, &scene, 1), hits_size = core->hits_size(core, &scene, all);
    void *memory[2] = {malloc(view_size), malloc(hits_size)};
    const struct tia_options plain = {.debug = NULL};
    struct tia_view *view;
    struct tia_hits *hits;

    CHECK_EQ(core->view_init(core, &view, memory[0], view_size, &scene, 1, size, size, NULL), TIA_OK);
    if (!check_failed)
        CHECK_EQ(tia_hits_init(&hits, memory[1], hits_size, view, all), TIA_OK);
    if (!check_failed) {
        CHECK_EQ(tia_view_trace(view, hits, all), TIA_OK);
        CHECK_EQ(tia_view_light(view, hits, all, &surface, &plain), TIA_OK);
    }
    free(memory[0]);
    free(memory[1]);
}

/* Checks the colour of a ray in every arithmetic. The ray starts at (x, y, z) and runs parallel to the plane of y and
 * z, `degrees` above the direction -z. */
static void see(double x, double y, double z, double degrees, tia_rgb565 want)
{
    tia_rgb565 pixel = 1;
    struct tia_fault fault = {0};

    scene.camera.eye = (struct tia_vec3){Q16(x), Q16(y), Q16(z)};
    scene.camera.reference =
        (struct tia_vec3){Q16(x), Q16(y + 100 * sin(degrees * DEGREES)), Q16(z - 100 * cos(degrees * DEGREES))};
    CHECK_MSG(!tia_scene_check(&scene, &fault), "%s %u: %s: %s", fault.thing, fault.index, fault.field, fault.rule);
    for (size_t i = 0; i < sizeof cores / sizeof cores[0] && !check_failed; i++) {
        draw(cores[i], 1, &pixel);
        CHECK_MSG(pixel == want, "%s: 0x%04x, not 0x%04x", cores[i]->name, pixel, want);
    }
}

static void begin(void)
{
    memset(materials, 0, sizeof materials);
    memset(shapes, 0, sizeof shapes);
    for (int i = GLASS; i <= PANE; i++)
        materials[i].refraction = (struct tia_rgb)TIA_RGB(1, 1, 1);
    materials[GLASS].index = TIA_Q16(1.5);
    materials[WATER].index = TIA_Q16(1.25);
    materials[AIR].index = materials[PANE].index = TIA_Q16(1);
    materials[PANE].transmission = (struct tia_rgb)TIA_RGB(0.5, 0.5, 0.5);
    materials[LAMP] = (struct tia_material){.emission = TIA_RGB(1, 0, 0)};
    materials[FLOOR].colour = (struct tia_rgb)TIA_RGB(1, 1, 1);
    scene = (struct tia_scene){
        .camera = {.up = TIA_VEC3(0, 1, 0),
                   .projection = TIA_ORTHOGRAPHIC,
                   .window = {.left = TIA_Q16(-1), .right = TIA_Q16(1), .bottom = TIA_Q16(-1), .top = TIA_Q16(1)}},
        .depth = 16,
        .materials = materials,
        .shapes = shapes,
        .lights = &light,
        .meshes = &mesh,
        .grids = &grid,
        .material_count = MATERIALS};
    light = (struct tia_light){.kind = TIA_POINT_LIGHT, .emission = TIA_RGB(1, 1, 1)};
}

static inline struct tia_shape *add(enum tia_shape_kind kind, uint32_t material)
{
    struct tia_shape *s = &shapes[scene.shape_count++];

    s->kind = kind;
    s->material = material;
    return s;
}

static void add_ball(double y, double z, double radius, uint32_t material)
{
    struct tia_shape *s = add(TIA_SPHERE, material);

    s->sphere.centre = (struct tia_vec3){0, Q16(y), Q16(z)};
    s->sphere.radius = Q16(radius);
}

/* Adds a slab from z = -near to z = -far. */
static void add_slab(double near, double far, uint32_t material)
{
    struct tia_shape *s = add(TIA_BOX, material);

    s->box = (struct tia_box){{TIA_Q16(-50), TIA_Q16(-50), Q16(-far)}, {TIA_Q16(50), TIA_Q16(50), Q16(-near)}};
}

#endif
