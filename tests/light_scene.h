/* light_scene.h - a small world to measure light in. The probe is a pixel of nearly no width that looks straight down
 * at the origin of a floor z = 0; its samples have a mean and a standard error. */
#ifndef TESTS_LIGHT_SCENE_H
#define TESTS_LIGHT_SCENE_H

#include <math.h>
#include <stdlib.h>
#include <tia/debug.h>
#include <tia/tia.h>

#include "check.h"

#define GREY(x)                                                                                                        \
    (struct tia_rgb)                                                                                                   \
    {                                                                                                                  \
        TIA_Q30(x), TIA_Q30(x), TIA_Q30(x)                                                                             \
    }

enum { WORLD_PARTS = 16 };
static struct tia_scene world;
static struct tia_material world_materials[WORLD_PARTS];
static struct tia_shape world_shapes[WORLD_PARTS];
static struct tia_sphere world_spheres[WORLD_PARTS];
static struct tia_light world_lights[WORLD_PARTS];

/* Begins a world. Material 0 is Lambertian, a grey with the reflectance 1/2. */
static void world_begin(enum tia_integrator integrator)
{
    memset(world_materials, 0, sizeof world_materials);
    memset(world_shapes, 0, sizeof world_shapes);
    memset(world_lights, 0, sizeof world_lights);
    world = (struct tia_scene){.materials = world_materials,
                               .material_count = WORLD_PARTS,
                               .shapes = world_shapes,
                               .spheres = world_spheres,
                               .lights = world_lights,
                               .integration = {.integrator = integrator}};
    world_materials[0].colour = GREY(0.5);
    world.camera = (struct tia_camera){.projection = TIA_ORTHOGRAPHIC,
                                       .eye = {0, 0, TIA_Q16(0.5)},
                                       .reference = {0, 0, 0},
                                       .up = {0, TIA_Q16(1), 0},
                                       .window = {-1, 1, -1, 1, 0}};
}

static inline struct tia_shape *world_shape(enum tia_shape_kind kind, uint32_t material)
{
    struct tia_shape *s = &world_shapes[world.shape_count++];

    s->kind = kind;
    s->material = material;
    return s;
}

static inline void world_plane(double x, double y, double z, double nx, double ny, double nz)
{
    world_shape(TIA_PLANE, 0)->plane =
        (struct tia_plane){{TIA_Q16(x), TIA_Q16(y), TIA_Q16(z)}, {TIA_Q30(nx), TIA_Q30(ny), TIA_Q30(nz)}};
}

static inline struct tia_light *world_light(enum tia_light_kind kind, double x, double y, double z)
{
    struct tia_light *l = &world_lights[world.light_count++];

    *l = (struct tia_light){.kind = kind,
                            .centre = {TIA_Q16(x), TIA_Q16(y), TIA_Q16(z)},
                            .emission = GREY(1),
                            .direction = {0, 0, -TIA_Q30(1)}};
    return l;
}

/* Makes a room of matt walls with three balls below a lamp: a mirror, a glass and a glossy ball. */
static inline void world_room(void)
{
    static const double walls[5][6] = {
        {0, -1, 0, 0, 1, 0}, {0, 1, 0, 0, -1, 0}, {-1, 0, 0, 1, 0, 0}, {1, 0, 0, -1, 0, 0}, {0, 0, -1, 0, 0, 1}};

    world_begin(TIA_PATHS);
    world_materials[0].colour = (struct tia_rgb){TIA_Q30(0.75), TIA_Q30(0.6), TIA_Q30(0.5)};
    world_materials[1].mirror = GREY(0.9);
    world_materials[2] = (struct tia_material){.refraction = GREY(1), .index = TIA_Q16(1.5), .fresnel = true};
    world_materials[3] = (struct tia_material){.colour = GREY(0.4), .specular = GREY(0.4), .exponent = TIA_Q16(50)};
    for (int i = 0; i < 5; i++)
        world_plane(walls[i][0], walls[i][1], walls[i][2], walls[i][3], walls[i][4], walls[i][5]);
    world_spheres[0] = (struct tia_sphere){{-TIA_Q16(0.5), -TIA_Q16(0.6), -TIA_Q16(0.4)}, TIA_Q16(0.35), 1};
    world_spheres[1] = (struct tia_sphere){{TIA_Q16(0.5), -TIA_Q16(0.6), 0}, TIA_Q16(0.35), 2};
    world_spheres[2] = (struct tia_sphere){{0, -TIA_Q16(0.7), TIA_Q16(0.4)}, TIA_Q16(0.25), 3};
    world.sphere_count = 3;
    struct tia_light *lamp = world_light(TIA_RECTANGLE_LIGHT, 0, 0.99, 0);
    lamp->side[0].x = lamp->side[1].z = TIA_Q16(0.3);
    lamp->emission_bits = 3;
    world.camera = (struct tia_camera){.eye = {0, 0, TIA_Q16(3)}, .fov = TIA_Q16(40)};
}

