/* frames_play.h - the frames of frames.h that show a playing scene. */
#ifndef TESTS_ARCH_FRAMES_PLAY_H
#define TESTS_ARCH_FRAMES_PLAY_H

#include <tia/motion.h>

#include "frames_canvas.h"

/* Returns a scene with events: balls that fall onto a floor, a turned box and each other, one that appears later, a
 * wall that vanishes, a lamp that goes on and a colour that changes. */
static inline struct tia_scene frames_play_scene(void)
{
#define FRAMES_BALL(n, x, y, z)                                                                                        \
    {                                                                                                                  \
        TIA_SPHERE, n % 2, n, .sphere = { {(x), (y), (z)}, 40000 + n * 3000 }                                          \
    }
#define FRAMES_AT(x, y, z)                                                                                             \
    {                                                                                                                  \
        {x, y, z}, {0, 0, 0},                                                                                          \
        {                                                                                                              \
            TIA_Q16_ONE, TIA_Q16_ONE, TIA_Q16_ONE                                                                      \
        }                                                                                                              \
    }
    static const struct tia_transform transforms[] = {
        FRAMES_AT(0, 0, 0),
        FRAMES_AT(9000, 1000, 0),
        FRAMES_AT(0, 0, 0),
        {{-100000, 30000, 0}, {0, 655360, -1310720}, {TIA_Q16_ONE, TIA_Q16_ONE, TIA_Q16_ONE}}};
    static const struct tia_shape shapes[] = {FRAMES_BALL(1, -110000, 200000, 0),
                                              FRAMES_BALL(2, 40000, 150000, 2000),
                                              FRAMES_BALL(3, 20000, 300000, -3000),
                                              {TIA_BOX, 0, 4, .box = {{-60000, -30000, -60000}, {60000, 30000, 60000}}},
                                              {TIA_BOX, 1, 0, .box = {{150000, 0, -90000}, {160000, 200000, 90000}}},
                                              {TIA_PLANE, 0, 0, .plane = {{0, 0, 0}, {0, TIA_Q30_ONE, 0}}}};
    static const struct tia_keyframe wall[] = {{0, {1, 0, 0}}, {70000, {0, 0, 0}}};
    static const struct tia_keyframe late[] = {{0, {0, 0, 0}}, {20000, {1, 0, 0}}};
    static const struct tia_keyframe colour[] = {{0, {TIA_Q30_ONE, 0, 1 << 28}}, {131072, {0, 1 << 29, TIA_Q30_ONE}}};
    static const struct tia_track tracks[] = {{TIA_SHOWS_SHAPE, 4, false, wall, 2},
                                              {TIA_SHOWS_SHAPE, 2, false, late, 2},
                                              {TIA_SHOWS_LIGHT, 1, false, late, 2},
                                              {TIA_SETS_COLOUR, 1, true, colour, 2}};
    static const struct tia_fall falls[] = {{0, {30000, 0, 1000}, 50000, TIA_Q16_ONE},
                                            {1, {131072, 60000, 0}, 60000, 90000},
                                            {2, {0, -90000, 0}, 40000, 50000}};
    static const struct tia_falling falling = {falls, 3, {0, -642253, 3000}, 196608};
    static const struct tia_material materials[] = {{.colour = {1 << 29, 1 << 29, 1 << 29}},
                                                    {.colour = {TIA_Q30_ONE, 0, 0}}};
    static const struct tia_light lights[] = {{{300000, 500000, 300000}, 0, {TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE}},
                                              {{-300000, 300000, 300000}, 0, {1 << 29, 1 << 29, 0}}};
    static const struct tia_mesh nothing = {0};
    return (struct tia_scene){
        .camera = {.eye = {0, 150000, 700000}, .reference = {0, 80000, 0}, .up = {0, TIA_Q16_ONE, 0}, .fov = 2000000},
        .background = {1 << 28, 1 << 28, 1 << 29},
        .materials = materials,
        .material_count = 2,
        .lights = lights,
        .light_count = 2,
        .shapes = shapes,
        .shape_count = 6,
        .transforms = transforms,
        .transform_count = 4,
        .meshes = &nothing,
        .mesh_count = 1,
        .tracks = tracks,
        .track_count = 4,
        .falling = &falling};
#undef FRAMES_BALL
#undef FRAMES_AT
}

/* Draws frames in another order than that of their times. */
static inline void frames_play(struct frames_canvas *c)
{
    const struct tia_scene scene = frames_play_scene();
    static const tia_q16 times[] = {150000, 0, 40000, 80001, 196608};
    size_t size = tia_scene_at_size(&scene);
    void *memory = malloc(size);
    char name[40];

    for (size_t i = 0; i < sizeof times / sizeof times[0]; i++) {
        struct tia_scene now;
        if (!memory || tia_scene_at(&now, memory, size, &scene, times[i], NULL) || !frames_open(c, &now, 40, 30))
            abort();
        frames_draw(c, 40, 30, true, false);
        (void)snprintf(name, sizeof name, "play-%ld-40x30", (long)times[i]);
        frames_tell(c, name);
        frames_close(c);
    }
    free(memory);
}

#endif
