/* renderer.h - a renderer, from scene to pixels, as a table of functions.
 *
 * A view uses the first renderer of its core that draws the scene, see choose.c. Its prepared data are at
 * view->prepared, in the view's memory; its data for each pixel are at hits->buffer, in the hits' memory. Only the
 * renderer depends on their layouts. */
#ifndef TIA_RENDER_RENDERER_H
#define TIA_RENDER_RENDERER_H

#include "num/num.h"
#include "scene/cancel.h"

#include <tia/debug.h> /* after num.h, which may rename functions of <tia/debug.h> */

#include "math/tile.h"

/* The parts of an instruction set's code, one for each kind of renderer that has such code. Renderers without such code
 * have the part SIMD_PARTS. */
enum simd_part { SIMD_SPANS, SIMD_RAYS, SIMD_SAMPLES, SIMD_SEEN, SIMD_PARTS };

struct renderer {
    /* True if the renderer draws the scene; called only if no earlier renderer in the list does. NULL: always true.
     * Also called when a view's lights change, with a scene of the new lights and no objects. */
    bool (*draws)(const struct tia_scene *scene);

    /* Returns the size in bytes of the data at view->prepared; SIZE_MAX: too large. */
    size_t (*prepared_size)(const struct tia_scene *scene, uint32_t light_capacity);
    /* Fills in view->prepared for the view's scene and size, without its lights. Returns a tia_status, such as
     * TIA_STOPPED. */
    int (*prepare)(struct tia_view *view);
    /* Prepares view->lights: called after `prepare`, and whenever the lights change. Returns a tia_status, such as
     * TIA_STOPPED. */
    int (*set_lights)(struct tia_view *view);

    /* Returns the size in bytes of the data at hits->buffer for `pixels` pixels, below 2^40. NULL: no data. */
    uint64_t (*buffer_size)(const struct tia_scene *scene, uint32_t pixels);

    /* Implements tia_view_trace for a tile inside the image and the hits. */
    void (*trace)(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile);
    /* Implements tia_view_light for a tile inside the image and the hits. */
    void (*light)(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options);

    bool by_pixel;       /* result of tia_draws_by_pixel */
    enum simd_part part; /* part of an instruction set's code that may draw in place of this renderer */

    /* Returns TIA_OK, or an error if the view cannot take these lights: TIA_ERR_MEMORY if the view's memory is too
     * small, TIA_ERR_RANGE if a light is too far away. NULL: always TIA_OK. See tia_view_set_lights. */
    int (*refuses)(const struct tia_view *view, const struct tia_light *lights, uint32_t count);

    /* Traces and lights a tile in one pass, if that saves work; NULL: `trace` and `light` are called instead. */
    void (*render)(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                   const struct tia_surface *surface, const struct tia_options *options);

    /* Adds samples first..end - 1 of a tile's pixels, see struct tia_estimator; NULL: a renderer without samples. */
    void (*sample)(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                   const struct tia_gathered *gathered);
};

/* A renderer's replacement by the vector units of one instruction set, with the same bits. */
struct simd_renderer {
    /* Returns the size in bytes of the data at view->simd_memory; SIZE_MAX: too large. */
    size_t (*size)(const struct tia_scene *scene, uint32_t light_capacity);

    /* True if the kernels can draw the view with any lights. */
    bool (*draws)(const struct tia_view *view);
    /* Prepares view->simd_memory once for a view; NULL: not needed. */
    void (*open)(struct tia_view *view);
    /* Prepares view->simd_memory for the view's lights, whenever they change. */
    void (*prepare)(struct tia_view *view);

    /* Returns the size in bytes of the scratch memory `room` for a call of `light` or `sample`, as a thread's stack may
     * be small. `room` is aligned to 64 bytes. */
    size_t (*room)(const struct tia_simd *simd);

    /* Traces and lights a tile, see struct renderer, without hits: their buffer is unused. */
    void (*light)(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                  const struct tia_options *options, void *room);

    /* Adds samples, see struct renderer; called only if the renderer has samples. */
    void (*sample)(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                   const struct tia_gathered *gathered, void *room);

