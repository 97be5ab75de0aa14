/* shade.h - colours a span of pixels that see one sphere, with the kernels: light by light, shadow by shadow. */
#ifndef TIA_RENDER_SPAN_SHADE_H
#define TIA_RENDER_SPAN_SHADE_H

#include "span.h"

struct shaded_span {
    uint32_t object; /* the sphere */
    int x, y, count; /* the first pixel; at most CHUNK */
    const num_u *t;
    uint32_t *path_hash; /* NULL, or receives each pixel's lights, see tia/render.h */
    uint16_t *colours;   /* NULL, or receives red, green and blue, see there */
};

/* A pixel's colours with 16 bits each. */
static inline void span_put_colours(num_u red, num_u green, num_u blue, uint16_t *colours)
{
    colours[0] = (uint16_t)num_quantise(red, 65535, NUM_ROUND);
    colours[1] = (uint16_t)num_quantise(green, 65535, NUM_ROUND);
    colours[2] = (uint16_t)num_quantise(blue, 65535, NUM_ROUND);
}

void shade_span(const struct tia_view *view, const struct shaded_span *span, const num_u threshold[8],
                tia_rgb565 *pixels);

#endif
