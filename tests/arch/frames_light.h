/* frames_light.h - the frames of frames.h that are drawn in samples: occlusion and paths, every lobe, every kind of
 * light, every tone; and sums of samples. */
#ifndef TESTS_ARCH_FRAMES_LIGHT_H
#define TESTS_ARCH_FRAMES_LIGHT_H

#include "common/corpus/corpus_rays.h"
#include "frames_canvas.h"

#define FRAMES_SUMS_WIDTH 17
#define FRAMES_SUMS_HEIGHT 13
#define FRAMES_SUMS_SAMPLES 8

#define FRAMES_GREY(x)                                                                                                 \
    {                                                                                                                  \
        TIA_Q30(x), TIA_Q30(x), TIA_Q30(x)                                                                             \
    }
#define FRAMES_VEC(x, y, z)                                                                                            \
    {                                                                                                                  \
        TIA_Q16(x), TIA_Q16(y), TIA_Q16(z)                                                                             \
    }

enum { FRAMES_MATT, FRAMES_RED, FRAMES_MIRROR, FRAMES_GLASS, FRAMES_GLOSSY, FRAMES_GLOW, FRAMES_CHECKED };

static const struct tia_texture frames_checker = {
    .repeat = {TIA_Q16(4), TIA_Q16(4)}, .cells = {FRAMES_GREY(0.75), {TIA_Q30(0.25), TIA_Q30(0.375), TIA_Q30(0.75)}}};

static const struct tia_material frames_materials[] = {
    [FRAMES_MATT] = {.colour = {TIA_Q30(0.75), TIA_Q30(0.6875), TIA_Q30(0.625)}},
    [FRAMES_RED] = {.colour = {TIA_Q30(0.625), TIA_Q30(0.0625), TIA_Q30(0.0625)}},
    [FRAMES_MIRROR] = {.mirror = FRAMES_GREY(0.875)},
    [FRAMES_GLASS] = {.refraction = FRAMES_GREY(0.96875), .index = TIA_Q16(1.5), .fresnel = true},
    [FRAMES_GLOSSY] = {.colour = {TIA_Q30(0.25), TIA_Q30(0.375), TIA_Q30(0.5)},
                       .specular = FRAMES_GREY(0.375),
                       .exponent = TIA_Q16(37.5)},
    [FRAMES_GLOW] = {.emission = {TIA_Q30(0.875), TIA_Q30(0.75), TIA_Q30(0.5)}, .emission_bits = 4},
    [FRAMES_CHECKED] = {.colour = FRAMES_GREY(1), .texture = 1},
};

/* A room of planes: x and y from -1 to 1, z from -1 on. */
static const struct tia_shape frames_walls[] = {
    {.kind = TIA_PLANE, .material = FRAMES_CHECKED, .plane = {FRAMES_VEC(0, -1, 0), {0, TIA_Q30(1), 0}}},
    {.kind = TIA_PLANE, .plane = {FRAMES_VEC(0, 1, 0), {0, -TIA_Q30(1), 0}}},
    {.kind = TIA_PLANE, .material = FRAMES_RED, .plane = {FRAMES_VEC(-1, 0, 0), {TIA_Q30(1), 0, 0}}},
    {.kind = TIA_PLANE, .plane = {FRAMES_VEC(1, 0, 0), {-TIA_Q30(1), 0, 0}}},
    {.kind = TIA_PLANE, .plane = {FRAMES_VEC(0, 0, -1), {0, 0, TIA_Q30(1)}}},
    {.kind = TIA_BOX, .material = FRAMES_GLOSSY, .box = {FRAMES_VEC(-0.125, -1, 0.25), FRAMES_VEC(0.25, -0.75, 0.625)}},
};

static const struct tia_sphere frames_balls[] = {
    {FRAMES_VEC(-0.5, -0.625, -0.375), TIA_Q16(0.375), FRAMES_MIRROR},
    {FRAMES_VEC(0.5, -0.625, 0), TIA_Q16(0.375), FRAMES_GLASS},
    {FRAMES_VEC(0.125, -0.5, -0.625), TIA_Q16(0.25), FRAMES_GLOSSY},
    {FRAMES_VEC(-0.75, -0.875, 0.375), TIA_Q16(0.0625), FRAMES_GLOW},
};

static const struct tia_light frames_lamp = {.kind = TIA_RECTANGLE_LIGHT,
                                             .centre = FRAMES_VEC(0, 0.96875, 0),
                                             .side = {FRAMES_VEC(0.375, 0, 0), FRAMES_VEC(0, 0, 0.25)},
                                             .emission = {TIA_Q30(1.25), TIA_Q30(1), TIA_Q30(0.75)},
                                             .emission_bits = 3};

