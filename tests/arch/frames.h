/* frames.h - the frames whose checksums are pinned in tests/golden/frames.crc: small enough for an emulator, and
 * together they cover everything on which pixels depend. */
#ifndef TESTS_ARCH_FRAMES_H
#define TESTS_ARCH_FRAMES_H

#include <tia/bvh.h>

#include "common/corpus/corpus.h"
#include "frames_light.h"
#include "frames_play.h"
#include "frames_radio.h"
#include "frames_shadows.h"

#define FRAMES_RANDOM 20
#define FRAMES_RAYS 20
#define FRAMES_HOLES 8

static inline void frames_keep(void *ctx, const char *name, uint32_t crc)
{
    (void)name;
    *(uint32_t *)ctx = crc;
}

/* Returns the checksum of one picture, drawn in tiles that do not divide it. */
static inline uint32_t frames_checksum(const struct tia_core *core, const struct tia_scene *scene, unsigned width,
                                       unsigned height, bool dither)
{
    uint32_t crc = 0;
    struct frames_canvas canvas = {.core = core, .report = frames_keep, .ctx = &crc};

    if (!frames_open(&canvas, scene, width, height))
        abort();
    frames_draw(&canvas, 61, 47, true, dither);
    frames_tell(&canvas, "");
    frames_close(&canvas);
    return crc;
}

static inline void frames_thesis(struct frames_canvas *c, const char *keys, unsigned width, unsigned height,
                                 unsigned tile_width, unsigned tile_height, bool dither)
{
    struct corpus_scene scene;
    char name[80];

    if (corpus_thesis(&scene, keys, width, height) || !frames_open(c, &scene.scene, width, height))
        abort();
    frames_draw(c, tile_width, tile_height, true, dither);
    (void)snprintf(name, sizeof name, "thesis-%s-%ux%u-tiles-%ux%u%s", *keys ? keys : "dark", width, height, tile_width,
                   tile_height, dither ? "-dithered" : "");
    frames_tell(c, name);
    frames_close(c);
}

/* Draws frames that were traced without a light and then lit, for which the hits alone must suffice; then reports the
 * object of each pixel. */
static inline void frames_relit(struct frames_canvas *c)
{
    struct corpus_scene dark, lit;

    if (corpus_thesis(&dark, "", 200, 150) || corpus_thesis(&lit, "w", 200, 150) ||
        !frames_open(c, &dark.scene, 200, 150))
        abort();
    frames_draw(c, 200, 150, true, false);
    if (tia_view_set_lights(c->view, lit.scene.lights, lit.scene.light_count))
        abort();
    frames_draw(c, 64, 64, false, false);
    frames_tell(c, "thesis-w-200x150-relit");
    for (unsigned i = 0; i < 200 * 150; i++)
        c->pixels[i] = (tia_rgb565)tia_hits_object(c->hits, i % 200, i / 200);
    frames_tell(c, "thesis-200x150-objects");
    frames_close(c);
}

static inline void frames_random(struct frames_canvas *c, unsigned index)
{
    unsigned width = 120 + 7 * index, height = 200 - 5 * index;
    struct corpus_scene scene;
    char name[40];

    corpus_random(&scene, 565, index);
    if (!frames_open(c, &scene.scene, width, height))
        abort();
    frames_draw(c, width, height, true, index % 4 == 3);
    (void)snprintf(name, sizeof name, "random-%u-%ux%u", index, width, height);
    frames_tell(c, name);
    frames_close(c);
}

/* Draws a scene for rays: random shapes, materials, lights and cameras; every other scene has its hierarchy, and with
 * `holes` the materials have opacities. */
static inline void frames_rays(struct frames_canvas *c, unsigned index, bool holes)
{
    static struct corpus_rays scene;
    const unsigned width = 12 + index % 5, height = 9 + index % 4;
    void *memory = NULL;
    char name[40];

    corpus_random_rays(&scene, 565, index);
    if (holes)
        corpus_add_opacity(&scene, index);
    if (index % 2 == 1) {
        size_t size = tia_bvh_size(&scene.scene);
        memory = malloc(size);
        if (!memory || tia_bvh_build(&scene.scene.bvh, memory, size, NULL, &scene.scene, NULL))
            abort();
    }
    if (!frames_open(c, &scene.scene, width, height))
        abort();
    frames_draw(c, 8, 5, true, index % 4 == 3);
    (void)snprintf(name, sizeof name, "%s-%u-%ux%u", holes ? "holes" : "rays", index, width, height);
    frames_tell(c, name);
    frames_close(c);
    free(memory);
}

/* Draws every frame with `core`. */
static inline void frames_all(const struct tia_core *core, frames_report *report, void *ctx)
{
    struct frames_canvas c = {.core = core, .report = report, .ctx = ctx};
    static const char *const keys[] = {"", "a", "d", "s", "w"};

    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++)
        frames_thesis(&c, keys[i], 320, 240, 320, 240, false);
    frames_thesis(&c, "a", 1, 1, 1, 1, false);
    frames_thesis(&c, "d", 1, 480, 1, 16, false);
    frames_thesis(&c, "s", 641, 1, 100, 1, false);
    frames_thesis(&c, "w", 333, 251, 31, 17, false);
    frames_thesis(&c, "a", 8192, 2, 8192, 1, false);
    frames_thesis(&c, "s", 2, 8192, 1, 8192, false);
    frames_thesis(&c, "d", 160, 120, 160, 120, true);
    frames_thesis(&c, "a", 97, 89, 7, 5, true);
    frames_relit(&c);
    for (unsigned i = 0; i < FRAMES_RANDOM; i++)
        frames_random(&c, i);
    for (unsigned i = 0; i < FRAMES_RAYS; i++)
        frames_rays(&c, i, false);
    for (unsigned i = 0; i < FRAMES_HOLES; i++)
        frames_rays(&c, i, true);
    frames_shadows(&c);
    frames_light(&c);
    frames_play(&c);
    frames_radio(&c);
}

#endif
