/* render.h - renders a scene to RGB565 pixels, a tile at a time, in the caller's memory.
 *
 *     scene --tia_view_init---> view     the scene prepared for one image size
 *     view  --tia_view_trace--> hits     the nearest object of each pixel of a tile
 *     hits  --tia_view_light--> pixels   lit, clamped, packed
 *
 * When only lights have moved, tia_view_set_lights and tia_view_light compute the new picture from the old hits:
 * exactly the picture that tracing again would give. Tiles may have any size and be drawn in any order, also from
 * several threads at once, as long as no two threads share a pixel of a hit buffer: the pixels are the same. No
 * function here allocates, prints or keeps state.
 */
#ifndef TIA_RENDER_H
#define TIA_RENDER_H

#include <tia/job.h>
#include <tia/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_SIZE_MAX 8192        /* the largest width and height of an image */
#define TIA_NO_OBJECT UINT32_MAX /* the background */

/* 1: surfaces have the member `swap`, else 0. The library and all files that use it are compiled with the same value.
 * If it is not set, there is none where pointers are short, as on boards, since their programs would grow by it. */
#ifndef TIA_SWAP
#define TIA_SWAP (UINTPTR_MAX > UINT32_MAX)
#endif

/* A rectangle of the image, in pixels from the image's upper left corner. */
struct tia_tile {
    uint16_t x, y, width, height;
};

/* The memory for a tile's pixels. Both strides are in bytes: `step` to the next pixel on the right (2 for a
 * plain frame buffer), `pitch` to the next one below. A rotated panel swaps or negates them. */
struct tia_surface {
    tia_rgb565 *pixels;    /* the tile's upper left pixel, aligned for tia_rgb565 */
    ptrdiff_t step, pitch; /* even; if they are too small, pixels overlap */
#if TIA_SWAP
    bool swap; /* each pixel's bytes in the other order than the processor's, as panels on a bus want them */
#endif
};

/* Dithering, and output besides the pixels. All zero, or NULL: none. */
struct tia_options {
    bool dither;                   /* ordered dithering, Bayer 8x8, before quantising to RGB565 */
    uint16_t *colours;             /* NULL, or receives each pixel's red, green and blue, row by row of the tile */
    const struct tia_debug *debug; /* NULL, or more output for each pixel, see tia/debug.h */
};

/* `colours` receives the colours before they are rounded to RGB565: 0..65535 for 0..1, rounded to nearest. They can be
 * rounded further to 8 bits, as 255 divides 65535. TIA_ERR_UNSUPPORTED with `dither`, for a view drawn by vector units,
 * and for integrators with samples, whose sums have the colours, see struct tia_estimator. */

struct tia_view; /* a prepared scene, in the caller's memory */
struct tia_hits; /* a hit buffer, in the caller's memory */

/* Returns the number of bytes for a view of `scene`, which tia_scene_check accepts, with up to `light_capacity` lights;
 * SIZE_MAX when that number does not fit. */
size_t tia_view_size(const struct tia_scene *scene, uint32_t light_capacity);

/* Prepares `scene` for a width x height image (1..TIA_SIZE_MAX each) in `memory`, aligned for uint64_t. The view refers
 * to the scene's arrays: they must outlive it. TIA_ERR_ARGUMENT when light_capacity is less than the scene's lights,
 * TIA_ERR_RANGE when tia_scene_check refuses the scene, or an object or a light is too far away for its shadows, see
 * tia_shadow_too_far and tia_shadow_light_too_far; TIA_ERR_MEMORY when `size` is too small.
 *
 * The view is prepared on one thread. It refers to the job's `stop`, which tia_view_set_lights, tia_view_trace,
 * tia_view_light and tia_view_draw poll on the thread that calls them, after about 16 rays or, for spans, a row. After
 * TIA_STOPPED the tile's pixels, its hits and the view's lights are undefined. */
int tia_view_init(struct tia_view **view, void *memory, size_t size, const struct tia_scene *scene,
                  uint32_t light_capacity, unsigned width, unsigned height, const struct tia_job *job);

/* Replaces the lights. TIA_ERR_MEMORY when there are more than light_capacity, or with TIA_SHADOWS_MAP when they need
 * more maps, or more samples, than all lights and keys of the scene together; TIA_ERR_RANGE when tia_scene_check
 * refuses one, or one is too far away for the scene's shadows, see tia_shadow_light_too_far; after an error the old
 * lights stay. */
int tia_view_set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count);

/* Returns the number of bytes for the hits of `area` in a picture of `scene`; SIZE_MAX when that number does not
 * fit. */
size_t tia_hits_size(const struct tia_scene *scene, struct tia_tile area);

/* Creates a hit buffer for `area` of the view's picture in `memory`, aligned for uint64_t, for this view alone.
 * TIA_ERR_ARGUMENT when the area is empty, TIA_ERR_MEMORY when `size` is too small. */
