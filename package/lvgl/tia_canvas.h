/* tia_canvas.h - a scene on a canvas of LVGL 9. */
#ifndef TIA_CANVAS_H
#define TIA_CANVAS_H

#include <lvgl.h>
#include <tia/tia.h>

/* A canvas below `parent` that shows the scene with its lights. `pixels` are width x height, and stay; `memory` of
 * `size` bytes, tia_draw_rows_size or more, is needed while it draws. NULL when that is too little or the scene is
 * refused. */
lv_obj_t *tia_canvas_create(lv_obj_t *parent, const struct tia_scene *scene, tia_rgb565 *pixels, uint16_t width,
                            uint16_t height, uint64_t *memory, size_t size);

/* Draws rows->scene, with rows->lights, again on a canvas of tia_canvas_create with these `pixels`, rows->width x
 * rows->height; LVGL is told only of the areas that have changed. `memory` as above. TIA_ERR_ARGUMENT when rows->swap
 * is set, and the errors of tia_draw_rows; what was drawn before an error stays. */
int tia_canvas_draw(lv_obj_t *canvas, const struct tia_rows *rows, tia_rgb565 *pixels, uint64_t *memory, size_t size);

#endif
