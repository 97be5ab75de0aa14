/* picture_memory.h - a scene drawn into memory of exactly the size that the library requires. */
#ifndef TESTS_FUZZ_PICTURE_MEMORY_H
#define TESTS_FUZZ_PICTURE_MEMORY_H

#include <stdio.h>
#include <string.h>
#include <tia/debug.h>

#include "bytes.h"

void tia_chk_report(const char *file, int line, const char *range);

void tia_chk_report(const char *file, int line, const char *range)
{
    (void)fprintf(stderr, "%s:%d: out of range: %s\n", file, line, range);
    abort();
}

struct picture {
    const struct tia_core *core;
    struct tia_view *view;
    struct tia_hits *hits;
    struct tia_tile tile;
    tia_rgb565 *pixels;
    uint32_t *path_hash;
    void *memory[2];
};

/* Opens a picture of a tile of an image, and traces it. */
static inline void open_picture(struct picture *p, const struct tia_core *core, const struct tia_scene *scene,
                                unsigned width, unsigned height, struct tia_tile tile)
{
    size_t view = core->view_size(core, scene, scene->light_count), hits = core->hits_size(core, scene, tile);
    size_t count = (size_t)tile.width * tile.height;

    p->core = core;
    p->tile = tile;
    p->memory[0] = malloc(view);
    p->memory[1] = malloc(hits);
    p->pixels = malloc(count * sizeof *p->pixels);
    p->path_hash = malloc(count * sizeof *p->path_hash);
    MUST(p->memory[0] && p->memory[1] && p->pixels && p->path_hash);
    MUST(!core->view_init(core, &p->view, p->memory[0], view, scene, scene->light_count, width, height, NULL));
    MUST(!tia_hits_init(&p->hits, p->memory[1], hits, p->view, tile));
    MUST(!tia_view_trace(p->view, p->hits, tile));
}

static inline void light_picture(struct picture *p, bool dither)
{
    struct tia_surface surface = {.pixels = p->pixels, .step = 2, .pitch = p->tile.width * 2};
    struct tia_options options = {.dither = dither, .debug = &(struct tia_debug){.path_hash = p->path_hash}};

    MUST(!tia_view_light(p->view, p->hits, p->tile, &surface, &options));
}

static inline void close_picture(struct picture *p)
{
    free(p->memory[0]);
    free(p->memory[1]);
    free(p->pixels);
    free(p->path_hash);
}

static inline void must_see_objects(const struct picture *p, const struct tia_scene *scene)
{
    for (unsigned i = 0; i < (unsigned)p->tile.width * p->tile.height; i++) {
        uint32_t object = tia_hits_object(p->hits, p->tile.x + i % p->tile.width, p->tile.y + i / p->tile.width);
        MUST(object == TIA_NO_OBJECT || object < scene->sphere_count + scene->shape_count);
    }
}

/* Checks that pixels and path hashes are the same. */
static inline void must_be_same(const struct picture *p, const struct picture *q)
{
    size_t count = (size_t)p->tile.width * p->tile.height;

    MUST(!memcmp(p->pixels, q->pixels, count * sizeof *p->pixels));
    MUST(!memcmp(p->path_hash, q->path_hash, count * sizeof *p->path_hash));
}

#endif
