/* debug.h - for tests and comparison: paths of light, other arithmetics, checksums, exact pixels, and reasons
 * for refusals. It is not included by tia.h, and may change in any version.
 */
#ifndef TIA_DEBUG_H
#define TIA_DEBUG_H

#include <tia/motion.h>
#include <tia/simd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- paths of light ---- */

/* Kinds of rays. */
enum tia_ray { TIA_RAY_PRIMARY, TIA_RAY_REFLECTED, TIA_RAY_REFRACTED, TIA_RAY_PAST, TIA_RAY_SHADOW };

/* A traced ray. TIA_RAY_PAST goes straight on behind an opacity texture; a shadow ray runs from a surface to a light,
 * or for a length of 1 if the light is directional. Numbers are rounded to Q16.16 and clamped to its range. */
struct tia_traced {
    enum tia_ray ray;
    struct tia_vec3 from, to; /* ends; `to` is at the distance 1 from `from` if the ray meets nothing */
    tia_q16 length;           /* INT32_MAX: the ray meets nothing */
    uint32_t object, light;   /* the object and the light that the ray meets, or a shadow ray's surface and light;
                                 TIA_NO_OBJECT: none */
    struct tia_vec3 normal;   /* shading normal at `to`, on the side from which the ray comes */
    bool arrives;             /* TIA_RAY_SHADOW: some of the light arrives */
};

/* An observer of rays, for tia_core_watched; other cores ignore it. It changes no pixel. */
struct tia_observer {
    void (*traced)(void *ctx, const struct tia_traced *traced); /* NULL: only tests are counted */
    void *ctx;
    uint32_t tests; /* counts the tests of rays against boxes of hierarchies, objects and faces of meshes */
};

/* The output that `debug` of struct tia_options selects. All zero: none. */
struct tia_debug {
    uint32_t *path_hash;           /* NULL, or receives a hash of each pixel's light paths, row by row of the tile */
    uint64_t *lit;                 /* NULL, or receives the lights that reach each pixel, row by row of the tile */
    struct tia_observer *observer; /* NULL, or is called for each ray, in the order of the path hash; the span renderer
                                      does not call it */
};

/* The bits of `lit` do not depend on the lights' colours. The samples of all lights are numbered consecutively, in the
 * order of the lights; an ambient light has none. Bit k is set if sample number k arrives, as defined below, at the
 * point that the pixel's first sample shows; no bit is set if it shows the background or a light. Samples from 64 on
 * have no bit. The span renderer does not write `lit`: bits 0..15 of its path hash hold the same information. */

/* Pixels whose rays took the same paths have the same path hash. If a pixel's colour differs between two arithmetics,
 * equal hashes show that the cause is rounding, not a ray that took another path.
 *
 * Span renderer: bit n (0..15) is set when light n reaches the point; bits 16..31 hold the sum of (n + 1)(j + 1) over
 * the transparent spheres j in between. Where light n itself is visible, the hash is 0xffff0000 + n.
 *
 * Ray renderer: the 32-bit FNV-1a hash (start 2166136261, then (hash ^ byte) * 16777619) of 32-bit words, lowest byte
 * first. For each sample in order, for each of its rays, depth first, the reflected before the refracted ray, and that
 * before the ray behind an opacity texture, the words are: the index of the object hit, TIA_NO_OBJECT for the
 * background, or TIA_NO_OBJECT - 1 - n for light n. An object's index is followed by
 *   - the part hit: of a box the face, 2 axis + 1 on the side of its maximum; of a cylinder or cone 0 for the
 *     side, 1 for the base, 2 for the top; of a mesh the face; of a grid 6 times the cell, plus the face;
 *     otherwise 0;
 *   - when the material's colour is not black: of a checker 0 or 1, of an image without `bilinear` the texel,
 *     counted row by row from 0;
 *   - with an opacity texture without `bilinear`, its texel;
 *   - unless the opacity is 0, for each sample of each light, in order, except ambient lights without a radius: 1 if
 *     the sample arrives (G.L > 0 and N.L > 0, see material.h, P is inside a spot light's cone, and T is not black),
 *     otherwise 0. */

/* ---- other arithmetics ---- */

extern const struct tia_core tia_core_watched; /* integers, with an observer of rays: libtia-watched.a */
extern const struct tia_core tia_core_f32;     /* float: libtia-f32.a */
extern const struct tia_core tia_core_f128;    /* 113 bits: libtia-f128.a, where the compiler has such a type */
extern const struct tia_core tia_core_chk;     /* integers, with reports of values out of range: libtia-chk.a */
extern const struct tia_estimator tia_estimator_f32;
extern const struct tia_estimator tia_estimator_f128;
extern const struct tia_estimator tia_estimator_chk;

/* ---- pictures ---- */

/* Returns the CRC-32 (IEEE 802.3, as in zlib) over `count` pixels as little-endian bytes. `crc` is 0 for the first row
 * of a picture, then the result for the row before. If `pixels` is NULL, the result is `crc`. */
