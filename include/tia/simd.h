/* simd.h - vector units: pictures several times as fast, with the same bits as plain C.
 *
 * Each instruction set, such as AVX2, has SIMD kernels of its own; "scalar" has kernels in floating point without
 * vectors. The kernels are in a library of their own, libtia-simd.a, for programs on an operating system; libtia.a
 * alone has no kernels and no floating point, and links without libtia-simd.a. A program picks an instruction set,
 * allocates the memory that its kernels need, and hands both to a view that has been prepared:
 *
 *     simd = tia_simd_best();
 *     size_t size = tia_simd_size(simd, scene, light_capacity, threads);
 *     void *memory = malloc(size);
 *     if (size && !memory)
 *         return TIA_ERR_MEMORY;
 *     status = tia_view_set_simd(view, simd, memory, size);
 *
 * SIMD kernels draw three kinds of scenes: those of the span renderer (see scene.h), unless the eye is in a sphere;
 * scenes with a hierarchy that are drawn by the ray renderer, by ambient occlusion or by paths; and the colours of
 * scenes with a hierarchy and a technique for shadows, without curved shapes. Shadow maps, exact shadow rays and the
 * rasteriser's runs are theirs in all scenes with such a technique. Plain C draws everything else. No pixel, object or
 * hash differs.
 *
 * The kernels compute with rounding to nearest, subnormal numbers and masked exceptions, whatever the caller has set:
 * each call sets these in the processor's control register and then restores the caller's register, with its exception
 * flags. On a processor whose register the library does not know, plain C draws if the caller has set another
 * environment. A view's `stop` is called in the kernels' environment.
 *
 * A call takes at most 16 KiB of its thread's stack; all other data is in the memory above. "rvv" takes up to 5 KiB
 * more for each 128 bits that a vector register has beyond the first 128, since whole registers are stored. */
#ifndef TIA_SIMD_H
#define TIA_SIMD_H

#include <tia/render.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Returns the widest instruction set that both this library and this processor have; NULL when there is none, or when
 * QEMU emulates the processor. */
const struct tia_simd *tia_simd_best(void);

/* Sets *simd to the widest instruction set that is at most as wide as the one called `name`: "plain" (which gives
 * NULL), "scalar", "sse41", "avx2", "avx512", "neon", "rvv" or "wasm". TIA_ERR_ARGUMENT when no instruction set has
 * that name, on any processor. */
int tia_simd_named(const char *name, const struct tia_simd **simd);

/* Returns number `index` of the instruction sets that both this library and this processor have, narrowest first; NULL
 * if there are no more. */
const struct tia_simd *tia_simd_at(unsigned index);

/* Returns the number of bytes that the SIMD kernels need for a view of `scene`; 0 for NULL, SIZE_MAX when that number
 * does not fit. `workers` is the number of calls that may draw the view at the same time, each of which needs 100 to
 * 260 KB; plain C draws for calls beyond that number. 0 means 1. */
size_t tia_simd_size(const struct tia_simd *simd, const struct tia_scene *scene, uint32_t light_capacity,
                     unsigned workers);

/* Makes these SIMD kernels draw the view from now on; NULL: plain C. `memory`, aligned for uint64_t, must outlive the
 * view. Hits that were traced earlier become invalid. As many calls may draw at once as there is memory for, see
 * tia_simd_size; TIA_ERR_MEMORY when `size` is too small for one. */
int tia_view_set_simd(struct tia_view *view, const struct tia_simd *simd, void *memory, size_t size);

/* Returns the name of the instruction set that draws the view, or "plain". */
const char *tia_view_simd(const struct tia_view *view);

#ifdef __cplusplus
}
#endif

#endif
