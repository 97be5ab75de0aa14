#include "math/align.h"
#include "renderer.h"

#define HEADER ALIGN(sizeof(struct tia_hits))

static uint64_t objects_size(uint32_t pixels)
{
    return ALIGN((uint64_t)pixels * sizeof(uint32_t));
}

size_t tia_core_hits_size(const struct tia_core *core, const struct tia_scene *scene, struct tia_tile area)
{
    uint32_t pixels = (uint32_t)area.width * area.height;

    if (!core || !scene)
        return SIZE_MAX;
    const struct renderer *renderer = tia_renderer_for(core, scene);
    uint64_t buffer = renderer && renderer->buffer_size ? renderer->buffer_size(scene, pixels) : 0;
    uint64_t size = HEADER + objects_size(pixels) + buffer;

    return size < SIZE_MAX ? (size_t)size : SIZE_MAX;
}

int tia_drawing_hits_init(struct tia_hits **hits, void *memory, size_t size, const struct tia_view *view,
                          struct tia_tile area)
{
    struct tia_hits *h = memory;

    if (!hits || !memory_is_usable(memory) || !view || !area.width || !area.height)
        return TIA_ERR_ARGUMENT;
    if (size < tia_core_hits_size(view->core, view->scene, area))
        return TIA_ERR_MEMORY;
    h->view = view;
    h->traced = false;
    h->area = area;
    h->object = (uint32_t *)(void *)((char *)memory + HEADER);
    h->buffer = (char *)h->object + objects_size((uint32_t)area.width * area.height);
    *hits = h;
    return TIA_OK;
}

bool tia_hits_have(const struct tia_hits *hits, const struct tia_view *view, struct tia_tile tile)
{
    return hits && view && hits->view == view && tile_is_inside(tile, hits->area) && tile_right(tile) <= view->width &&
           tile_bottom(tile) <= view->height;
}

/* Returns the object at a pixel, which is traced for this call, since vector units store no hits. */
static uint32_t traced_object(const struct tia_view *view, unsigned x, unsigned y)
{
    uint32_t object = TIA_NO_OBJECT;
    uint64_t distance; /* large enough for a distance in any arithmetic */
    struct tia_tile tile = {(uint16_t)x, (uint16_t)y, 1, 1};
    struct tia_hits one = {.view = view, .area = tile, .object = &object, .buffer = &distance};

    view->renderer->trace(view, &one, tile);
    return object;
}

uint32_t tia_drawing_hits_object(const struct tia_hits *hits, unsigned x, unsigned y)
{
    struct tia_tile pixel = {(uint16_t)x, (uint16_t)y, 1, 1};

    if (!hits || !hits->view || x > UINT16_MAX || y > UINT16_MAX || !tia_hits_have(hits, hits->view, pixel))
        return TIA_NO_OBJECT;
    if (!view_keeps_hits(hits->view))
        return traced_object(hits->view, x, y);
    if (!hits_are_traced(hits))
        return TIA_NO_OBJECT;
    return hits->object[hits_index(hits, x, y)];
}
