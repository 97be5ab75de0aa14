/* renderer.h - a renderer, from scene to pixels, as a table of functions.
 *
 * A view takes the renderer that its scene asks for, else the fastest one that can draw it, see choose.c, and keeps it.
 * What a renderer prepares lies in the view's memory, behind view->prepared, and what it keeps of each pixel in the hit
 * buffer, behind hits->buffer; it lays out both as it likes. Nothing outside a renderer asks which one it is.
 */
#ifndef TIA_RENDER_RENDERER_H
#define TIA_RENDER_RENDERER_H

#include "num/num.h"
#include "scene/cancel.h"

#include <tia/simd.h> /* after num.h, which may rename its functions */

#include "math/tile.h"

/* What a level may draw: SIMD_PARTS of a renderer says nothing. */
enum simd_part { SIMD_SPANS, SIMD_RAYS, SIMD_SAMPLES, SIMD_PARTS };

struct renderer {
    /* Whether it can draw the scene, NULL: any. New lights for a view are asked about in a scene with nothing else. */
    bool (*draws)(const struct tia_scene *scene);

    /* Bytes behind view->prepared, SIZE_MAX when there are too many; then fills them in for the view's scene and
     * size. The lights are set afterwards, whenever they change. Both may return TIA_STOPPED. */
    size_t (*prepared_size)(const struct tia_scene *scene, uint32_t light_capacity);
    int (*prepare)(struct tia_view *view);
    int (*set_lights)(struct tia_view *view);

    /* Bytes behind hits->buffer for `pixels` pixels of the scene; below 2^40. NULL: none. */
    uint64_t (*buffer_size)(const struct tia_scene *scene, uint32_t pixels);

    /* A tile of the view and of the hits, see tia_trace and tia_light_tile. */
    void (*trace)(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile);
    void (*light)(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options);

    bool by_pixel;       /* see tia_draws_by_pixel */
    enum simd_part part; /* of a level, which may draw in its place */

    /* NULL, or an error if the view cannot have these lights: TIA_ERR_MEMORY when its memory is not enough for them,
     * TIA_ERR_RANGE when one is too far away. See tia_view_set_lights. */
    int (*refuses)(const struct tia_view *view, const struct tia_light *lights, uint32_t count);

    /* Traces and lights at once, where that saves work; NULL: one after the other. */
    void (*render)(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                   const struct tia_surface *surface, const struct tia_options *options);

    /* NULL, or adds samples first..end - 1 of a tile's pixels, see struct tia_estimator. */
    void (*sample)(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                   const struct tia_gathered *gathered);
};

/* What draws in place of one renderer's plain C, on a processor with vector units: the same bits. */
struct simd_renderer {
    /* Bytes behind view->simd_memory, SIZE_MAX when there are too many. */
    size_t (*size)(const struct tia_scene *scene, uint32_t light_capacity);

    /* Whether it can draw the view, whatever the lights. Then `open`, unless NULL, prepares its memory once, and
     * `prepare` whenever the lights change. */
    bool (*draws)(const struct tia_view *view);
    void (*open)(struct tia_view *view);
    void (*prepare)(struct tia_view *view);

    /* Bytes that each of the following two needs as long as it is called: a thread's stack may be small. `room` is
     * aligned to 64. */
    size_t (*room)(const struct tia_simd *simd);

    /* As in struct renderer, but without hits: their buffer stays unused. */
    void (*light)(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                  const struct tia_options *options, void *room);

    /* As in struct renderer, of one that has it. */
    void (*sample)(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                   const struct tia_gathered *gathered, void *room);
};

/* How a view's level is called: as the functions above, which it calls in a floating-point environment of their own,
 * with room that no other thread uses. The caller's environment is put back. Where either cannot be had plain C draws.
 */
struct simd_entries {
    /* Bytes for the part's own memory and for as many workers; then these for a view whose level is set. */
    size_t (*size)(const struct tia_simd *simd, const struct simd_renderer *part, const struct tia_scene *scene,
                   uint32_t light_capacity, unsigned workers);
    void (*open)(struct tia_view *view, void *memory, size_t size);
    void (*prepare)(struct tia_view *view);
    void (*light)(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                  const struct tia_options *options);
    void (*sample)(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                   const struct tia_gathered *gathered);
};

