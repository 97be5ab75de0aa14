/* scaled.h - scenes in other units of length, and their pictures. */
#ifndef TESTS_SCALED_H
#define TESTS_SCALED_H

#include "check.h"
#include "reading.h"

#include <tia/bvh.h>
#include <tia/render.h>

/* Reads the text with scaled numbers: those marked by @, lengths, are multiplied by `scale`; those marked by ~ are
 * divided by it; and those marked by ^ are divided by its square. `more` is appended unchanged. */
static void read_scaled(struct reading *r, const char *text, double scale, const char *more)
{
    char *out = calloc(1, 12 * strlen(text) + strlen(more) + 1), *to = out;

    while (*text) {
        char *end = NULL;
        double factor = *text == '@' ? scale : *text == '~' ? 1 / scale : *text == '^' ? 1 / scale / scale : 0;
        double length = factor > 0 ? strtod(text + 1, &end) : 0;
        if (end)
            to += sprintf(to, "%.15g", length * factor);
        else
            *to++ = *text;
        text = end ? end : text + 1;
    }
    strcpy(to, more);
    read_string(r, TIA_FORMAT_TIA, out);
    CHECK_MSG(!r->status, "%u:%u: %s", (unsigned)r->reader.error.line, (unsigned)r->reader.error.column,
              r->reader.error.text);
    free(out);
}

#define WIDTH 80
#define HEIGHT 60

static void draw(struct reading *r, tia_rgb565 *pixels)
{
    struct tia_scene *scene = &r->scene;
    const struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    const struct tia_surface surface = {.pixels = pixels, .step = sizeof *pixels, .pitch = WIDTH * sizeof *pixels};
    size_t bvh_size = tia_bvh_size(scene), view_size = tia_view_size(scene, scene->light_count);
    size_t hits_size = tia_hits_size(scene, all);
    void *bvh = malloc(bvh_size), *memory = malloc(view_size), *hits_memory = malloc(hits_size);
    struct tia_view *view;
    struct tia_hits *hits;

    CHECK_EQ(tia_bvh_build(&scene->bvh, bvh, bvh_size, NULL, scene, NULL), TIA_OK);
    CHECK_EQ(tia_view_init(&view, memory, view_size, scene, scene->light_count, WIDTH, HEIGHT, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, hits_size, view, all), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, all, &surface, NULL), TIA_OK);
    free(bvh);
    free(memory);
    free(hits_memory);
}

#endif
