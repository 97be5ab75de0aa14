/* bytes.h - numbers and scenes from a fuzzer's bytes; after the last byte all bytes are 0. */
#ifndef TESTS_FUZZ_BYTES_H
#define TESTS_FUZZ_BYTES_H

#include <stdlib.h>

#include <tia/tia.h>

struct bytes {
    const uint8_t *next;
    size_t left;
};

static inline uint8_t take_byte(struct bytes *b)
{
    if (!b->left)
        return 0;
    b->left--;
    return *b->next++;
}

static inline uint32_t take_word(struct bytes *b)
{
    uint32_t word = take_byte(b);
    for (int i = 0; i < 3; i++)
        word = word << 8 | take_byte(b);
    return word;
}

/* Takes a number: an integer, a small fraction, a number near a limit, or any number. */
static inline int32_t take_number(struct bytes *b)
{
    static const int32_t limits[] = {0,         TIA_RADIUS_MIN, TIA_Q30_ONE, INT32_MAX,
                                     INT32_MIN, TIA_FOV_MIN,    TIA_FOV_MAX, TIA_Q16_ONE};
    uint8_t kind = take_byte(b);

    switch (kind & 3) {
    case 0:
        return (int32_t)((uint32_t)(int8_t)take_byte(b) << 16);
    case 1:
        return (int8_t)take_byte(b) * (1 << (kind >> 2 & 15));
    case 2:
        return (int32_t)((uint32_t)limits[kind >> 2 & 7] + (uint32_t)(int8_t)take_byte(b));
    default:
        return (int32_t)take_word(b);
    }
}

/* Takes a Q2.30 channel in [0, 1], or, one time in eight, any number. */
static inline tia_q30 take_channel(struct bytes *b)
{
    uint8_t value = take_byte(b);
    return value % 8 == 7 ? take_number(b) : (value >> 3) * (TIA_Q30_ONE / 31);
}

static inline struct tia_rgb take_rgb(struct bytes *b)
{
    tia_q30 r = take_channel(b), g = take_channel(b);
    return (struct tia_rgb){r, g, take_channel(b)};
}

static inline struct tia_vec3 take_vec3(struct bytes *b)
{
    tia_q16 x = take_number(b), y = take_number(b);
    return (struct tia_vec3){x, y, take_number(b)};
}

static inline struct tia_light take_light(struct bytes *b)
{
    struct tia_vec3 centre = take_vec3(b);
    tia_q16 radius = take_number(b);
    return (struct tia_light){centre, radius, take_rgb(b)};
}

#define FUZZ_MATERIALS 3
#define FUZZ_SPHERES 6
#define FUZZ_LIGHTS 3

struct fuzz_scene {
    struct tia_scene scene;
    struct tia_material materials[FUZZ_MATERIALS];
    struct tia_sphere spheres[FUZZ_SPHERES];
    struct tia_light lights[FUZZ_LIGHTS];
    struct tia_binding bindings[1];
};

static inline void take_scene(struct bytes *b, struct fuzz_scene *s)
{
    uint8_t counts = take_byte(b), fov = take_byte(b);

    s->scene = (struct tia_scene){.materials = s->materials,
                                  .spheres = s->spheres,
                                  .lights = s->lights,
                                  .bindings = s->bindings,
                                  .material_count = FUZZ_MATERIALS,
                                  .sphere_count = counts % (FUZZ_SPHERES + 1),
                                  .light_count = counts / 8 % (FUZZ_LIGHTS + 1),
                                  .binding_count = counts / 32 % 2};
    s->scene.camera.eye = take_vec3(b);
    s->scene.camera.fov = fov < 171 ? fov << 16 : take_number(b);
    s->scene.background = take_rgb(b);
    for (uint32_t i = 0; i < FUZZ_MATERIALS; i++) {
        s->materials[i] = (struct tia_material){.colour = take_rgb(b)};
        s->materials[i].transmission = counts & 64 ? take_rgb(b) : (struct tia_rgb){0, 0, 0};
        s->materials[i].emission = counts & 128 ? take_rgb(b) : (struct tia_rgb){0, 0, 0};
    }
    for (uint32_t i = 0; i < s->scene.sphere_count; i++) {
        s->spheres[i].centre = take_vec3(b);
        s->spheres[i].radius = take_number(b);
        uint8_t material = take_byte(b);
        s->spheres[i].material = material % 64 ? material % FUZZ_MATERIALS : take_word(b);
    }
    for (uint32_t i = 0; i < s->scene.light_count; i++)
        s->lights[i] = take_light(b);
    s->bindings[0] = (struct tia_binding){take_byte(b), take_byte(b), take_light(b)};
}

/* Ends a fuzzer if a condition fails; libFuzzer then saves the bytes. */
#define MUST(condition)                                                                                                \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            (void)fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition);                              \
            abort();                                                                                                   \
        }                                                                                                              \
    } while (0)

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#endif
