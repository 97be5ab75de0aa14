/* render.c - any scene of spheres for spans that tia_scene_check accepts, drawn by q16 and by chk into memory of
 * exactly the required size: no number leaves its range, no access the memory; both draw the same, and so do hits that
 * are lit again. */
#include <stdio.h>
#include <string.h>

#include "picture_memory.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct bytes b = {data, size};
    struct picture q16, chk;
    struct tia_tile tile;
    struct fuzz_scene f;
    uint8_t shape = take_byte(&b), dither = take_byte(&b);
    unsigned width = 1 + take_byte(&b) % 40, height = 1 + take_byte(&b) % 40;

    take_scene(&b, &f);
    if (tia_scene_check(&f.scene, NULL))
        return 0;
    if (shape % 16 == 1) /* pictures far from square, up to the largest sizes */
        width = 1 + width * 204, height = 1;
    if (shape % 16 == 2)
        height = 1 + height * 204, width = 1;
    tile = (struct tia_tile){0, 0, (uint16_t)width, (uint16_t)height};
    open_picture(&q16, &tia_core_q16, &f.scene, width, height, tile);
    light_picture(&q16, dither & 1);
    must_see_objects(&q16, &f.scene);
    open_picture(&chk, &tia_core_chk, &f.scene, width, height, tile);
    light_picture(&chk, dither & 1);
    must_be_same(&q16, &chk);
    MUST(!tia_view_set_lights(q16.view, f.scene.lights, f.scene.light_count));
    light_picture(&q16, dither & 1);
    must_be_same(&q16, &chk);
    close_picture(&q16);
    close_picture(&chk);
    return 0;
}
