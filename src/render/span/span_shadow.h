/* span_shadow.h - the kernels' constants for one sphere that may stand between a light and a span of pixels. */
#ifndef TIA_RENDER_SPAN_SPAN_SHADOW_H
#define TIA_RENDER_SPAN_SPAN_SHADOW_H

#include "span_light.h"

/* Prepares all of `line` except count, with 0 as its first pixel, for the sphere `caster` and the pixels from (x, y)
 * on. */
void shadow_line_prepare(const struct primary_rays *primary, const struct light_source *source,
                         const struct span_sphere *caster, int x, int y, struct shadow_line *line);

#endif
