#include "tia_canvas.h"

static int draw(const struct tia_scene *scene, tia_rgb565 *pixels, uint16_t width, uint16_t height, uint64_t *memory,
                size_t size)
{
    struct tia_surface row = {.pixels = pixels, .step = sizeof *pixels, .pitch = (ptrdiff_t)(width * sizeof *pixels)};
    size_t view_size = (tia_view_size(scene, scene->light_count) + 7) / 8 * 8;
    struct tia_view *view;
    struct tia_hits *hits;
    int status = view_size < size ? TIA_OK : TIA_ERR_MEMORY;

    if (status == TIA_OK)
        status = tia_view_init(&view, memory, view_size, scene, scene->light_count, width, height, NULL);
    for (uint16_t y = 0; y < height && status == TIA_OK; y++) {
        const struct tia_tile tile = {.y = y, .width = width, .height = 1};
        status = tia_hits_init(&hits, memory + view_size / 8, size - view_size, view, tile);
        if (status == TIA_OK)
            status = tia_view_draw(view, hits, tile, &row, NULL);
        row.pixels = pixels + (size_t)(y + 1) * width;
    }
    return status;
}

lv_obj_t *tia_canvas_create(lv_obj_t *parent, const struct tia_scene *scene, tia_rgb565 *pixels, uint16_t width,
                            uint16_t height, uint64_t *memory, size_t size)
{
    if (draw(scene, pixels, width, height, memory, size) != TIA_OK)
        return NULL;
    lv_obj_t *canvas = lv_canvas_create(parent);
    lv_canvas_set_buffer(canvas, pixels, width, height, LV_COLOR_FORMAT_RGB565);
    return canvas;
}
