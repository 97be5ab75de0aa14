/* rows.h - a picture row by row, in one call: for panels whose processor has no memory for a whole picture.
 *
 *     static int send(void *ctx, unsigned y, const tia_rgb565 *pixels, unsigned width) { ...; return TIA_OK; }
 *
 *     const struct tia_rows rows = {.core = &tia_core_spheres, .scene = &scene, .width = 320, .height = 240};
 *     status = tia_draw_rows(&rows, memory, sizeof memory, send, NULL);
 */
#ifndef TIA_ROWS_H
#define TIA_ROWS_H

#include <tia/render.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A picture that tia_draw_rows draws. */
struct tia_rows {
    const struct tia_core *core; /* such as &tia_core_spheres; the program links only this core's renderers */
    const struct tia_scene *scene;
    const struct tia_light *lights; /* lights in place of the scene's own, such as a key's state; NULL: the scene's */
    uint32_t light_count;           /* number of `lights`; 0 if `lights` is NULL */
    uint16_t width, height;         /* of the picture in pixels, each 1..TIA_SIZE_MAX */
    uint16_t columns;               /* most pixels of a row that are drawn at once; 0: all. Fewer take less memory and
                                     * more time; the picture is the same */
    bool dither;                    /* see struct tia_options */
#if TIA_SWAP
    bool swap; /* see struct tia_surface: as an SPI panel wants the bytes */
#endif
};

/* Returns the number of bytes of memory that tia_draw_rows needs for a scene that tia_scene_check accepts, which
 * `tia-compile --memory` writes as a macro; SIZE_MAX when that number does not fit. */
size_t tia_draw_rows_size(const struct tia_rows *rows);

/* Draws the picture in `memory`, aligned for uint64_t, and calls `row` for each row, from y = 0 at the top to
 * height - 1. `pixels` are the row's `width` pixels, which are valid until `row` returns. If `row` returns anything but
 * TIA_OK, such as TIA_STOPPED or TIA_ERR_DEVICE, tia_draw_rows ends and returns that. `ctx` is the argument of `row`.
 *
 * TIA_ERR_ARGUMENT when a member of `rows` is out of its range, TIA_ERR_MEMORY when `size` is less than
 * tia_draw_rows_size; and the errors of tia_view_init and tia_view_set_lights. All of these are returned before the
 * first row is drawn. */
int tia_draw_rows(const struct tia_rows *rows, void *memory, size_t size,
                  int (*row)(void *ctx, unsigned y, const tia_rgb565 *pixels, unsigned width), void *ctx);

#ifdef __cplusplus
}
#endif

#endif
