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

/* Blends two colours: `part` of the second one. */
static inline void ray_rgb_blend(const struct tia_rgb colours[2], num_length part, num_length rgb[3])
{
    num_length second[3];

    ray_rgb(&colours[0], rgb);
    ray_rgb(&colours[1], second);
    for (int c = 0; c < 3; c++)
        rgb[c] += num_product(part, second[c] - rgb[c]);
}

#endif
