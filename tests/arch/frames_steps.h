/* frames_steps.h - a scene with inputs, step by step: its hashes are pinned in tests/golden/steps.hash, and
 * tests/arch/peer.c plays it. */
#ifndef TESTS_ARCH_FRAMES_STEPS_H
#define TESTS_ARCH_FRAMES_STEPS_H

#include <stdlib.h>
#include <string.h>
#include <tia/step.h>

#include "common/corpus/dice.h"

enum {
    STEPS_BALLS = 5,
    STEPS_PUSHES = 2, /* at most, of a player in a step */
    STEPS_STATE = TIA_STEPS_HEAD + STEPS_BALLS * TIA_STEPS_BALL,
    STEPS_PINNED = 2048,
    STEPS_APART = 256 /* of those whose hashes are pinned */
};

#define STEPS_SPEED (6 * INT32_C(65536)) /* largest component of a push */

/* Returns a closed room with a turned box, and balls in it; one appears after a second, and the box vanishes and comes
 * back. */
static inline struct tia_scene steps_scene(void)
{
#define STEPS_BALL(n, x, y, z)                                                                                         \
    {                                                                                                                  \
        TIA_SPHERE, 0, n, .sphere = { {(x), (y), (z)}, 30000 + n * 4000 }                                              \
    }
#define STEPS_WALL(x, y, z, a, b, c)                                                                                   \
    {                                                                                                                  \
        TIA_PLANE, 0, 0, .plane = { {(x), (y), (z)}, {(a)*TIA_Q30_ONE, (b)*TIA_Q30_ONE, (c)*TIA_Q30_ONE} }             \
    }
#define STEPS_AT(rx, ry, rz)                                                                                           \
    {                                                                                                                  \
        {0, 0, 0}, {rx, ry, rz},                                                                                       \
        {                                                                                                              \
            TIA_Q16_ONE, TIA_Q16_ONE, TIA_Q16_ONE                                                                      \
        }                                                                                                              \
    }
    static const struct tia_transform transforms[] = {STEPS_AT(0, 0, 0), STEPS_AT(0, 0, 0),
                                                      STEPS_AT(0, 0, 0), STEPS_AT(0, 0, 0),
                                                      STEPS_AT(0, 0, 0), STEPS_AT(1000000, 655360, -1310720)};
    static const struct tia_shape shapes[] = {STEPS_BALL(1, -110000, 200000, 0),
                                              STEPS_BALL(2, 40000, 150000, 2000),
                                              STEPS_BALL(3, 20000, 20000, -123000),
                                              STEPS_BALL(4, 100000, -100000, 90000),
                                              STEPS_BALL(5, -100000, -90000, 70000),
                                              {TIA_BOX, 0, 6, .box = {{-60000, -30000, -60000}, {60000, 30000, 60000}}},
                                              STEPS_WALL(-200000, 0, 0, 1, 0, 0),
                                              STEPS_WALL(200000, 0, 0, -1, 0, 0),
                                              STEPS_WALL(0, -200000, 0, 0, 1, 0),
                                              STEPS_WALL(0, 300000, 0, 0, -1, 0),
                                              STEPS_WALL(0, 0, -200000, 0, 0, 1),
                                              STEPS_WALL(0, 0, 200000, 0, 0, -1)};
    static const struct tia_keyframe late[] = {{0, {0, 0, 0}}, {65536, {1, 0, 0}}};
    static const struct tia_keyframe box[] = {{0, {1, 0, 0}}, {170000, {0, 0, 0}}, {500000, {1, 0, 0}}};
    static const struct tia_track tracks[] = {{TIA_SHOWS_SHAPE, 4, false, late, 2},
                                              {TIA_SHOWS_SHAPE, 5, false, box, 3}};
    static const struct tia_fall falls[] = {{0, {30000, 0, 1000}, 65536, TIA_Q16_ONE},
                                            {1, {131072, 60000, 0}, 60000, 90000},
                                            {2, {0, -90000, 0}, 50000, 50000},
                                            {3, {0, 200000, -90000}, 65000, 30000},
                                            {4, {90000, 0, 90000}, 62000, 65536}};
    static const struct tia_falling falling = {falls, STEPS_BALLS, {0, -642253, 3000}, TIA_FALL_END_MAX};
    static const struct tia_material material = {.colour = {1 << 29, 1 << 29, 1 << 29}};
    static const struct tia_mesh nothing = {0};
    return (struct tia_scene){.camera = {.eye = {0, 0, 700000}, .up = {0, TIA_Q16_ONE, 0}, .fov = 2000000},
                              .materials = &material,
                              .material_count = 1,
                              .shapes = shapes,
                              .shape_count = sizeof shapes / sizeof shapes[0],
                              .transforms = transforms,
                              .transform_count = sizeof transforms / sizeof transforms[0],
                              .meshes = &nothing,
                              .mesh_count = 1,
                              .tracks = tracks,
                              .track_count = 2,
                              .falling = &falling};
#undef STEPS_BALL
#undef STEPS_WALL
#undef STEPS_AT
}

