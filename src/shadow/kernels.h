/* kernels.h - the parts of shadow techniques of which vector units have versions of their own, with the results of
 * plain C. Each function returns false where plain C must do the work instead. */
#ifndef TIA_SHADOW_KERNELS_H
#define TIA_SHADOW_KERNELS_H

#include <stdbool.h>

struct cancel;
struct tia_map;
struct tia_map_lighting;
struct tia_map_view;
struct tia_raster_target;
struct tia_raster_vertex;
struct tia_shadow_rays;
struct tia_world;

struct tia_shadow_kernels {
    /* Stores the distances at a band of a map's texels, whose nearest faces are in the target. */
    bool (*keep)(const struct tia_map *map, const struct tia_map_view *view, const struct tia_raster_target *target,
                 struct cancel *cancel);
    /* Narrows the parts of a map that are drawn to those that visible points look up; they are moved by no bias, and
     * the filter is not TIA_FILTER_PCSS. */
    bool (*narrow)(struct tia_map *map, const struct tia_world *world, const struct tia_raster_vertex *light);
    /* Lights all pixels of a tile, see map_light.h; the bias is not TIA_BIAS_PLANE, nor the filter TIA_FILTER_PCSS. */
    bool (*light)(struct tia_map_lighting *l);
    /* Lights all pixels of a tile by exact shadow rays, see shadow_rays.h. */
    bool (*rays)(struct tia_shadow_rays *rays);
};

#endif
