/* span_parts.h - the parts of a row's span where all points of a sphere are lit, or all in one sphere's shadow. */
#ifndef TIA_RENDER_SPAN_SPAN_PARTS_H
#define TIA_RENDER_SPAN_SPAN_PARTS_H

#include "span.h"

/* What a light does at the points of a part; points that face away from it may be of any kind. */
enum span_part {
    SPAN_LIT,  /* no sphere blocks it at any of them */
    SPAN_DARK, /* a sphere blocks it at all of them */
    SPAN_OPEN  /* not decided */
};

#define SPAN_RUNS 8 /* most parts found at once */

/* A part from the end of the one before it, or from the first pixel, to pixel end-1. */
struct span_run {
    int end;
    enum span_part part;
};

/* Divides the span of `count` pixels, at most 1024, from pixel (x, y) on, which show sphere `object`, into parts from
 * left to right, as many as fit. Returns their number, at least 1. The eye is outside of all spheres, and no material
 * transmits light. */
int span_divide(const struct tia_view *view, uint32_t object, int x, int y, int count, struct span_run runs[SPAN_RUNS]);

/* Returns the part that all points in a ball belong to, as far as sphere j blocks a light. */
enum span_part span_part_of(const struct span_casters *casters, const struct coarse_ball *ball, uint32_t light,
                            uint32_t j);

/* Returns the largest distance of a row's points between two of a sphere from the line between these. */
num_wide span_sag(const struct span_sphere *sphere, const struct coarse_ball *a, const struct coarse_ball *b);

#endif
