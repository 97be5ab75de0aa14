/* seal.c - checks of a view's memory. No pointer in it is used before the bytes that hold it have been compared. */
#include "math/align.h"
#include "math/checksum.h"
#include "renderer.h"
#include "scene/scene_sum.h"

#include <tia/trust.h>

_Static_assert(sizeof(((struct tia_seal *)NULL)->sums) == (SCENE_STEPS + 1) * sizeof(uint64_t), "a sum for each step");

static bool is_usable(const struct tia_sealed *sealed)
{
    return sealed && memory_is_usable(sealed->view) && sealed->view_size >= sizeof(struct tia_view) &&
           memory_is_usable(sealed->seal);
}

static uint64_t view_sum(const struct tia_sealed *sealed)
{
    struct checksum sum = {0, 0};

    tia_checksum_add(&sum, sealed->view, sealed->view_size);
    return tia_checksum_value(&sum);
}

int tia_view_seal(const struct tia_sealed *sealed)
{
    if (!is_usable(sealed))
        return TIA_ERR_ARGUMENT;
    const struct tia_view *view = sealed->view;

    if (!view->core->renderers || view->core->drawing || view->simd)
        return TIA_ERR_UNSUPPORTED;
    if (sealed->view_size < view->core->view_size(view->core, view->scene, view->light_capacity))
        return TIA_ERR_MEMORY;
    sealed->seal->sums[0] = view_sum(sealed);
    for (int step = 0; step < SCENE_STEPS; step++)
        sealed->seal->sums[1 + step] = sealed->without_scene ? 0 : tia_scene_sum(view->scene, step);
    return TIA_OK;
}

int tia_view_check(const struct tia_sealed *sealed)
{
    if (!is_usable(sealed))
        return TIA_ERR_ARGUMENT;
    const uint64_t *sums = sealed->seal->sums;

    if (view_sum(sealed) != sums[0])
        return TIA_ERR_DAMAGED;
    for (int step = 0; !sealed->without_scene && step < SCENE_STEPS; step++)
        if (tia_scene_sum(((const struct tia_view *)sealed->view)->scene, step) != sums[1 + step])
            return TIA_ERR_DAMAGED;
    return TIA_OK;
}

int tia_view_set_lights_checked(const struct tia_sealed *sealed, const struct tia_light *lights, uint32_t count)
{
    int status = tia_view_check(sealed);

    if (!status)
        status = tia_view_set_lights(sealed->view, lights, count);
    return status ? status : tia_view_seal(sealed);
}

int tia_view_draw_checked(const struct tia_sealed *sealed, struct tia_tile tile, const struct tia_surface *surface,
                          const struct tia_options *options)
{
    struct tia_hits *hits;
    int status = tia_view_check(sealed);

    if (!status)
        status = tia_hits_init(&hits, sealed->hits, sealed->hits_size, sealed->view, tile);
    if (!status)
        status = tia_view_draw(sealed->view, hits, tile, surface, options);
    int checked = tia_view_check(sealed);
    return checked ? checked : status;
}
