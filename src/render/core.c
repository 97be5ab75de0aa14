/* core.c - the public functions of one arithmetic as a table. */
#include "num/num.h"

#include <tia/simd.h>

const struct tia_core NUM_CORE = {
    .name = NUM_NAME,
    .view_size = tia_view_size,
    .view_init = tia_view_init,
    .set_lights = tia_view_set_lights,
    .hits_size = tia_hits_size,
    .hits_init = tia_hits_init,
    .hits_object = tia_hits_object,
    .trace = tia_trace,
    .light = tia_light_tile,
    .view_init_until = tia_view_init_until,
    .simd_size = tia_simd_size,
    .set_simd = tia_view_set_simd,
    .simd_name = tia_view_simd,
    .render = tia_render,
    .draws_by_pixel = tia_draws_by_pixel,
};