int tia_hits_init(struct tia_hits **hits, void *memory, size_t size, const struct tia_view *view, struct tia_tile area);

/* Returns the index of the object at pixel (x, y) of the image, or TIA_NO_OBJECT; with several samples per pixel, that
 * of the first. Lights are not in the hits, since they may move: tia_view_light finds them. TIA_NO_OBJECT, too, outside
 * the image and the hits, and as long as no tile of the hits has been traced. After that the pixel must have been
 * traced. */
uint32_t tia_hits_object(const struct tia_hits *hits, unsigned x, unsigned y);

/* Finds the nearest object of each pixel of `tile`. TIA_ERR_ARGUMENT when the tile is empty or not inside the image and
 * the hit buffer, and when the hits are another view's. */
int tia_view_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile);

/* Computes the colours of the traced pixels of `tile` and writes each pixel once, left to right, top to bottom.
 * `options` may be NULL. Errors as for tia_view_trace, and TIA_ERR_ARGUMENT when no tile of the hits has been traced,
 * or the surface has no pixels or is not aligned. All pixels of `tile` must have been traced; this is not checked once
 * any tile has been. Vector units, see simd.h, need no hits. */
int tia_view_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                   const struct tia_surface *surface, const struct tia_options *options);

/* Does the work of tia_view_trace and then of tia_view_light, faster than the two calls if rays draw the scene. */
int tia_view_draw(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options);

/* True for scenes drawn by rays, where a tile of one pixel costs little more than its share of a large tile. Spans
 * prepare a whole row, and the rasteriser all faces. */
bool tia_draws_by_pixel(const struct tia_scene *scene);

/* An instruction set of a processor's vector units, see tia/simd.h. */
struct tia_simd;

/* A core's functions for its views. tia_view_set_lights, tia_hits_init, tia_hits_object, tia_view_trace, tia_view_light
 * and tia_view_draw check that the view is not NULL and call the slot of the view's core. A program with a renderer of
 * its own, or one that extends the library's, puts its table into a core of its own. A view must begin with a pointer
 * to its core, and hits with a pointer to their view, as the library's do. */
struct tia_drawing {
    int (*set_lights)(struct tia_view *, const struct tia_light *, uint32_t);
    int (*hits_init)(struct tia_hits **, void *, size_t, const struct tia_view *, struct tia_tile);
    uint32_t (*hits_object)(const struct tia_hits *, unsigned, unsigned);
    int (*trace)(const struct tia_view *, struct tia_hits *, struct tia_tile);
    int (*light)(const struct tia_view *, const struct tia_hits *, struct tia_tile, const struct tia_surface *,
                 const struct tia_options *);
    int (*render)(const struct tia_view *, struct tia_hits *, struct tia_tile, const struct tia_surface *,
                  const struct tia_options *);
};

/* The library's table, for programs that extend it. */
extern const struct tia_drawing tia_drawing;

/* An arithmetic and its renderers. A program can link several cores and choose one at run time; the functions above
 * draw the views of every core. A core has those functions above that need no view, with the core as their first
 * argument, as in core->view_size(core, scene, 1). A program's core may be a copy of the library's with another
 * `drawing`; it must outlive its views. */
struct tia_core {
    const char *name; /* "q16", "f64", ... */
    size_t (*view_size)(const struct tia_core *, const struct tia_scene *, uint32_t);
    int (*view_init)(const struct tia_core *, struct tia_view **, void *, size_t, const struct tia_scene *, uint32_t,
                     unsigned, unsigned, const struct tia_job *);
    size_t (*hits_size)(const struct tia_core *, const struct tia_scene *, struct tia_tile);
    size_t (*simd_size)(const struct tia_core *, const struct tia_simd *, const struct tia_scene *, uint32_t,
                        unsigned);                                             /* may be NULL: 0 bytes */
    bool (*draws_by_pixel)(const struct tia_core *, const struct tia_scene *); /* may be NULL: not known */
    const struct tia_drawing *drawing;                                         /* NULL: tia_drawing */
    const struct tia_renderers *renderers; /* renderers of the library; NULL: `drawing` has its own */
};

extern const struct tia_core tia_core_q16; /* integers: the core of the functions above */
extern const struct tia_core tia_core_f64; /* double: the reference, libtia-f64.a */

/* A core of integers for the span renderer's scenes, see scene.h. A program that names no other core links no other
 * renderer, and no code for other scenes. view_init returns TIA_ERR_RANGE for scenes with shapes, meshes, textures,
 * tracks, falling balls or techniques for shadows, and TIA_ERR_UNSUPPORTED for all others that spans do not draw. */
extern const struct tia_core tia_core_spheres;
/* A core like tia_core_spheres with less code: it computes each pixel on its own, which takes longer. */
extern const struct tia_core tia_core_spheres_small;

#ifdef __cplusplus
}
#endif

#endif