    /* Colours a tile whose faces and lights the renderer has found in the hits; SIMD_SEEN has only this function in
     * place of `light`. Returns false if the renderer must draw the tile. */
    bool (*shade)(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options, void *room);
};

/* Entry points to the vector units. They set the floating-point environment, call the functions of struct simd_renderer
 * with a `room` that no other thread uses, and restore the caller's environment. If the environment cannot be set, or
 * no room is free, plain C draws. */
struct simd_entries {
    /* Returns the size in bytes of the part's own memory and of `room` for `workers` workers. */
    size_t (*size)(const struct tia_simd *simd, const struct simd_renderer *part, const struct tia_scene *scene,
                   uint32_t light_capacity, unsigned workers);
    void (*open)(struct tia_view *view, void *memory, size_t size);
    void (*prepare)(struct tia_view *view);
    void (*light)(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                  const struct tia_options *options);
    void (*sample)(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                   const struct tia_gathered *gathered);
    /* Returns false if plain C must draw. */
    bool (*shade)(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options);
};

/* An instruction set, see tia/simd.h and src/simd. */
struct tia_simd {
    const char *name;
    const struct simd_entries *enter;
    const struct span_kernels *plain;              /* plain C kernels with the same results, of one arithmetic */
    const struct simd_renderer *parts[SIMD_PARTS]; /* NULL: plain C draws instead */
    const struct simd_kernels *kernels;            /* kernels of the span renderer */
    const struct sure_kernels *sure;               /* kernels of the ray renderers */
    const struct tia_raster_runs *raster;          /* the rasteriser's inner loops; NULL: plain C */
};

/* The renderers of a core. A program links only the renderers of the cores that it uses. */
struct tia_renderers {
    const struct renderer *const *list; /* in order of preference; ends with NULL */
    const struct span_kernels *plain;   /* plain C kernels of the core's arithmetic */
    /* Checks that all numbers of the scene are in range, and that the renderers have code for all its parts; see
     * tia_check_scene. */
    int (*check)(const struct tia_scene *scene, struct tia_fault *fault, struct cancel *cancel);
};

/* A scene prepared for one image size. */
struct tia_view {
    const struct tia_core *core; /* must be first, see struct tia_drawing */
    const struct tia_scene *scene;
    const struct renderer *renderer;
    const struct tia_simd *simd; /* NULL: plain C */
    void *simd_memory;
    const struct tia_raster_runs *raster_runs; /* NULL: plain C */
    void *prepared;                            /* the renderer's data */
    struct tia_light *lights;                  /* the view's copy of the lights */
    uint32_t light_count, light_capacity;
    int width, height;
    bool (*stop)(void *ctx); /* polled to stop the work, see tia/job.h; NULL: never stopped */
    void *stop_ctx;
};

/* Returns the part of an instruction set's code that draws a renderer's scenes, or NULL. */
static inline const struct simd_renderer *simd_renderer_for(const struct tia_simd *simd,
                                                            const struct renderer *renderer)
{
    return simd && renderer->part < SIMD_PARTS ? simd->parts[renderer->part] : NULL;
}

/* True if the view's renderer finds the visible surfaces; false if vector units do, when they light, and store no
 * hits. */
static inline bool view_keeps_hits(const struct tia_view *view)
{
    return !view->simd || view->renderer->part == SIMD_SEEN;
}

/* Returns the debug output that the caller requests; members for other output are NULL. */
static inline struct tia_debug options_debug(const struct tia_options *options)
{
    return options->debug ? *options->debug : (struct tia_debug){NULL, NULL, NULL};
}

static inline bool view_stops(const struct tia_view *view)
{
    return view->stop && view->stop(view->stop_ctx);
}

/* Returns a struct cancel that polls the view's `stop`. */
static inline struct cancel view_cancel(const struct tia_view *view)
{
    return (struct cancel){view->stop, view->stop_ctx, 0, false};
}

/* The visible objects of an area's pixels, row by row. */
struct tia_hits {
    const struct tia_view *view; /* must be first, see struct tia_drawing */
    struct tia_tile area;
    uint32_t *object; /* an object's index, or TIA_NO_OBJECT */
    void *buffer;     /* the renderer's data */
    bool traced;      /* a part of the area was traced, by any thread */
};