uint32_t tia_crc32(uint32_t crc, const tia_rgb565 *pixels, size_t count);

/* The quantity that a picture shows: the mean of a guide, for normals (N + 1)/2, or the standard error of the
 * luminance. */
enum tia_shown_guide { TIA_SHOW_NOTHING, TIA_SHOW_NORMAL, TIA_SHOW_DEPTH, TIA_SHOW_ALBEDO, TIA_SHOW_ERROR };

/* Returns "normal", "depth", "albedo", "error"; NULL for others. */
const char *tia_shown_guide_name(unsigned shown);

/* Returns the quantity `shown` of the pixel at index `at` of `gathered`, as a sum of `count` samples; for other values
 * of `shown`, the albedo. The sum is 0 if gathered->sums, its guides or, for the error, its squares are NULL, or the
 * count is not in 1..TIA_SPP_MAX. */
struct tia_sum tia_guide_shown(enum tia_shown_guide shown, const struct tia_gathered *gathered, size_t at,
                               uint32_t count);

/* Returns the estimated standard error of a pixel's mean luminance (red + 2 green + blue)/4, in units of 2^-16, from
 * the spread of its samples; for one sample the error is that sample's luminance, for none 0. Sobol points are more
 * even than random ones, so the estimate tends to be too large. */
uint32_t tia_standard_error(const struct tia_sum *sum, uint64_t squares, uint32_t count);

/* ---- exact pictures ---- */

/* An exact pixel, as docs/definition.md defines it, and the precision that decided it. */
struct tia_exact {
    tia_rgb565 colour;
    uint16_t bits; /* precision that decided the pixel: 64, 128, 256 or 512 bits */
    bool tie;      /* the sides of a comparison are equal, or count as equal with 512 bits */
};

/* Computes `count` exact pixels of a view: those with the numbers first, first + step, first + 2 step and so on. Pixels
 * are numbered row by row from the upper left. This takes some microseconds a pixel, or milliseconds for a tie. Returns
 * TIA_ERR_UNSUPPORTED unless the span renderer draws the view, in any arithmetic; TIA_ERR_ARGUMENT when a pixel is
 * outside the picture or `step` is 0; TIA_STOPPED. */
int tia_view_exact(const struct tia_view *view, uint32_t first, uint32_t step, uint32_t count, bool dither,
                   struct tia_exact *pixels);

/* ---- shadows and motion ---- */

/* Returns the index of the first object that is too far away for the rasteriser in a width x height view; tia_view_init
 * then returns TIA_ERR_RANGE. TIA_NO_OBJECT: there is none, or tia_scene_check refuses the scene. A corner is too far
 * away if a clip coordinate, see raster.h, reaches 2^TIA_RANGE_MAX, in orthographic views 2^TIA_RANGE_FLAT: its
 * distance from the view's middle is then that many times half the view's width or height. */
uint32_t tia_shadow_too_far(const struct tia_scene *scene, unsigned width, unsigned height);

/* Returns the index of the first of `count` lights that is too far away for the scene's shadows in a width x height
 * view; tia_view_init or tia_view_set_lights then returns TIA_ERR_RANGE. TIA_NO_OBJECT: there is none. All of an area
 * light must be near enough. *range receives the r for which 2^r is too far: as for corners, but less in an
 * orthographic view whose image has more than 1024 pixels in a row or column. In orthographic views lights much farther
 * away than all corners are in range, too: they count as directional if this moves no shadow by half a pixel. */
uint32_t tia_shadow_light_too_far(const struct tia_scene *scene, const struct tia_light *lights, uint32_t count,
                                  unsigned width, unsigned height, unsigned *range);

/* Returns the number of bytes of working memory for tia_shadow_mesh_closes; SIZE_MAX for NULL. */
size_t tia_shadow_mesh_room(const struct tia_mesh *mesh);

/* True if each edge of each face is an edge of another face in the opposite direction. A mesh that is not closed casts
 * the same shadow, but face by face, so that its shadow volumes have more sides. `room` has tia_shadow_mesh_room(mesh)
 * bytes; if it is not aligned for uint32_t, the result is false. The mesh is one that tia_scene_check accepts. */
bool tia_shadow_mesh_closes(const struct tia_mesh *mesh, void *room);

/* True if falling balls bounce off shape number `shape`: a plane or a box whose transform has no track. */
bool tia_scene_bounces_off(const struct tia_scene *scene, uint32_t shape);

/* ---- vector units ---- */

/* Returns the rasteriser's inner loops for an instruction set, to be set in struct tia_raster_target: those of plain C
 * if it has none of its own. A view with vector units uses those of its instruction set, which need no memory. */
const struct tia_raster_runs *tia_simd_raster(const struct tia_simd *simd);

#ifdef __cplusplus
}
#endif

#endif
