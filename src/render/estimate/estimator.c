/* estimator.c - the sampling functions of one arithmetic as a table. */
#include "estimate.h"
#include "render/span/kernels.h"

/* True if the view was made in this arithmetic. */
static bool is_ours(const struct tia_view *view)
{
    return view && view->core->renderers && view->core->renderers->plain == &span_kernels_plain;
}

#include <tia/debug.h>

static bool is_inside(const struct tia_view *view, struct tia_tile tile)
{
    return tile_is_inside(tile, (struct tia_tile){0, 0, (uint16_t)view->width, (uint16_t)view->height});
}

static int gather(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                  const struct tia_gathered *gathered)
{
    if (!is_ours(view))
        return TIA_ERR_ARGUMENT;
    if (!view->renderer->sample)
        return TIA_ERR_UNSUPPORTED;
    if (!is_inside(view, tile) || !gathered || !gathered->sums || end > TIA_SPP_MAX || first > end)
        return TIA_ERR_ARGUMENT;
    if (view->simd)
        view->simd->enter->sample(view, tile, first, end, gathered);
    else
        view->renderer->sample(view, tile, first, end, gathered);
    return view_stops(view) ? TIA_STOPPED : TIA_OK;
}

static int sample(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end, struct tia_sum *sums,
                  size_t pitch)
{
    return gather(view, tile, first, end, &(struct tia_gathered){.sums = sums, .pitch = pitch});
}

static uint32_t enclosing(const struct tia_view *view, uint32_t light)
{
    return is_ours(view) && view->renderer->sample && light < view->light_count ? estimate_enclosing(view, light)
                                                                                : TIA_NO_OBJECT;
}

static int show(const struct tia_view *view, struct tia_tile row, const struct tia_sum *sums, uint32_t count,
                const struct tia_surface *surface, bool dither)
{
    if (!is_ours(view))
        return TIA_ERR_ARGUMENT;
    if (!view->renderer->sample)
        return TIA_ERR_UNSUPPORTED;
    if (!is_inside(view, row) || row.height != 1 || !sums || !surface_is_usable(surface) || count < 1 ||
        count > TIA_SPP_MAX)
        return TIA_ERR_ARGUMENT;
    estimate_show(view, row, sums, count, surface, dither);
    return TIA_OK;
}

const struct tia_estimator NUM_ESTIMATOR = {NUM_NAME, sample, gather, enclosing, show};
