/* span_shadow.h - the kernels' constants for one sphere that may stand between a light and a span of pixels. */
#ifndef TIA_RENDER_SPAN_SPAN_SHADOW_H
#define TIA_RENDER_SPAN_SPAN_SHADOW_H

#include "span_light.h"

/* True if the caster certainly shades no point of the light source's sphere: it is behind all of them as seen from the
 * light. */
bool shadow_is_behind(const struct light_source *source, const struct span_sphere *caster);

/* Prepares all of `line` except count, for the sphere `caster` and the pixels from (x, y) on. False when the caster
 * shades none of these pixels. */
bool shadow_line_prepare(const struct primary_rays *primary, const struct light_source *source,
                         const struct span_sphere *caster, int x, int y, struct shadow_line *line);

#endif
