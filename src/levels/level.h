/* level.h - what a level consists of, beside its operations. */
#ifndef TIA_LEVELS_LEVEL_H
#define TIA_LEVELS_LEVEL_H

#include "pair.h"
#include "raster/runs.h"
#include "render/renderer.h"

/* See struct level_renderer: scenes of spheres, and any others. */
bool tia_level_draws(const struct tia_view *view);
void tia_level_light(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                     const struct tia_options *options, void *room);

/* A tile by plain C, from hits of its own. */
void tia_level_light_plain(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                           const struct tia_options *options);

#define LEVEL_ALIGN(n) (((n) + 63) / 64 * 64) /* a line of the caches */

/* A call's room: first the level's own structure of `own` bytes, then what its kernels need. */
static inline size_t level_room(size_t own, size_t of_kernels)
{
    return LEVEL_ALIGN(own) + of_kernels;
}

static inline void *level_kernels_room(void *room, size_t own)
{
    return (char *)room + LEVEL_ALIGN(own);
}

extern const struct level_renderer tia_level_spans, tia_level_rays, tia_level_samples;

extern const struct level_entries tia_level_entries;

/* `runs`: the rasteriser's, or NULL. */
#define LEVEL(level, runs)                                                                                             \
    extern const struct tia_level tia_level_##level;                                                                   \
    extern const struct sure_kernels tia_sure_##level;                                                                 \
    const struct tia_level tia_level_##level = {#level,                                                                \
                                                &tia_level_entries,                                                    \
                                                &span_kernels_plain,                                                   \
                                                {&tia_level_spans, &tia_level_rays, &tia_level_samples},               \
                                                &kernels,                                                              \
                                                &tia_sure_##level,                                                     \
                                                runs}

#endif
