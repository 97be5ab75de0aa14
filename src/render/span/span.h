/* span.h - spheres seen from one eye, row by row: declarations shared by the parts of span_renderer. */
#ifndef TIA_RENDER_SPAN_SPAN_H
#define TIA_RENDER_SPAN_SPAN_H

#include "exact/pixel.h"
#include "kernels.h"
#include "render/renderer.h"
#include "span_casters.h"
#include "span_light.h"

struct colour_steps;
struct shaded_span;
struct span_view;
struct span_shading;

#define SHADOW_PART 8 /* pixels */

/* What a light does in each part of a span, of SHADOW_PART pixels, and the spheres that may block it in open parts: a
 * bit for each. The balls are around the points of a part, and of all of the span. */
struct span_shadows {
    bool tried, known, divided;        /* the span is in balls; so are its parts */
    uint8_t part[CHUNK / SHADOW_PART]; /* enum span_part */
    uint8_t near[(TIA_SPAN_SPHERES + 7) / 8];
    struct span reach; /* all pixels of parts that are not lit */
    struct coarse_ball around, end[2], ball[CHUNK / SHADOW_PART];
    num sag;   /* no point is farther from the line between the ends */
    num doubt; /* bound of the error of a point in struct coarse_ball's unit, its rounding included; 0: by its distance
                */
};

/* Functions that decide many pixels at once, see coherence.h and words_shade.h. */
struct span_coherence {
    bool (*nearer)(const struct span_view *spans, uint32_t n, uint32_t other, int y, struct span span);
    bool (*shadows)(const struct span_view *spans, const struct shaded_span *span, uint32_t light,
                    struct span_shadows *shadows);
    void (*lights)(struct span_shading *s);
    bool (*add)(struct span_shading *s, const num_u *lambert, const struct tia_light *light, const num_u product[3]);
};

/* The prepared view. All positions are relative to the eye: the point at a pixel is P = t v. */
struct span_view {
    const struct span_kernels *kernels;
    const struct span_coherence *coherence; /* NULL: none */
    struct span_sphere *spheres;            /* the scene's spheres, then the lights' */
    struct span_casters casters;
    struct colour_steps *steps; /* tables, one after the other; NULL: none */
    struct primary_rays primary;
    struct exact_depth depth; /* K to 64 bits */
    bool tinted;              /* some material transmits shadow rays */
    bool grey_shadows;        /* the transmissions of all materials are grey */
    bool grey;                /* grey_shadows, and the colours of all lights are grey */
    bool dim;                 /* so, and none is above 1, and their sum is below DIM, almost 3 */
};

static inline const struct span_view *span_view_of(const struct tia_view *view)
{
    return view->prepared;
}

/* Returns the picture as src/exact computes it. */
static inline struct exact_picture span_picture_of(const struct tia_view *view)
{
    return (struct exact_picture){.scene = view->scene,
                                  .lights = view->lights,
                                  .light_count = view->light_count,
                                  .width = (int)view->width,
                                  .height = (int)view->height,
                                  .depth = span_view_of(view)->depth};
}

/* Returns the hit buffer: each pixel's distance along v, with the exponent of the object's sphere. It is undefined at
 * pixels that show no object, or an unmeasured sphere. */
static inline num_u *span_distances_of(const struct tia_hits *hits)
{
    return hits->buffer;
}

/* Returns the pixels of row y that show ball `object`: a sphere of the scene or, counted after these, a light. `guess`
 * affects only the speed. */
struct span span_sphere_row(const struct tia_view *view, uint32_t object, int y, struct span guess);

/* Computes t of the pixels x .. x + count - 1 (count <= CHUNK) of row y, which all show sphere `n`. */
void span_distances(const struct span_view *spans, uint32_t n, int y, int x, int count, num_u *t);

/* Returns how many of up to `count` objects in front are the same, at least 1. */
int span_same(const uint32_t *object, int count);

/* Replaces best[i] and object[i] by t[i] and n where sphere `n`, at the distance t[i], is nearer than object[i]; a tie
 * changes nothing. */
void span_keep_nearer(const struct tia_view *view, uint32_t n, int y, int x, const num_u *t, int count, num_u *best,
                      uint32_t *object);

/* ---- functions of struct renderer ---- */

bool span_draws(const struct tia_scene *scene);
size_t span_prepared_size(const struct tia_scene *scene, uint32_t light_capacity);
int span_prepare(struct tia_view *view, const struct span_coherence *coherence);
int span_set_lights(struct tia_view *view);
uint64_t span_buffer_size(const struct tia_scene *scene, uint32_t pixels);
void span_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile);
void span_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                const struct tia_surface *surface, const struct tia_options *options);

/* Initialises a span renderer with the given `prepare`. */
#define SPAN_RENDERER(own_prepare)                                                                                     \
    {                                                                                                                  \
        .draws = span_draws, .prepared_size = span_prepared_size, .prepare = (own_prepare),                            \
        .set_lights = span_set_lights, .buffer_size = span_buffer_size, .trace = span_trace, .light = span_light,      \
        .part = SIMD_SPANS                                                                                             \
    }

#endif
