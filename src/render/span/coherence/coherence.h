/* coherence.h - many pixels of a row decided by two or three of them. */
#ifndef TIA_RENDER_SPAN_COHERENCE_COHERENCE_H
#define TIA_RENDER_SPAN_COHERENCE_COHERENCE_H

#include "render/span/span_shade.h"

/* Gives a ball around the points of all lit pixels of a part of a span, whose first pixel is 0; false if there is none.
 */
bool coherence_surround(const struct span_view *spans, const struct shaded_span *span, struct span part,
                        const struct lit *lit, const struct span_error *error, struct coarse_ball *ball);

/* True if sphere `n` is certainly nearer than sphere `other` at all pixels of a span, which both show. */
bool coherence_nearer(const struct span_view *spans, uint32_t n, uint32_t other, int y, struct span span);

#endif
