/* coherence.h - many pixels of a row decided by two or three of them. */
#ifndef TIA_RENDER_SPAN_COHERENCE_COHERENCE_H
#define TIA_RENDER_SPAN_COHERENCE_COHERENCE_H

#include "render/span/span_shade.h"

/* Finds what a light does in each part of a span, and the spheres that may block it in open parts; false if no sphere
 * blocks it anywhere. No part is dark if some material transmits light. */
bool coherence_shadows(const struct span_view *spans, const struct shaded_span *span, uint32_t light,
                       struct span_shadows *shadows);

/* Sets shadows->near to the spheres that may block a light at some point of a span; false if there are none. Of the
 * span's distances those of the first and the last pixel and of pixel (count - 1)/2 suffice. */
bool coherence_near(const struct span_view *spans, const struct shaded_span *span, uint32_t light,
                    struct span_shadows *shadows);

/* Sets shadows->around to a ball around the points of a span, once; false if its distances are too inaccurate. The same
 * distances suffice. */
bool coherence_around(const struct span_view *spans, const struct shaded_span *span, struct span_shadows *shadows);

/* True if sphere `n` is certainly nearer than sphere `other` at all pixels of a span, which both show. */
bool coherence_nearer(const struct span_view *spans, uint32_t n, uint32_t other, int y, struct span span);

#endif
