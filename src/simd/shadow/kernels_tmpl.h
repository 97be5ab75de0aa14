/* kernels_tmpl.h - the shadow techniques' kernels, each with the floating-point environment that the bounds assume.
 *
 * Parameters: the doubles of isa/isa.h. Defines: `shadow_kernels`, a struct tia_shadow_kernels. */
#ifndef TIA_SIMD_SHADOW_KERNELS_TMPL_H
#define TIA_SIMD_SHADOW_KERNELS_TMPL_H

#include "drawn.h"
#include "rays_tmpl.h"
#include "shadow/kernels.h"
#include "shares_tmpl.h"
#include "simd/environment.h"

static bool keep_distances(const struct tia_map *map, const struct tia_map_view *view,
                           const struct tia_raster_target *target, struct cancel *cancel)
{
    struct environment caller;

    if (!environment_take(&caller))
        return false;
    keep_band(map, view, target, cancel);
    environment_leave(&caller);
    return true;
}

static bool narrow_map(struct tia_map *map, const struct tia_world *world, const tia_flat_light *light)
{
    struct environment caller;

    if (!environment_take(&caller))
        return false;
    tia_simd_map_drawn(map, world, light);
    environment_leave(&caller);
    return true;
}

static bool light_by_map(struct tia_map_lighting *l)
{
    struct environment caller;

    if (l->look->bias == TIA_BIAS_PLANE || l->look->filter == TIA_FILTER_PCSS || !environment_take(&caller))
        return false;
    light_tile(l);
    environment_leave(&caller);
    return true;
}

static bool light_by_rays(struct tia_shadow_rays *rays)
{
    struct environment caller;

    if (!environment_take(&caller))
        return false;
    trace_tile(rays);
    environment_leave(&caller);
    return true;
}

static const struct tia_shadow_kernels shadow_kernels = {keep_distances, narrow_map, light_by_map, light_by_rays};

#endif
