/* shadow.h - prepares the test of one sphere between a light and a run of pixels. */
#ifndef TIA_SPAN_SHADOW_H
#define TIA_SPAN_SHADOW_H

#include "light.h"

/* Prepares `line`, but for count, for the sphere `caster` from pixel (x, y) on.
 * False when it shades none of them. */
bool shadow_line_prepare(const struct lattice *lattice, const struct light_source *source, const struct body *caster,
                         int x, int y, struct shadow_line *line);

#endif
