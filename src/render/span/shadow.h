/* shadow.h - prepares the test of one sphere between a light and a span of pixels. */
#ifndef TIA_RENDER_SPAN_SHADOW_H
#define TIA_RENDER_SPAN_SHADOW_H

#include "light.h"

/* Prepares `line`, but for count, for the sphere `caster` from pixel (x, y) on.
 * False when it shades none of them. */
bool shadow_line_prepare(const struct primary_rays *primary, const struct light_source *source,
                         const struct span_sphere *caster, int x, int y, struct shadow_line *line);

#endif
