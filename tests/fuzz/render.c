/* render.c - any scene that tia_scene_check accepts, drawn by q16 and by chk into memory of exactly
 * the size asked for: nothing leaves its range or its memory, both draw the same, and so do hits
 * that are lit a second time. */
#include <stdio.h>
#include <string.h>

#include "bytes.h"

void tia_chk_report(const char *file, int line, const char *range);

void tia_chk_report(const char *file, int line, const char *range)
{
    (void)fprintf(stderr, "%s:%d: out of range: %s\n", file, line, range);
    abort();
}

struct picture {
    struct tia_view *view;
    struct tia_hits *hits;
    struct tia_tile tile;
    tia_rgb565 *pixels;
    void *memory[2];
};

static void open_picture(struct picture *p, const struct tia_core *core, const struct tia_scene *scene, unsigned width,
                         unsigned height)
{
    size_t view = core->view_size(scene, scene->light_count), hits;

    p->tile = (struct tia_tile){0, 0, (uint16_t)width, (uint16_t)height};
    hits = core->hits_size(p->tile);
    p->memory[0] = malloc(view);
    p->memory[1] = malloc(hits);
    p->pixels = malloc((size_t)width * height * sizeof *p->pixels);
    MUST(p->memory[0] && p->memory[1] && p->pixels);
    MUST(core->view_init(&p->view, p->memory[0], view, scene, scene->light_count, width, height) == TIA_OK);
    MUST(core->hits_init(&p->hits, p->memory[1], hits, p->tile) == TIA_OK);
    MUST(core->trace(p->view, p->hits, p->tile) == TIA_OK);
}

static void light_picture(struct picture *p, const struct tia_core *core, bool dither)
{
    struct tia_surface surface = {p->pixels, 2, p->tile.width * 2};
    struct tia_options options = {dither, NULL};

    MUST(core->light(p->view, p->hits, p->tile, &surface, &options) == TIA_OK);
}

static void close_picture(struct picture *p)
{
    free(p->memory[0]);
    free(p->memory[1]);
    free(p->pixels);
}

static void must_see_objects(const struct picture *p, const struct tia_scene *scene)
{
    for (unsigned i = 0; i < (unsigned)p->tile.width * p->tile.height; i++) {
        uint32_t object = tia_hits_object(p->hits, i % p->tile.width, i / p->tile.width);
        MUST(object == TIA_NO_OBJECT || object < scene->sphere_count);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct bytes b = {data, size};
    struct picture q16, chk;
    struct fuzz_scene f;
    uint8_t shape = take_byte(&b), dither = take_byte(&b);
    unsigned width = 1 + take_byte(&b) % 40, height = 1 + take_byte(&b) % 40;

    take_scene(&b, &f);
    if (tia_scene_check(&f.scene, NULL) != TIA_OK)
        return 0;
    if (shape % 16 == 1) /* far off-square, to the largest sizes */
        width = 1 + width * 204, height = 1;
    if (shape % 16 == 2)
        height = 1 + height * 204, width = 1;
    open_picture(&q16, &tia_core_q16, &f.scene, width, height);
    light_picture(&q16, &tia_core_q16, dither & 1);
    must_see_objects(&q16, &f.scene);
    open_picture(&chk, &tia_core_chk, &f.scene, width, height);
    light_picture(&chk, &tia_core_chk, dither & 1);
    MUST(!memcmp(q16.pixels, chk.pixels, (size_t)width * height * sizeof *q16.pixels));
    MUST(tia_view_set_lights(q16.view, f.scene.lights, f.scene.light_count) == TIA_OK);
    light_picture(&q16, &tia_core_q16, dither & 1);
    MUST(!memcmp(q16.pixels, chk.pixels, (size_t)width * height * sizeof *q16.pixels));
    close_picture(&q16);
    close_picture(&chk);
    return 0;
}
