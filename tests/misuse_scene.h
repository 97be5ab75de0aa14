/* misuse_scene.h - a scene with each kind of object, its hierarchy, and its view and hits. */
#ifndef TESTS_MISUSE_SCENE_H
#define TESTS_MISUSE_SCENE_H

#include <tia/tia.h>

#include "misuse.h"

enum { MISUSE_W = 32, MISUSE_H = 24, MISUSE_LIGHTS = 4 };

static char misuse_text[] = "camera eye 0 0 9 fov 40\n"
                            "material m colour 0.9 mirror 0.3\n"
                            "light at 4 5 6\n"
                            "light sphere at 1 5 6 radius 1 samples 4\n"
                            "sphere radius 1 material m\n"
                            "box min -2 -2 -2 max -1 1 1 material m\n"
                            "plane point 0 -1 0 normal 0 1 0 material m\n";

static struct tia_scene misuse_scene;
static struct tia_view *misuse_view;
static struct tia_hits *misuse_hits;
static uint64_t misuse_read_memory[1000], misuse_bvh_memory[1000], misuse_view_memory[4000], misuse_hits_memory[4000],
    misuse_memory[50000];
static tia_rgb565 misuse_pixels[MISUSE_W * MISUSE_H];
static const struct tia_surface misuse_surface = {.pixels = misuse_pixels, .step = 2, .pitch = 2 * MISUSE_W};
static const struct tia_tile misuse_frame = {0, 0, MISUSE_W, MISUSE_H};

#define TILE(x, y, w, h) ((struct tia_tile){x, y, w, h})

static inline struct tia_reader misuse_reader(void)
{
    return (struct tia_reader){.format = TIA_FORMAT_TIA, .text = misuse_text, .length = sizeof misuse_text - 1};
}

/* Reads the scene and builds its hierarchy. */
static inline void misuse_read(void)
{
    struct tia_reader reader = misuse_reader();
    size_t need;

    CHECK_EQ(tia_read(&reader, &misuse_scene, misuse_read_memory, sizeof misuse_read_memory, &need), TIA_OK);
    CHECK_EQ(tia_bvh_build(&misuse_scene.bvh, misuse_bvh_memory, sizeof misuse_bvh_memory, NULL, &misuse_scene, NULL),
             TIA_OK);
}

static inline int misuse_init(struct tia_view **view, void *memory, size_t size, const struct tia_scene *scene,
                              unsigned width, unsigned height)
{
    return tia_view_init(view, memory, size, scene, MISUSE_LIGHTS, width, height, NULL);
}

/* Prepares the scene with a view and hits; no pixel is traced. */
static inline void misuse_prepare(void)
{
    misuse_read();
    CHECK_EQ(
        misuse_init(&misuse_view, misuse_view_memory, sizeof misuse_view_memory, &misuse_scene, MISUSE_W, MISUSE_H),
        TIA_OK);
    memset(misuse_hits_memory, 0x5a, sizeof misuse_hits_memory);
    CHECK_EQ(tia_hits_init(&misuse_hits, misuse_hits_memory, sizeof misuse_hits_memory, misuse_view, misuse_frame),
             TIA_OK);
}

#endif
