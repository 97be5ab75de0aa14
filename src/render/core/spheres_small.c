/* spheres_small.c - the core of the smallest code size, for scenes of spheres alone. */
#include "render/renderer.h"
#include "render/span/kernels.h"
#include "scene/check/scene_check.h"

static const struct renderer *const renderers[] = {&span_renderer_small, NULL};
static const struct tia_renderers spheres = {renderers, &span_kernels_plain, tia_check_spheres};

const struct tia_core core_spheres_small = TIA_CORE(NUM_NAME, &spheres);
