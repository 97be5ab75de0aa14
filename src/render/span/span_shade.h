/* span_shade.h - colours a span of pixels of one sphere, with the kernels: light by light, shadow by shadow. */
#ifndef TIA_RENDER_SPAN_SPAN_SHADE_H
#define TIA_RENDER_SPAN_SPAN_SHADE_H

#include "span.h"

struct shaded_span {
    uint32_t object; /* number of the sphere */
    int x, y, count; /* first pixel, and number of pixels, at most CHUNK */
    const num_u *t;
    uint32_t *path_hash; /* path hashes, see tia/debug.h, or NULL */
    uint16_t *colours;   /* receives red, green and blue, see tia/render.h, or NULL */
};

/* Stores the colours of `count` pixels, with 16 bits a channel; pixel i has the channels rgb[0..2][i * step]. `colours`
 * NULL: stores nothing. */
void span_put_colours(const num_u *const rgb[3], int step, int count, uint16_t *colours);

#define SPAN_WORK 16 /* lights and casters of a span between polls of `stop` */

/* Counts a light or a caster. Returns true if `stop` was polled, after each SPAN_WORK of them, and returned true; then
 * each further call polls. */
static inline bool span_work_stops(const struct tia_view *view, unsigned *work)
{
    if (++*work % SPAN_WORK || !view_stops(view))
        return false;
    --*work;
    return true;
}

/* Returns the pixel of a span of one, computed with balls. */
tia_rgb565 span_shade_exactly(const struct tia_view *view, const struct shaded_span *one, num_u threshold);

void shade_span(const struct tia_view *view, const struct shaded_span *span, const num_u threshold[THRESHOLDS],
                tia_rgb565 *pixels);

#endif
