/* simd.h - vector units: pictures several times as fast, with the same bits as plain C.
 *
 * A level is a set of a processor's instructions, such as AVX2; "scalar" is none, with floating point. Levels are a
 * library of their own, libtia-simd.a, for programs on an operating system; libtia.a alone has none, contains no
 * floating point and links without it. A program picks a level, asks how much memory it needs, and hands it to a view
 * that has been prepared:
 *
 *     level = tia_simd_best();
 *     size_t size = tia_simd_size(level, scene, light_capacity, threads);
 *     void *memory = malloc(size);
 *     if (size && !memory)
 *         return TIA_ERR_MEMORY;
 *     status = tia_view_set_simd(view, level, memory, size);
 *
 * A level draws the span renderer's scenes (see scene.h) unless the eye is in a sphere, and scenes with a hierarchy
 * that the ray renderer, ambient occlusion or paths draw. Plain C draws everything else. No pixel, object or hash
 * differs.
 *
 * Levels compute with rounding to nearest, subnormal numbers and masked exceptions, whatever the caller has set: each
 * call sets these in the processor's control register and puts the caller's register back, its exception flags as well.
 * On a processor whose register is unknown here, plain C draws if the environment differs. A view's `stop` is called in
 * the level's environment.
 *
 * A call takes at most 16 KiB of its thread's stack; all else is in the memory above.
 */
#ifndef TIA_SIMD_H
#define TIA_SIMD_H

#include <tia/render.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Returns the widest level that both this library and this processor have; NULL when there is none, or when QEMU
 * emulates the processor. */
const struct tia_simd *tia_simd_best(void);

/* Gives the widest level that is at most as wide as the one called `name`: "plain" (which gives NULL), "scalar",
 * "sse41", "avx2", "avx512", "neon" or "wasm". TIA_ERR_ARGUMENT when no level anywhere has that name. */
int tia_simd_named(const char *name, const struct tia_simd **simd);

/* Returns level number `index` of those that both this library and this processor have, narrowest first; NULL from
 * their number on. */
const struct tia_simd *tia_simd_at(unsigned index);

/* Returns the bytes that the level needs for a view of `scene`; 0 for NULL, SIZE_MAX when there are too many.
 * `workers`: number of calls that may draw the view at the same time, each with 100 to 200 KB; when there are more,
 * plain C draws those. 0 means 1. */
size_t tia_simd_size(const struct tia_simd *simd, const struct tia_scene *scene, uint32_t light_capacity,
                     unsigned workers);

/* Makes the level draw the view from now on; NULL: plain C. `memory`, aligned for uint64_t, must outlive the view. Hits
 * traced before become invalid. As many calls may draw at once as there is memory for, see tia_simd_size;
 * TIA_ERR_MEMORY when `size` is too small for one. */
int tia_view_set_simd(struct tia_view *view, const struct tia_simd *simd, void *memory, size_t size);

/* Returns the name of the level that draws the view, or "plain". */
const char *tia_view_simd(const struct tia_view *view);

#ifdef __cplusplus
}
#endif

#endif