/* Makes a player's inputs of a step; most have none. Returns their number. */
static inline uint32_t steps_pushes(uint64_t *dice, struct tia_push pushes[STEPS_PUSHES])
{
    const struct tia_vec3 low = {-STEPS_SPEED, -STEPS_SPEED, -STEPS_SPEED},
                          high = {STEPS_SPEED, STEPS_SPEED, STEPS_SPEED};
    uint32_t count = dice_one_in(dice, 25) ? (uint32_t)dice_between(dice, 1, STEPS_PUSHES) : 0;

    for (uint32_t i = 0; i < count; i++) {
        pushes[i].ball = (uint32_t)dice_between(dice, 0, STEPS_BALLS - 1);
        pushes[i].velocity = dice_vec3(dice, low, high);
    }
    return count;
}

static inline void steps_begin(struct tia_steps *steps, const struct tia_scene *scene, void *memory, size_t size)
{
    memset(memory, 0x5a, size);
    if (tia_steps_init(steps, memory, size, scene))
        abort();
}

/* Moves the state to other memory, or back, where a few steps of another course have been done. */
static inline void steps_move(struct tia_steps *steps, void *memory, size_t size)
{
    const struct tia_push push = {1, {70000, 0, 0}};
    uint8_t state[STEPS_STATE];
    struct tia_steps moved;

    steps_begin(&moved, steps->scene, memory, size);
    if (tia_steps_save(steps, state, sizeof state) || tia_scene_step(&moved, &push, 1) ||
        tia_scene_step(&moved, NULL, 0) || tia_steps_restore(&moved, state, sizeof state))
        abort();
    *steps = moved;
}

/* Reports the hash at some steps of a course, during which the state is saved and restored. */
static inline void steps_all(void (*report)(void *ctx, uint32_t step, uint64_t hash), void *ctx)
{
    static uint64_t memory[2][1024];
    const struct tia_scene scene = steps_scene();
    struct tia_steps steps;
    uint64_t dice = 1, moves = 2;
    int at = 0;

    if (tia_scene_check(&scene, NULL))
        abort();
    steps_begin(&steps, &scene, memory[at], sizeof memory[at]);
    for (uint32_t n = 0; n <= STEPS_PINNED; n++) {
        struct tia_push pushes[STEPS_PUSHES];
        uint32_t count = steps_pushes(&dice, pushes);
        if (n % STEPS_APART == 0)
            report(ctx, n, tia_steps_hash(&steps));
        if (dice_one_in(&moves, 16)) {
            at = !at;
            steps_move(&steps, memory[at], sizeof memory[at]);
        }
        if (tia_scene_step(&steps, pushes, count))
            abort();
    }
}

#endif
