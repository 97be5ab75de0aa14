/* render.h - from a scene to RGB565 pixels, a tile at a time, in the caller's memory.
 *
 *     scene --tia_view_init--> view     the scene prepared for one image size
 *     view  --tia_trace------> hits     what each pixel of a tile sees
 *     hits  --tia_light------> pixels   lit, clamped, packed
 *
 * When only lights moved, tia_view_set_lights and tia_light make the new picture from the old
 * hits: exactly the picture that tracing again would make. Tiles may be drawn in any order, of
 * any size, and from several threads at once (each pixel of a hit buffer by one thread at a
 * time): the pixels do not depend on it. Nothing here allocates, prints or keeps state.
 */
#ifndef TIA_RENDER_H
#define TIA_RENDER_H

#include <tia/scene.h>

#define TIA_SIZE_MAX 8192        /* the largest width and height of an image */
#define TIA_NO_OBJECT UINT32_MAX /* a pixel that sees the background */

/* A rectangle of an image, in pixels from its upper left corner. */
struct tia_tile {
    uint16_t x, y, width, height;
};

/* Where a tile's pixels go. Both strides are in bytes: `step` to the pixel on the right
 * (2 for plain RGB565), `pitch` to the pixel below. Rotated panels swap or negate them. */
struct tia_surface {
    tia_rgb565 *pixels;    /* the tile's upper left pixel */
    ptrdiff_t step, pitch; /* even */
};

/* What tia_light may be asked besides the pixels; all zero is the plain exact picture. */
struct tia_options {
    bool dither;         /* ordered dithering, Bayer 8x8, before quantising */
    uint32_t *path_hash; /* NULL, or for each pixel of the tile, row by row, how its colour came about:
                          equal for equal paths, see below */
};

/* What `path_hash` is. By spans: bit n (0..15) when light n arrives, and in bits 16..31 the sum of
 * (n + 1)(j + 1) over the spheres j that let it through; where light n itself is seen, 0xffff0000 + n.
 *
 * By general rays: a hash, FNV-1a, of 32-bit words, each as four bytes, the lowest first: from 2166136261
 * on, (hash ^ byte) * 16777619 for each byte. For each sample of the pixel in order, for each of its rays,
 * the reflected one and all that comes of it before the refracted one: the index of the object hit,
 * TIA_NO_OBJECT for the background, TIA_NO_OBJECT - 1 - n for light n. After an object
 *   - its part: a box's face, 2 axis + 1 on the side of its maximum; 0, 1, 2 for the side, the base and
 *     the top of a cylinder or cone; a mesh's face; 6 times a grid's cell, plus the face; else 0;
 *   - where its colour is not black, of a checker 0 or 1, of an image without `bilinear` the texel, counted
 *     row by row from 0;
 *   - for each light but the ambient ones, for each of its samples, in order: 1 when it arrives, that is
 *     G.L > 0 and N.L > 0 (see material.h), a spot light shines that way, and T is not black; else 0. */

struct tia_view; /* a prepared scene, in the caller's memory */
struct tia_hits; /* a hit buffer, in the caller's memory */

/* Bytes for a view of `scene` that may hold up to `light_capacity` lights. */
size_t tia_view_size(const struct tia_scene *scene, uint32_t light_capacity);

/* Prepares `scene` for a width x height image (1..TIA_SIZE_MAX each) in `memory`, aligned for
 * uint64_t. The scene's arrays must stay while the view is used. TIA_ERR_RANGE when
 * tia_scene_check refuses the scene, TIA_ERR_MEMORY when `size` is too small. */
int tia_view_init(struct tia_view **view, void *memory, size_t size, const struct tia_scene *scene,
                  uint32_t light_capacity, unsigned width, unsigned height);

/* Replaces the lights. TIA_ERR_MEMORY when they are more than light_capacity, TIA_ERR_RANGE when
 * tia_scene_check refuses one: then the old ones stay. */
int tia_view_set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count);

/* Bytes for the hits of `area` of a picture of `scene`, SIZE_MAX when there are too many. */
size_t tia_hits_size(const struct tia_scene *scene, struct tia_tile area);

/* A hit buffer for `area` of the view's picture in `memory`, aligned for uint64_t. TIA_ERR_ARGUMENT when the
 * area is empty, TIA_ERR_MEMORY when `size` is too small. */
int tia_hits_init(struct tia_hits **hits, void *memory, size_t size, const struct tia_view *view, struct tia_tile area);

/* The object that pixel (x, y) of the image sees: an object's index, or TIA_NO_OBJECT; of several
 * samples the first. Lights are not in the hits: tia_light adds them. */
uint32_t tia_hits_object(const struct tia_hits *hits, unsigned x, unsigned y);

/* Finds what the pixels of `tile` see. TIA_ERR_ARGUMENT when the tile leaves the image or the
 * hit buffer. */
int tia_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile);

/* Lights the traced pixels of `tile` and writes them, each once, left to right, top to bottom.
 * `options` may be NULL. */
int tia_light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                   const struct tia_surface *surface, const struct tia_options *options);

/* tia_trace and tia_light_tile in one. */
int tia_render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
               const struct tia_surface *surface, const struct tia_options *options);

/* The same seven functions for each arithmetic that the program is linked with. */
struct tia_core {
    const char *name; /* "q16", "f64", ... */
    size_t (*view_size)(const struct tia_scene *, uint32_t);
    int (*view_init)(struct tia_view **, void *, size_t, const struct tia_scene *, uint32_t, unsigned, unsigned);
    int (*set_lights)(struct tia_view *, const struct tia_light *, uint32_t);
    size_t (*hits_size)(const struct tia_scene *, struct tia_tile);
    int (*hits_init)(struct tia_hits **, void *, size_t, const struct tia_view *, struct tia_tile);
    uint32_t (*hits_object)(const struct tia_hits *, unsigned, unsigned);
    int (*trace)(const struct tia_view *, struct tia_hits *, struct tia_tile);
    int (*light)(const struct tia_view *, const struct tia_hits *, struct tia_tile, const struct tia_surface *,
                 const struct tia_options *);
};

extern const struct tia_core tia_core_q16; /* integers: the functions above */
extern const struct tia_core tia_core_f64; /* double: the reference, libtia-f64.a */
extern const struct tia_core tia_core_f32; /* float: for comparison, libtia-f32.a */
extern const struct tia_core tia_core_chk; /* q16 that reports what leaves its range, libtia-chk.a */

/* CRC-32 (IEEE 802.3, as in zlib) over `count` pixels as little-endian bytes; start with crc 0
 * and feed a frame row by row. */
uint32_t tia_crc32(uint32_t crc, const tia_rgb565 *pixels, size_t count);

#endif
