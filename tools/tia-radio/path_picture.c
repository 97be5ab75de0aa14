#include "path_picture.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <tia/text.h>

#include "common/image/image.h"
#include "common/views/lines.h"
#include "common/views/palette.h"
#include "common/views/projected.h"
#include "ports.h"
#include "refuse.h"

enum { ROWS = 16 }; /* number of rows of a job */

struct drawing {
    const struct options *options;
    const struct tia_scene *scene;
    const struct path_list *paths;
    struct tia_vec3 (*ends)[2];
    struct tia_view *view;
    tia_rgb565 *pixels;
    atomic_int status;
};

/* Returns a colour by the number of reflections; grey for paths through walls. */
static tia_rgb565 colour_of(const struct tia_radio_path *path)
{
    static const tia_rgb565 colours[] = {0xffff, 0xffe0, 0xfd20, 0xf81f, 0xf800, 0x07ff, 0x07e0, 0x041f, 0x8410};

    return path->wall_count > 0 ? 0x9cd3 : colours[path->order];
}

static void draw_path(const struct drawing *d, unsigned number, struct tia_tile tile, const struct tia_surface *surface)
{
    const struct tia_radio_path *path = &d->paths->paths[number];
    struct tia_vec3 from = d->ends[number][0];
    struct line line = {.colour = colour_of(path)};

    for (uint32_t i = 0; i <= path->order; i++) {
        struct tia_vec3 to = i < path->order ? path->point[i] : d->ends[number][1];
        if (projected_segment(&d->scene->camera, d->options->width, d->options->height, from, to, line.ends))
            line_draw(&line, tile, surface);
        from = to;
    }
}

static void draw_legend(const struct drawing *d, struct tia_tile tile, const struct tia_surface *surface)
{
    unsigned scale = d->options->height / 320 > 1 ? d->options->height / 320u : 1, line = 0;
    unsigned step = (TIA_TEXT_HEIGHT + 1) * scale;

    for (uint32_t order = 0; order <= d->options->order && (order + 1) * step <= d->options->height; order++) {
        char text[32];
        struct tia_radio_path path = {.order = order};
        (void)snprintf(text, sizeof text,
                       order == 0   ? "line of sight"
                       : order == 1 ? "1 reflection"
                                    : "%u reflections",
                       (unsigned)order);
        struct tia_text label = {text, 0, (uint16_t)(line++ * step), (uint16_t)scale, colour_of(&path), 0};
        tia_text_draw(&label, tile, surface);
    }
}

static void draw_rows(void *arg, unsigned index)
{
    struct drawing *d = arg;
    unsigned first = index * ROWS, left = d->options->height - first;
    struct tia_tile tile = {0, (uint16_t)first, d->options->width, (uint16_t)(left < ROWS ? left : ROWS)};
    struct tia_surface surface = {.pixels = d->pixels + (size_t)first * d->options->width,
                                  .step = sizeof(tia_rgb565),
                                  .pitch = (ptrdiff_t)(d->options->width * sizeof(tia_rgb565))};
    size_t size = tia_hits_size(d->scene, tile);
    void *memory = malloc(size);
    struct tia_hits *hits;

    int status = memory ? tia_hits_init(&hits, memory, size, d->view, tile) : TIA_ERR_MEMORY;
    if (!status)
        status = tia_view_draw(d->view, hits, tile, &surface, &(struct tia_options){.dither = false});
    free(memory);
    if (status)
        atomic_store(&d->status, status);
    for (unsigned i = d->paths->count; i-- > 0;)
        draw_path(d, i, tile, &surface);
    draw_legend(d, tile, &surface);
}

int picture_write(const struct options *o, const tia_rgb565 *pixels, unsigned first_row, unsigned rows, uint32_t crc)
{
    const struct image_film film = {.width = o->width,
                                    .height = o->height,
                                    .first_row = first_row,
                                    .rows = rows,
                                    .frames = 1,
                                    .all_frames = 1,
                                    .rate = {25, 1},
                                    .crc = crc};
    char why[PORT_WHY];
    struct image *image = image_create_film(o->output, o->format, &film, why);

    if (!image)
        return refuse(FAILED, "%s", why);
    for (unsigned y = 0; y < rows; y++) {
        unsigned row = image_bottom_up(image) ? rows - 1 - y : y;
        (void)image_band(image, pixels + (size_t)row * o->width, 1);
    }
    return image_finish(image) ? refuse(FAILED, "%s", why) : FINE;
}

/* Draws without SIMD kernels: a picture of paths takes a second at most. */
int picture_draw(const struct options *o, const struct site *site, struct threads *pool, const struct path_list *paths,
                 struct tia_vec3 (*ends)[2])
{
    struct tia_scene scene = site->file.scene;
    struct drawing d = {.options = o, .scene = &scene, .paths = paths, .ends = ends};
    size_t size = tia_view_size(&scene, scene.light_count);
    void *memory = size < SIZE_MAX ? malloc(size) : NULL;

    scene.integration.integrator = TIA_WHITTED;
    d.pixels = malloc((size_t)o->width * o->height * sizeof *d.pixels);
    int status = memory && d.pixels
                     ? tia_view_init(&d.view, memory, size, &scene, scene.light_count, o->width, o->height, NULL)
                     : TIA_ERR_MEMORY;
    if (!status) {
        threads_run(pool, draw_rows, &d, (o->height + ROWS - 1u) / ROWS);
        status = atomic_load(&d.status);
    }
    int result =
        !status ? picture_write(o, d.pixels, 0, o->height, 0)
                : refuse(FAILED, "%s",
                         status == TIA_ERR_MEMORY ? "memory: exhausted" : "the scene cannot be drawn in that size");
    free(d.pixels);
    free(memory);
    return result;
}
