#include "tia_canvas.h"

#include <tia/damage.h>

/* A canvas being drawn. */
struct drawing {
    struct tia_damage damage; /* what the canvas shows are its own pixels */
    lv_obj_t *canvas;         /* NULL: it does not exist yet */
    lv_area_t area;           /* changed rows one below the other, not yet invalidated; y2 < y1: none */
};

static void invalidate(struct drawing *drawing)
{
    lv_area_t at, area = drawing->area;
    if (drawing->canvas && area.y1 <= area.y2) {
        lv_obj_get_coords(drawing->canvas, &at);
        area.x1 += at.x1;
        area.x2 += at.x1;
        area.y1 += at.y1;
        area.y2 += at.y1;
        lv_obj_invalidate_area(drawing->canvas, &area);
    }
    drawing->area.y1 = 0;
    drawing->area.y2 = -1;
}

/* Copies what has changed of a row to the canvas. Areas are few, since LVGL draws all when it has more than 32. */
static int put_row(void *ctx, unsigned y, const tia_rgb565 *pixels, unsigned width)
{
    struct drawing *drawing = ctx;
    const struct tia_tile row = {.y = (uint16_t)y, .width = (uint16_t)width, .height = 1};
    const struct tia_surface surface = {.pixels = (tia_rgb565 *)(uintptr_t)pixels, .step = sizeof *pixels};
    lv_area_t *area = &drawing->area;
    struct tia_tile changed;
    if (!tia_damage_update(&drawing->damage, row, &surface, &changed)) {
        invalidate(drawing);
        return TIA_OK;
    }
    int32_t left = changed.x, right = changed.x + changed.width - 1;
    if (area->y2 < area->y1)
        *area = (lv_area_t){.x1 = left, .y1 = (int32_t)y, .x2 = right, .y2 = (int32_t)y};
    area->x1 = left < area->x1 ? left : area->x1;
    area->x2 = right > area->x2 ? right : area->x2;
    area->y2 = (int32_t)y;
    return TIA_OK;
}

static bool swaps(const struct tia_rows *rows)
{
#if TIA_SWAP
    return rows->swap;
#else
    (void)rows;
    return false;
#endif
}

int tia_canvas_draw(lv_obj_t *canvas, const struct tia_rows *rows, tia_rgb565 *pixels, uint64_t *memory, size_t size)
{
    struct drawing drawing = {.canvas = canvas, .area = {.y2 = -1}};
    int status = rows && !swaps(rows) ? tia_damage_init(&drawing.damage, pixels, SIZE_MAX, rows->width, rows->height)
                                      : TIA_ERR_ARGUMENT;
    if (status == TIA_OK && canvas)
        tia_damage_complete(&drawing.damage);
    if (status == TIA_OK)
        status = tia_draw_rows(rows, memory, size, put_row, &drawing);
    invalidate(&drawing);
    return status;
}

lv_obj_t *tia_canvas_create(lv_obj_t *parent, const struct tia_scene *scene, tia_rgb565 *pixels, uint16_t width,
                            uint16_t height, uint64_t *memory, size_t size)
{
    const struct tia_rows rows = {.core = &tia_core_q16, .scene = scene, .width = width, .height = height};
    if (tia_canvas_draw(NULL, &rows, pixels, memory, size) != TIA_OK)
        return NULL;
    lv_obj_t *canvas = lv_canvas_create(parent);
    lv_canvas_set_buffer(canvas, pixels, width, height, LV_COLOR_FORMAT_RGB565);
    return canvas;
}