/* A light of each kind. */
static const struct tia_light frames_lamps[] = {
    {.centre = FRAMES_VEC(-0.5, 0.5, 0.5), .emission = {TIA_Q30(0.25), 0, 0}, .radius = TIA_Q16(0.0625)},
    {.kind = TIA_DIRECTIONAL_LIGHT,
     .direction = {TIA_Q30(0.25), -TIA_Q30(0.25), -TIA_Q30(0.75)},
     .emission = {0, 0, TIA_Q30(0.5)}},
    {.kind = TIA_AMBIENT_LIGHT, .emission = FRAMES_GREY(0.375), .radius = TIA_Q16(0.5), .samples = 5},
    {.kind = TIA_SPOT_LIGHT,
     .centre = FRAMES_VEC(0.5, 0.875, 0.25),
     .direction = {0, -TIA_Q30(1), -TIA_Q30(0.125)},
     .inner = TIA_Q16(12),
     .outer = TIA_Q16(30),
     .quadratic = TIA_Q16(0.5),
     .emission = FRAMES_GREY(0.5)},
    {.kind = TIA_RECTANGLE_LIGHT,
     .centre = FRAMES_VEC(-0.9375, 0, 0.125),
     .side = {FRAMES_VEC(0, 0.25, 0), FRAMES_VEC(0, 0.125, 0.25)},
     .emission = FRAMES_GREY(0.3125),
     .emission_bits = 2,
     .samples = 4},
    {.kind = TIA_DISC_LIGHT,
     .centre = FRAMES_VEC(0, 0.5, -0.9375),
     .direction = {0, TIA_Q30(0.25), TIA_Q30(0.875)},
     .radius = TIA_Q16(0.25),
     .emission = {TIA_Q30(0.0625), TIA_Q30(0.375), TIA_Q30(0.125)},
     .emission_bits = 2,
     .samples = 4},
    {.kind = TIA_SPHERE_LIGHT,
     .centre = FRAMES_VEC(0.625, 0.25, -0.5),
     .radius = TIA_Q16(0.125),
     .emission = {TIA_Q30(0.25), TIA_Q30(0.21875), TIA_Q30(0.1875)},
     .emission_bits = 4,
     .samples = 4},
};

/* Returns the room with its lamp, or with one lamp of each kind. */
static inline struct tia_scene frames_room(struct tia_integration how, bool lamps)
{
    return (struct tia_scene){
        .camera = {.eye = FRAMES_VEC(0, 0, 3), .up = {0, TIA_Q16(1), 0}, .fov = TIA_Q16(40)},
        .background = {TIA_Q30(0.125), TIA_Q30(0.1875), TIA_Q30(0.25)},
        .materials = frames_materials,
        .material_count = sizeof frames_materials / sizeof *frames_materials,
        .spheres = frames_balls,
        .sphere_count = sizeof frames_balls / sizeof *frames_balls,
        .shapes = frames_walls,
        .shape_count = sizeof frames_walls / sizeof *frames_walls,
        .lights = lamps ? frames_lamps : &frames_lamp,
        .light_count = lamps ? sizeof frames_lamps / sizeof *frames_lamps : 1,
        .textures = &frames_checker,
        .texture_count = 1,
        .integration = how,
    };
}

static inline void frames_lit(struct frames_canvas *c, const char *name, const struct tia_scene *scene, bool dither)
{
    if (!frames_open(c, scene, 48, 36))
        abort();
    frames_draw(c, 17, 11, true, dither);
    frames_tell(c, name);
    frames_close(c);
}

/* Draws a random scene by another integrator; half of the scenes have opacities. */
static inline void frames_sampled(struct frames_canvas *c, enum tia_integrator integrator, unsigned index)
{
    static struct corpus_rays scene;
    const unsigned width = 11 + index % 3, height = 8 + index % 4;
    char name[40];

    corpus_random_rays(&scene, 565, index);
    if (index % 2)
        corpus_add_opacity(&scene, index);
    scene.scene.integration = (struct tia_integration){
        .integrator = integrator, .spp = 3, .seed = index, .distance = index % 3 ? TIA_Q16(2.5) : 0};
    if (!frames_open(c, &scene.scene, width, height))
        abort();
    frames_draw(c, 5, 7, true, false);
    (void)snprintf(name, sizeof name, "%s-%u-%ux%u", tia_integrator_name(integrator), index, width, height);
    frames_tell(c, name);
    frames_close(c);
}

/* Adds samples first..end - 1 of each pixel of a small room, in tiles of odd sizes, the last tile first. */
static inline void frames_add_samples(enum tia_integrator integrator, uint32_t first, uint32_t end,
                                      struct tia_sum sums[FRAMES_SUMS_WIDTH * FRAMES_SUMS_HEIGHT])
{
    const struct tia_scene scene =
        frames_room((struct tia_integration){.integrator = integrator, .distance = TIA_Q16(0.75)}, false);
    size_t size = tia_view_size(&scene, 1);
    void *memory = malloc(size);
    struct tia_view *view;

