/* exact.c - exact pixels of a view, for programs. */
#include "exact/pixel.h"

#include "core/dither.h"
#include "renderer.h"

static struct tia_exact exact_at(const struct exact_picture *picture, uint32_t number, bool dither)
{
    uint32_t x = number % (uint32_t)picture->width, y = number / (uint32_t)picture->width;
    struct exact_cost cost = {0, false};
    num_u threshold[8];
    struct tia_exact pixel;

    dither_thresholds(dither, (int)y, threshold);
    pixel.colour = tia_exact_pixel(picture, (int)x, (int)y, (tia_q30)threshold[x & 7], &cost);
    pixel.bits = (uint16_t)(32 * cost.words);
    pixel.tie = cost.tie;
    return pixel;
}

int tia_view_exact(const struct tia_view *view, uint32_t first, uint32_t step, uint32_t count, bool dither,
                   struct tia_exact *pixels)
{
    if (!view || !pixels || !step)
        return TIA_ERR_ARGUMENT;
    if (!view->core->renderers || view->renderer->part != SIMD_SPANS)
        return TIA_ERR_UNSUPPORTED;
    if (count && first + (uint64_t)step * (count - 1) >= (uint64_t)view->width * (uint64_t)view->height)
        return TIA_ERR_ARGUMENT;
    struct exact_picture picture = {.scene = view->scene,
                                    .lights = view->lights,
                                    .light_count = view->light_count,
                                    .width = view->width,
                                    .height = view->height};
    tia_exact_depth(&picture.depth, (uint32_t)view->height, view->scene->camera.fov);
    for (uint32_t i = 0; i < count; i++) {
        if (view_stops(view))
            return TIA_STOPPED;
        pixels[i] = exact_at(&picture, first + i * step, dither);
    }
    return TIA_OK;
}
