/* span_shading.h - what the parts of span_shade.h share: a span being shaded, light by light. */
#ifndef TIA_RENDER_SPAN_SPAN_SHADING_H
#define TIA_RENDER_SPAN_SPAN_SHADING_H

#include "span.h"
#include "span_error.h"

/* A span being shaded. */
struct span_shading {
    const struct shaded_span *span;
    const struct tia_view *view;
    const struct span_view *spans;
    const struct tia_material *material;
    bool grey;       /* red serves as all three channels */
    bool uncoloured; /* sum[0] is the light, which is grey: the material's colour comes last, see words_shade.h */
    num_u sum[3][CHUNK];
    num_u most;                /* limit of the sums */
    num_u doubt;               /* bound of the sums' errors */
    pixel_set open;            /* pixels whose sums have no bound, or whose lights or shadows are in doubt */
    bool given_up;             /* all pixels are open, and no other output needs them */
    unsigned work;             /* lights and casters so far */
    struct span_depth ends[2]; /* of the first and the last pixel */
    struct span_error error;   /* of the light being added */
    bool bounded;              /* the light's error has a bound */
    bool words;                /* pixels may be computed by words.h */
    struct span_lit lit;       /* the span's points */
    struct span_shadows shadows;
};

/* The part of a light that half-transparent spheres transmit to each pixel of a span. */
struct tint;

/* Prepares a light, and bounds its errors; false if all pixels are left open. */
bool span_prepare_light(struct span_shading *s, uint32_t l, struct light_source *source, struct light_line *line);

/* Adds a light that is prepared, tinted by half-transparent spheres unless `tint` is NULL. */
void span_shade_by_kernels(struct span_shading *s, const struct light_source *source, const struct light_line *line,
                           struct tint *tint);

/* Adds a light whose cosines are off by up to `doubt`, and by a binary logarithm, `log`. */
void span_add_light(struct span_shading *s, const struct tia_light *light, const num_u *lambert, struct tint *tint,
                    int log, num_u doubt);

#endif
