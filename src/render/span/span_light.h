/* span_light.h - the kernels' constants for one light on a span of pixels of one sphere. */
#ifndef TIA_RENDER_SPAN_SPAN_LIGHT_H
#define TIA_RENDER_SPAN_SPAN_LIGHT_H

#include "kernels.h"
#include "span_sphere.h"

/* A light on the sphere of a span of pixels. */
struct light_source {
    const struct span_sphere *sphere; /* the sphere whose span is lit */
    uint32_t number;                  /* of the light */
    struct num_vec light;             /* Q */
    int exponent, reach_exponent;     /* the exponents e_d of |Q - P|^2 and e_p of |P|^2, set by light_line_prepare */
};

/* Prepares all of `line` except count, for the pixels from (x, y) on. */
void light_line_prepare(const struct primary_rays *primary, struct light_source *source, int x, int y,
                        struct light_line *line);

/* Returns the exponent of the line's r N.(Q - P). */
static inline int light_facing_exponent(const struct light_source *source, const struct light_line *line)
{
    return 15 - source->sphere->radius_bits + (source->exponent >> 1) - line->scale;
}

#endif
