/* oracle_core.c - the oracle as a struct tia_core: it draws whatever the library's arithmetics draw. A hit buffer
 * stores all results of the oracle. */
#include "oracle.h"

#include <tia/debug.h>

struct tia_view {
    const struct tia_core *core;
    const struct tia_scene *scene;
    unsigned width, height;
};

struct tia_hits {
    const struct tia_view *view;
    struct tia_tile area;
    struct oracle_pixel pixels[];
};

static size_t view_size(const struct tia_core *core, const struct tia_scene *scene, uint32_t light_capacity)
{
    (void)core;
    (void)scene;
    (void)light_capacity;
    return sizeof(struct tia_view);
}

static int view_init(const struct tia_core *core, struct tia_view **view, void *memory, size_t size,
                     const struct tia_scene *scene, uint32_t light_capacity, unsigned width, unsigned height,
                     const struct tia_job *job)
{
    (void)job;
    if (size < view_size(core, scene, light_capacity))
        return TIA_ERR_MEMORY;
    *view = memory;
    **view = (struct tia_view){core, scene, width, height};
    return TIA_OK;
}

static int set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    (void)view;
    (void)lights;
    (void)count;
    return TIA_ERR_UNSUPPORTED;
}

static size_t hits_size(const struct tia_core *core, const struct tia_scene *scene, struct tia_tile area)
{
    (void)core;
    (void)scene;
    return sizeof(struct tia_hits) + (size_t)area.width * area.height * sizeof(struct oracle_pixel);
}

static int hits_init(struct tia_hits **hits, void *memory, size_t size, const struct tia_view *view,
                     struct tia_tile area)
{
    if (size < hits_size(view->core, view->scene, area))
        return TIA_ERR_MEMORY;
    *hits = memory;
    (*hits)->view = view;
    (*hits)->area = area;
    return TIA_OK;
}

static size_t hits_index(const struct tia_hits *hits, unsigned x, unsigned y)
{
    return (size_t)(y - hits->area.y) * hits->area.width + (x - hits->area.x);
}

static uint32_t hits_object(const struct tia_hits *hits, unsigned x, unsigned y)
{
    return hits->pixels[hits_index(hits, x, y)].sphere;
}

static int trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    for (unsigned y = tile.y; y < tile.y + (unsigned)tile.height; y++)
        for (unsigned x = tile.x; x < tile.x + (unsigned)tile.width; x++)
            hits->pixels[hits_index(hits, x, y)] = oracle_look(view->scene, view->width, view->height, x, y);
    return TIA_OK;
}

static int light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                 const struct tia_surface *surface, const struct tia_options *options)
{
    size_t i = 0;

    (void)view;
    for (unsigned y = tile.y; y < tile.y + (unsigned)tile.height; y++) {
        char *out = (char *)surface->pixels + (ptrdiff_t)(y - tile.y) * surface->pitch;
        for (unsigned x = tile.x; x < tile.x + (unsigned)tile.width; x++, out += surface->step) {
            struct oracle_pixel pixel = hits->pixels[hits_index(hits, x, y)];
            *(tia_rgb565 *)(void *)out = oracle_pack(&pixel, x, y, options->dither);
            if (options->debug && options->debug->path_hash)
                options->debug->path_hash[i++] = pixel.path_hash;
        }
    }
    return TIA_OK;
}

static int render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options)
{
    int status = trace(view, hits, tile);

    return status ? status : light(view, hits, tile, surface, options);
}

static const struct tia_drawing drawing = {.set_lights = set_lights,
                                           .hits_init = hits_init,
                                           .hits_object = hits_object,
                                           .trace = trace,
                                           .light = light,
                                           .render = render};
const struct tia_core oracle_core = {
    .name = "oracle", .view_size = view_size, .view_init = view_init, .hits_size = hits_size, .drawing = &drawing};
