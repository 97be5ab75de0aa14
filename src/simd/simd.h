/* simd.h - the tables of an instruction set, and the functions that all instruction sets share. */
#ifndef TIA_SIMD_SIMD_H
#define TIA_SIMD_SIMD_H

#include "raster/runs.h"
#include "render/renderer.h"
#include "span/pair.h"

/* True if the span kernels draw the view, with any lights; see struct simd_renderer. */
bool tia_simd_draws(const struct tia_view *view);

/* Draws a tile of spheres, see struct simd_renderer. */
void tia_simd_light(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                    const struct tia_options *options, void *room);

/* Traces and lights a tile by plain C. */
void tia_simd_light_plain(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                          const struct tia_options *options);

#define SIMD_ALIGN(n) (((n) + 63) / 64 * 64) /* rounds up to whole cache lines */

/* Returns the size in bytes of the scratch memory `room` of a call: a structure of `own` bytes, then the kernels'
 * memory. */
static inline size_t simd_room(size_t own, size_t of_kernels)
{
    return SIMD_ALIGN(own) + of_kernels;
}

static inline void *simd_kernels_room(void *room, size_t own)
{
    return (char *)room + SIMD_ALIGN(own);
}

extern const struct simd_renderer tia_simd_spans, tia_simd_rays, tia_simd_samples, tia_simd_seen;

extern const struct simd_entries tia_simd_entries;

/* Defines the tables of an instruction set. `runs` are the inner loops of the rasteriser, or NULL. */
#define SIMD(simd, runs)                                                                                               \
    extern const struct tia_simd tia_simd_##simd;                                                                      \
    extern const struct sure_kernels tia_sure_##simd;                                                                  \
    const struct tia_simd tia_simd_##simd = {#simd,                                                                    \
                                             &tia_simd_entries,                                                        \
                                             &span_kernels_plain,                                                      \
                                             {&tia_simd_spans, &tia_simd_rays, &tia_simd_samples, &tia_simd_seen},     \
                                             &kernels,                                                                 \
                                             &tia_sure_##simd,                                                         \
                                             runs}

#endif
