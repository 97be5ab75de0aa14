/* shade.h - colours a span of pixels that see one sphere, with the kernels: light by light, shadow by shadow. */
#ifndef TIA_RENDER_SPAN_SHADE_H
#define TIA_RENDER_SPAN_SHADE_H

#include "span.h"

struct shaded_span {
    uint32_t object; /* the sphere */
    int x, y, count; /* the first pixel; at most CHUNK */
    const num_u *t;
    uint32_t *path_hash; /* NULL, or receives each pixel's lights, see tia/render.h */
};

void shade_span(const struct tia_view *view, const struct shaded_span *span, const num_u threshold[8],
                tia_rgb565 *pixels);

#endif
