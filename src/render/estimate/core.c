/* core.c - sampling as a function of one arithmetic. */
#include "estimate.h"

static int sample(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end, struct tia_sum *sums,
                  size_t pitch)
{
    if (!view->renderer->sample)
        return TIA_ERR_UNSUPPORTED;
    if (!tile.width || !tile.height || tile_right(tile) > view->width || tile_bottom(tile) > view->height ||
        end > TIA_SPP_MAX || first > end)
        return TIA_ERR_ARGUMENT;
    view->renderer->sample(view, tile, first, end, sums, pitch);
    return view_stops(view) ? TIA_STOPPED : TIA_OK;
}

const struct tia_estimator NUM_ESTIMATOR = {NUM_NAME, sample};