/* A view of the world in one arithmetic. */
struct world_view {
    void *memory;
    struct tia_view *view;
    const struct tia_estimator *estimator;
};

static inline struct world_view world_open(const struct tia_core *core, const struct tia_estimator *estimator,
                                           unsigned width, unsigned height)
{
    struct world_view v = {.estimator = estimator};
    size_t size = core->view_size(core, &world, world.light_count);

    v.memory = malloc(size);
    CHECK_EQ(core->view_init(core, &v.view, v.memory, size, &world, world.light_count, width, height, NULL), TIA_OK);
    return v;
}

static inline void world_close(struct world_view *v)
{
    free(v->memory);
}

/* Draws a picture, and stores the hashes of its paths unless `hashes` is NULL. */
static inline void world_draw(const struct tia_core *core, const struct world_view *v, unsigned width, unsigned height,
                              tia_rgb565 *pixels, uint32_t *hashes)
{
    const struct tia_tile all = {0, 0, (uint16_t)width, (uint16_t)height};
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = (ptrdiff_t)width * 2};
    const struct tia_options options = {.debug = &(struct tia_debug){.path_hash = hashes}};
    size_t size = core->hits_size(core, &world, all);
    void *memory = malloc(size);
    struct tia_hits *hits;

    CHECK_EQ(tia_hits_init(&hits, memory, size, v->view, all), TIA_OK);
    CHECK_EQ(tia_view_trace(v->view, hits, all), TIA_OK);
    CHECK_EQ(tia_view_light(v->view, hits, all, &surface, &options), TIA_OK);
    free(memory);
}

/* Returns the mean of red over `count` samples of the probe's pixel, for one seed. */
static inline double world_mean(uint32_t seed, uint32_t count)
{
    struct tia_sum sum = {{0, 0, 0}};

    world.integration.seed = seed;
    struct world_view v = world_open(&tia_core_q16, &tia_estimator_q16, 1, 1);
    CHECK_EQ(v.estimator->sample(v.view, (struct tia_tile){0, 0, 1, 1}, 0, count, &sum, 1), TIA_OK);
    world_close(&v);
    return (double)sum.rgb[0] / 16777216 / count;
}

struct world_estimate {
    double mean, error; /* error: the standard error of the mean */
};

static inline struct world_estimate world_measure(unsigned seeds, uint32_t count)
{
    double sum = 0, squares = 0;

    for (uint32_t seed = 1; seed <= seeds; seed++) {
        double mean = world_mean(seed, count);
        sum += mean;
        squares += mean * mean;
    }
    double mean = sum / seeds, variance = (squares / seeds - mean * mean) / (seeds - 1);
    return (struct world_estimate){mean, sqrt(variance > 0 ? variance : 0)};
}

enum { SEEDS = 32, SAMPLES = 2048 };
#define LARGEST_ERROR 0.005

static const double pi = 3.14159265358979323846;

static inline void floor_below(enum tia_integrator integrator)
{
    world_begin(integrator);
    world_plane(0, 0, 0, 0, 0, 1);
}

/* Checks that the mean is within three standard errors of `want`, and that the standard error is small. */
#define CHECK_LIGHT(want)                                                                                              \
    do {                                                                                                               \
        struct world_estimate e_ = world_measure(SEEDS, SAMPLES);                                                      \
        double want_ = (want);                                                                                         \
        printf("# %s: %.6f, should be %.6f: relative %+.1e, standard error %.1e\n", __func__, e_.mean, want_,          \
               (e_.mean - want_) / want_, e_.error / want_);                                                           \
        CHECK_MSG(fabs(e_.mean - want_) <= 3 * e_.error + 1e-7 && e_.error < LARGEST_ERROR * want_,                    \
                  "%.6f with a standard error of %.6f, should be %.6f", e_.mean, e_.error, want_);                     \
    } while (0)

#endif
