/* tia_canvas.h - a scene on a canvas of LVGL 9. */
#ifndef TIA_CANVAS_H
#define TIA_CANVAS_H

#include <lvgl.h>
#include <tia/tia.h>

/* A canvas below `parent` that shows the scene with its lights. `pixels` are width x height, and stay; `memory` of
 * `size` bytes is needed while it draws: at least tia_view_size(scene, scene->light_count) plus tia_hits_size of a row,
 * each rounded up to 8 bytes. NULL when that is too little or the scene is refused. */
lv_obj_t *tia_canvas_create(lv_obj_t *parent, const struct tia_scene *scene, tia_rgb565 *pixels, uint16_t width,
                            uint16_t height, uint64_t *memory, size_t size);

#endif
