/* core.c - the core of each arithmetic, with all renderers. */
#include "render/renderer.h"
#include "render/span/kernels.h"
#include "scene/check/scene_check.h"

static const struct renderer *const renderers[] = {&ao_renderer,   &path_renderer,    &raster_renderer,
                                                   &span_renderer, &whitted_renderer, NULL};
static const struct tia_renderers all = {renderers, &span_kernels_plain, tia_check_scene};

const struct tia_core NUM_CORE = TIA_CORE(NUM_NAME, &all);