/* True where the compiler accesses a bool atomically without a library. Elsewhere a byte is accessed at once, too, but
 * clang would ask for one. */
#if defined(__GNUC__) && __GCC_ATOMIC_BOOL_LOCK_FREE == 2
#define HITS_ATOMIC 1
#else
#define HITS_ATOMIC 0
#endif

/* Sets `traced`. Several threads may do so at once, all to the same value. */
static inline void hits_mark_traced(struct tia_hits *hits)
{
#if HITS_ATOMIC
    __atomic_store_n(&hits->traced, true, __ATOMIC_RELAXED);
#else
    *(volatile bool *)&hits->traced = true;
#endif
}

/* True if the hits belong to the view, and the tile is inside both the image and the area of the hits. */
bool tia_hits_have(const struct tia_hits *hits, const struct tia_view *view, struct tia_tile tile);

static inline bool hits_are_traced(const struct tia_hits *hits)
{
#if HITS_ATOMIC
    return __atomic_load_n(&hits->traced, __ATOMIC_RELAXED);
#else
    return *(const volatile bool *)&hits->traced;
#endif
}

/* Returns the x just right of a tile, which is inside the image. */
static inline int tile_right(struct tia_tile tile)
{
    return (int)tile.x + (int)tile.width;
}

/* Returns the y just below a tile. */
static inline int tile_bottom(struct tia_tile tile)
{
    return (int)tile.y + (int)tile.height;
}

static inline size_t hits_index(const struct tia_hits *hits, unsigned x, unsigned y)
{
    return (size_t)(y - hits->area.y) * hits->area.width + (x - hits->area.x);
}

/* Spans: scenes of spheres, row by row. The small renderer goes without coherence.h. */
extern const struct renderer span_renderer, span_renderer_small;

/* Rays, after Whitted: any scene. */
extern const struct renderer whitted_renderer;

/* Hybrid: the rasteriser finds the visible flat faces and their shadows, rays the rest. */
extern const struct renderer raster_renderer;

/* Ambient occlusion, in samples. */
extern const struct renderer ao_renderer;

/* Light along random paths, in samples. */
extern const struct renderer path_renderer;

/* Returns the renderer for a scene, which depends on the core and the scene alone; NULL: the core has none. */
const struct renderer *tia_renderer_for(const struct tia_core *core, const struct tia_scene *scene);

/* ---- functions of struct tia_core in the library's cores ---- */

size_t tia_core_view_size(const struct tia_core *core, const struct tia_scene *scene, uint32_t light_capacity);
int tia_core_view_init(const struct tia_core *core, struct tia_view **view, void *memory, size_t size,
                       const struct tia_scene *scene, uint32_t light_capacity, unsigned width, unsigned height,
                       const struct tia_job *job);
size_t tia_core_hits_size(const struct tia_core *core, const struct tia_scene *scene, struct tia_tile area);
size_t tia_core_simd_size(const struct tia_core *core, const struct tia_simd *simd, const struct tia_scene *scene,
                          uint32_t light_capacity, unsigned workers);
bool tia_core_draws_by_pixel(const struct tia_core *core, const struct tia_scene *scene);

/* ---- functions of struct tia_drawing in the library's cores; `view` is not NULL ---- */

int tia_drawing_set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count);
int tia_drawing_hits_init(struct tia_hits **hits, void *memory, size_t size, const struct tia_view *view,
                          struct tia_tile area);
uint32_t tia_drawing_hits_object(const struct tia_hits *hits, unsigned x, unsigned y);
int tia_drawing_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile);
int tia_drawing_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                      const struct tia_surface *surface, const struct tia_options *options);
int tia_drawing_render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options);

/* Initialises a core of the library. */
#define TIA_CORE(core_name, core_renderers)                                                                            \
    {                                                                                                                  \
        .name = (core_name), .view_size = tia_core_view_size, .view_init = tia_core_view_init,                         \
        .hits_size = tia_core_hits_size, .simd_size = tia_core_simd_size, .draws_by_pixel = tia_core_draws_by_pixel,   \
        .renderers = (core_renderers)                                                                                  \
    }

#endif