/* See tia/simd.h and src/simd. */
struct tia_simd {
    const char *name;
    const struct simd_entries *enter;
    const struct span_kernels *plain;              /* those whose bits it gives: one arithmetic's */
    const struct simd_renderer *parts[SIMD_PARTS]; /* NULL: left to plain C */
    const struct simd_kernels *kernels;            /* of the spans */
    const struct sure_kernels *sure;               /* of the rays */
    const struct tia_raster_runs *raster;          /* of the rasteriser; NULL: plain C */
};

/* A scene prepared for one image size. */
struct tia_view {
    const struct tia_scene *scene;
    const struct renderer *renderer;
    const struct tia_simd *simd; /* NULL: plain C */
    void *simd_memory;
    const struct tia_raster_runs *raster_runs; /* NULL: plain C */
    void *prepared;                            /* the renderer's */
    struct tia_light *lights;                  /* our copy */
    uint32_t light_count, light_capacity;
    int width, height;
    bool (*stop)(void *ctx); /* NULL, or whether to stop, see tia_view_init_until */
    void *stop_ctx;
};

/* What of a level draws the scenes of a renderer, or NULL. */
static inline const struct simd_renderer *simd_renderer_for(const struct tia_simd *simd,
                                                            const struct renderer *renderer)
{
    return simd && renderer->part < SIMD_PARTS ? simd->parts[renderer->part] : NULL;
}

static inline bool view_stops(const struct tia_view *view)
{
    return view->stop && view->stop(view->stop_ctx);
}

/* For work in which the view's owner may want to stop. */
static inline struct cancel view_cancel(const struct tia_view *view)
{
    return (struct cancel){view->stop, view->stop_ctx, 0, false};
}

/* What each pixel of an area sees, row by row. */
struct tia_hits {
    const struct tia_view *view;
    struct tia_tile area;
    uint32_t *object; /* an object's index, or TIA_NO_OBJECT */
    void *buffer;     /* the renderer's */
    bool traced;      /* some of it has been; any of the threads that trace sets it */
};

/* Several threads may set it at once, all to the same. */
static inline void hits_mark_traced(struct tia_hits *hits)
{
#ifdef __GNUC__
    __atomic_store_n(&hits->traced, true, __ATOMIC_RELAXED);
#else
    hits->traced = true;
#endif
}

/* Whether a tile is inside the image and the hits, which are the view's. */
bool hits_have(const struct tia_hits *hits, const struct tia_view *view, struct tia_tile tile);

static inline bool hits_are_traced(const struct tia_hits *hits)
{
#ifdef __GNUC__
    return __atomic_load_n(&hits->traced, __ATOMIC_RELAXED);
#else
    return hits->traced;
#endif
}

/* Where a tile ends; tia_trace has checked that it is inside the image. */
static inline int tile_right(struct tia_tile tile)
{
    return (int)tile.x + (int)tile.width;
}

static inline int tile_bottom(struct tia_tile tile)
{
    return (int)tile.y + (int)tile.height;
}

static inline size_t hits_index(const struct tia_hits *hits, unsigned x, unsigned y)
{
    return (size_t)(y - hits->area.y) * hits->area.width + (x - hits->area.x);
}

/* Spheres seen from one eye, a row at a time: for scenes that ask for no more. */
extern const struct renderer span_renderer;

/* Rays, after Whitted: any scene. no_rays.c has one that prepares nothing, for boards without the room. */
extern const struct renderer whitted_renderer;

/* Flat faces through the rasteriser, for what is seen directly and its shadows; rays for the rest. */
extern const struct renderer raster_renderer;

/* Ambient occlusion, in samples. */
extern const struct renderer ao_renderer;

/* Light along random paths, in samples. */
extern const struct renderer path_renderer;

/* The renderer that the scene asks for, by its integrator or its shadows; NULL: whoever can draw it. no_rays.c has one
 * that names none. */
const struct renderer *renderer_named(const struct tia_scene *scene);

/* The renderer for a scene; it depends on nothing but the scene. */
const struct renderer *renderer_for(const struct tia_scene *scene);

#endif