    if (!memory || tia_view_init(&view, memory, size, &scene, 1, FRAMES_SUMS_WIDTH, FRAMES_SUMS_HEIGHT, NULL))
        abort();
    for (unsigned i = 9; i-- > 0;) {
        unsigned x = i % 3 * 7, y = i / 3 * 5;
        struct tia_tile tile = {(uint16_t)x, (uint16_t)y, i % 3 < 2 ? 7 : FRAMES_SUMS_WIDTH - 14,
                                i / 3 < 2 ? 5 : FRAMES_SUMS_HEIGHT - 10};
        if (tia_estimator_q16.sample(view, tile, first, end, &sums[y * FRAMES_SUMS_WIDTH + x], FRAMES_SUMS_WIDTH))
            abort();
    }
    free(memory);
}

/* Returns the checksum of sums as little-endian bytes. */
static inline uint32_t frames_sums_crc(const struct tia_sum sums[FRAMES_SUMS_WIDTH * FRAMES_SUMS_HEIGHT])
{
    uint32_t crc = 0;

    for (unsigned i = 0; i < FRAMES_SUMS_WIDTH * FRAMES_SUMS_HEIGHT * 3; i++) {
        uint64_t sum = (uint64_t)sums[i / 3].rgb[i % 3];
        const uint16_t parts[4] = {(uint16_t)sum, (uint16_t)(sum >> 16), (uint16_t)(sum >> 32), (uint16_t)(sum >> 48)};
        crc = tia_crc32(crc, parts, 4);
    }
    return crc;
}

/* Reports the sums themselves, whose parts are drawn out of order. Only the sums of fixed-point numbers are pinned. */
static inline void frames_sums(struct frames_canvas *c, enum tia_integrator integrator)
{
    static const uint32_t parts[][2] = {{3, 7}, {7, FRAMES_SUMS_SAMPLES}, {0, 1}, {1, 3}};
    static struct tia_sum sums[FRAMES_SUMS_WIDTH * FRAMES_SUMS_HEIGHT];
    char name[40];

    if (strcmp(c->core->name, "q16") != 0)
        return;
    memset(sums, 0, sizeof sums);
    for (unsigned i = 0; i < sizeof parts / sizeof *parts; i++)
        frames_add_samples(integrator, parts[i][0], parts[i][1], sums);
    (void)snprintf(name, sizeof name, "%s-sums", tia_integrator_name(integrator));
    c->report(c->ctx, name, frames_sums_crc(sums));
}

static inline void frames_light(struct frames_canvas *c)
{
    static const struct {
        const char *name;
        struct tia_integration how;
        bool lamps, dither;
    } rooms[] = {
        {"room-path", {.integrator = TIA_PATHS, .spp = 8}, false, false},
        {"room-path-linear",
         {.integrator = TIA_PATHS, .spp = 4, .tone = TIA_TONE_LINEAR, .exposure = TIA_Q16(0.75)},
         false,
         true},
        {"room-path-bounces", {.integrator = TIA_PATHS, .spp = 4, .bounces = 2, .seed = 7}, false, true},
        {"room-path-by-lights", {.integrator = TIA_PATHS, .spp = 4, .without = TIA_STRATEGY_SCATTERING}, false, false},
        {"room-path-by-scattering", {.integrator = TIA_PATHS, .spp = 4, .without = TIA_STRATEGY_LIGHTS}, false, false},
        {"lamps-path", {.integrator = TIA_PATHS, .spp = 8, .exposure = -TIA_Q16(0.5)}, true, false},
        {"room-ao", {.integrator = TIA_OCCLUSION, .spp = 8, .distance = TIA_Q16(0.75)}, false, false},
        {"lamps-ao-srgb",
         {.integrator = TIA_OCCLUSION, .spp = 4, .tone = TIA_TONE_SRGB, .distance = TIA_Q16(1.25)},
         true,
         true},
        {"lamps-whitted", {.integrator = TIA_WHITTED}, true, false},
    };

    for (unsigned i = 0; i < sizeof rooms / sizeof *rooms; i++) {
        const struct tia_scene scene = frames_room(rooms[i].how, rooms[i].lamps);
        frames_lit(c, rooms[i].name, &scene, rooms[i].dither);
    }
    for (unsigned i = 0; i < 6; i++)
        frames_sampled(c, TIA_PATHS, i);
    for (unsigned i = 6; i < 10; i++)
        frames_sampled(c, TIA_OCCLUSION, i);
    frames_sums(c, TIA_OCCLUSION);
    frames_sums(c, TIA_PATHS);
}

#endif
