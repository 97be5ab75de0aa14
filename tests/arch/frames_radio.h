/* frames_radio.h - checksums of the paths of radio waves, whose bits are the same on every processor. */
#ifndef TESTS_ARCH_FRAMES_RADIO_H
#define TESTS_ARCH_FRAMES_RADIO_H

#include <tia/radio.h>

#include "frames_canvas.h"

enum { FRAMES_RADIO_DENSITY = 6 };

struct frames_radio_sum {
    uint32_t crc, count;
};

static inline void frames_radio_add(struct frames_radio_sum *sum, int64_t value)
{
    tia_rgb565 words[4];

    for (int i = 0; i < 4; i++)
        words[i] = (tia_rgb565)((uint64_t)value >> 16 * i);
    sum->crc = tia_crc32(sum->crc, words, 4);
}

static inline bool frames_radio_path(void *ctx, const struct tia_radio_path *path)
{
    struct frames_radio_sum *sum = ctx;

    sum->count++;
    frames_radio_add(sum, path->length);
    for (uint32_t i = 0; i < path->order; i++) {
        frames_radio_add(sum, path->face[i]);
        frames_radio_add(sum, path->point[i].x);
        frames_radio_add(sum, path->point[i].y);
        frames_radio_add(sum, path->point[i].z);
    }
    for (uint32_t i = 0; i <= path->order; i++)
        for (int k = 0; k < 3; k++)
            frames_radio_add(sum, path->direction[i][k]);
    for (uint32_t i = 0; i < path->wall_count; i++)
        frames_radio_add(sum, (int64_t)path->wall[i].face << 8 | path->wall[i].segment);
    return true;
}

static inline bool frames_radio_ray(void *ctx, const struct tia_radio_ray *ray)
{
    frames_radio_add(ctx, ray->miss);
    return frames_radio_path(ctx, &ray->path);
}

/* Reports the paths between a ground, turned and plain blocks, a slanting triangle and a disc. */
static inline void frames_radio(struct frames_canvas *c)
{
    static const struct tia_material material = {.index = TIA_Q16_ONE};
    static const struct tia_transform transforms[] = {
        {TIA_VEC3(4, 2, -3), TIA_VEC3(10, 33, 5), TIA_VEC3(1, 1, 1)},
        {TIA_VEC3(-5, 3, 6), TIA_VEC3(0, -17.3, 0), TIA_VEC3(1.5, 2, 0.75)}};
    static const struct tia_shape shapes[] = {
        {.kind = TIA_PLANE, .plane = {TIA_VEC3(0, 0, 0), {0, TIA_Q30_ONE, 0}}},
        {.kind = TIA_PLANE, .plane = {TIA_VEC3(-12, 0, 0.1), {TIA_Q30(0.96), TIA_Q30(0.03), TIA_Q30(0.27)}}},
        {.kind = TIA_BOX, .transform = 1, .box = {TIA_VEC3(-1, -1.5, -2), TIA_VEC3(1, 1.5, 2)}},
        {.kind = TIA_BOX, .transform = 2, .box = {TIA_VEC3(-1, -1.5, -2), TIA_VEC3(1, 1.5, 2)}},
        {.kind = TIA_BOX, .box = {TIA_VEC3(9, 0.5, -8), TIA_VEC3(10, 7, 8)}},
        {.kind = TIA_TRIANGLE, .triangle = {{TIA_VEC3(-20, 9, -20), TIA_VEC3(20.3, 11, -19), TIA_VEC3(1, 8, 25)}}},
        {.kind = TIA_DISC, .disc = {TIA_VEC3(0, 4, -9), {TIA_Q30(0.1), 0, TIA_Q30(0.99)}, TIA_Q16(3.5)}}};
    const struct tia_scene scene = {.materials = &material,
                                    .material_count = 1,
                                    .shapes = shapes,
                                    .shape_count = sizeof shapes / sizeof *shapes,
                                    .transforms = transforms,
                                    .transform_count = 2};
    struct frames_radio_sum sum = {0, 0};
    struct tia_radio_link link = {TIA_VEC3(1.7, 1.5, 3.3), TIA_VEC3(-2.1, 2.25, -4.7), 4, 1, frames_radio_path, &sum};
    size_t size = tia_radio_size(&scene);
    void *memory = malloc(size);
    struct tia_radio_room *room = malloc(tia_radio_room_size());
    struct tia_radio *radio;

    if (memory && room && !tia_radio_init(&radio, memory, size, &scene, NULL)) {
        (void)tia_radio_images(radio, room, &link);
        c->report(c->ctx, "radio-images", sum.crc ^ sum.count);
        sum = (struct frames_radio_sum){0, 0};
        for (uint32_t i = 0; i < tia_radio_directions(FRAMES_RADIO_DENSITY); i++)
            (void)tia_radio_shoot(radio, room, &link, FRAMES_RADIO_DENSITY, i, false, frames_radio_ray, &sum);
        c->report(c->ctx, "radio-rays", sum.crc ^ sum.count);
    }
    free(memory);
    free(room);
}

#endif
