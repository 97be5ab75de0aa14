/* coherence.h - many pixels of a row decided by two of them.
 *
 * For one light on a sphere, with G = Q - L, r N.(Q - P) and |Q - P|^2 depend on the point P only through G.P, and so
 * does N.(Q - P)/|Q - P|, which grows with G.P. The points P of a row's pixels lie on less than half of a circle, where
 * G.P has at most one extremum. So |Q - P|^2 has at most one extremum. If |Q - P|^2 grows both before and after a run
 * of pixels, or falls both before and after, it is monotone along the run. Then the light on each pixel is between that
 * on the first and that on the last pixel: if both round to one colour, all pixels have this colour. Shadows of other
 * spheres change slowly, see coherence.c.
 *
 * The fixed-point errors are bounded, see coherence_bounds.c. So every pixel has the same bits as when it is computed
 * alone. Pixels that cannot be decided are computed alone. */
#ifndef TIA_RENDER_SPAN_COHERENCE_COHERENCE_H
#define TIA_RENDER_SPAN_COHERENCE_COHERENCE_H

#include "render/span/span_shade.h"

/* Draws a span of a wide sphere. The span's t and path_hash are not used, and its count may exceed CHUNK. Returns
 * false, and draws nothing, if this does not pay or the pixels cannot be decided. */
bool coherence_shade(const struct tia_view *view, const struct shaded_span *span, const num_u threshold[THRESHOLDS],
                     tia_rgb565 *pixels);

/* Gives a ball around the points of all lit pixels of a part of a span, whose first pixel is 0; false if there is none.
 */
bool coherence_surround(const struct span_view *spans, const struct shaded_span *span, struct span part,
                        const struct lit *lit, const struct span_error *error, struct coarse_ball *ball);

/* True if sphere `n` is certainly nearer than sphere `other` at all pixels of a span, which both show. */
bool coherence_nearer(const struct span_view *spans, uint32_t n, uint32_t other, int y, struct span span);

#endif
