/* frames_canvas.h - a small picture of a scene in memory, whose checksum is reported. */
#ifndef TESTS_ARCH_FRAMES_CANVAS_H
#define TESTS_ARCH_FRAMES_CANVAS_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <tia/debug.h>
#include <tia/tia.h>

/* Receives each frame's name and CRC-32. */
typedef void frames_report(void *ctx, const char *name, uint32_t crc);

struct frames_canvas {
    const struct tia_core *core;
    struct tia_tile area;
    struct tia_view *view;
    struct tia_hits *hits;
    tia_rgb565 *pixels;
    void *memory[2];
    frames_report *report;
    void *ctx;
};

static inline void frames_close(struct frames_canvas *c)
{
    free(c->memory[0]);
    free(c->memory[1]);
    free(c->pixels);
}

/* Opens a canvas; returns 0 when the scene is refused or memory is short. */
static inline int frames_open(struct frames_canvas *c, const struct tia_scene *scene, unsigned width, unsigned height)
{
    const struct tia_core *core = c->core;
    uint32_t lights = scene->light_count + 1;
    size_t view = core->view_size(core, scene, lights), hits;

    c->area = (struct tia_tile){0, 0, (uint16_t)width, (uint16_t)height};
    hits = core->hits_size(core, scene, c->area);
    c->memory[0] = malloc(view);
    c->memory[1] = malloc(hits);
    c->pixels = calloc((size_t)width * height, sizeof *c->pixels);
    return c->memory[0] && c->memory[1] && c->pixels &&
           !core->view_init(core, &c->view, c->memory[0], view, scene, lights, width, height, NULL) &&
           !tia_hits_init(&c->hits, c->memory[1], hits, c->view, c->area);
}

/* Draws in tiles of the given size, the last tile first. */
static inline void frames_draw(struct frames_canvas *c, unsigned tile_width, unsigned tile_height, bool trace,
                               bool dither)
{
    const unsigned width = c->area.width, height = c->area.height;
    const unsigned columns = (width + tile_width - 1) / tile_width, rows = (height + tile_height - 1) / tile_height;

    for (unsigned n = columns * rows; n-- > 0;) {
        unsigned x = n % columns * tile_width, y = n / columns * tile_height;
        struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)(width - x < tile_width ? width - x : tile_width),
                                (uint16_t)(height - y < tile_height ? height - y : tile_height)};
        struct tia_surface surface = {
            .pixels = c->pixels + (size_t)y * width + x, .step = 2, .pitch = (ptrdiff_t)width * 2};
        struct tia_options options = {dither, NULL};
        int status = trace ? tia_view_trace(c->view, c->hits, tile) : TIA_OK;
        if (status || tia_view_light(c->view, c->hits, tile, &surface, &options))
            abort();
    }
}

static inline void frames_tell(struct frames_canvas *c, const char *name)
{
    c->report(c->ctx, name, tia_crc32(0, c->pixels, (size_t)c->area.width * c->area.height));
}

#endif
