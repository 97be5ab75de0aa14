/* span_parts.h - the parts of a row's span where all points of a sphere are lit, or all in one sphere's shadow. */
#ifndef TIA_RENDER_SPAN_SPAN_PARTS_H
#define TIA_RENDER_SPAN_SPAN_PARTS_H

#include "span.h"

/* What light 0 does at the points of a part; points that face away from it may be of any kind. */
enum span_part {
    SPAN_LIT,  /* no sphere blocks it at any of them */
    SPAN_DARK, /* a sphere blocks it at all of them */
    SPAN_OPEN  /* not decided */
};

/* Receives pixels first..end-1 of the span, counted from its first one. */
typedef void span_part_draw(const void *drawing, enum span_part part, int first, int end);

/* Divides the span of `count` pixels from pixel (x, y) on, which show sphere `object`, into parts from left to right.
 * The eye is outside of all spheres, and no material transmits light. */
void span_divide(const struct tia_view *view, uint32_t object, int x, int y, int count, span_part_draw *draw,
                 const void *drawing);

#endif
