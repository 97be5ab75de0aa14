/* rgb.h - colours in the ray renderer's numbers. */
#ifndef TIA_RENDER_TRACE_RGB_H
#define TIA_RENDER_TRACE_RGB_H

#include "num/num_ray.h"

static inline void ray_rgb(const struct tia_rgb *c, num_length rgb[3])
{
    rgb[0] = num_length_of_unit(num_unit_of(c->r));
    rgb[1] = num_length_of_unit(num_unit_of(c->g));
    rgb[2] = num_length_of_unit(num_unit_of(c->b));
}

#endif
