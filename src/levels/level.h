/* level.h - what a level consists of, beside its operations. */
#ifndef TIA_LEVELS_LEVEL_H
#define TIA_LEVELS_LEVEL_H

#include "pair.h"
#include "raster/runs.h"
#include "render/renderer.h"

/* See struct tia_level. */
bool tia_level_draws(const struct tia_view *view);
void tia_level_light(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                     const struct tia_options *options);

/* `runs`: the rasteriser's, or NULL. */
#define LEVEL(level, runs)                                                                                             \
    extern const struct tia_level tia_level_##level;                                                                   \
    const struct tia_level tia_level_##level = {#level,                                                                \
                                                &span_kernels_plain,                                                   \
                                                tia_level_pairs_size,                                                  \
                                                tia_level_draws,                                                       \
                                                tia_level_prepare,                                                     \
                                                tia_level_light,                                                       \
                                                &kernels,                                                              \
                                                runs}

#endif
