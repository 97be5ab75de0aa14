/* bump.h - normals perturbed by the gradient of a texture, see tia/material.h. */
#ifndef TIA_RENDER_TRACE_BUMP_H
#define TIA_RENDER_TRACE_BUMP_H

#include "trace.h"

/* Perturbs the shading normal of a hit, whose material has a bump; `back` is true where it points inwards. The result
 * is on the viewer's side if the normal was. */
void bump_normal(const struct ray_view *view, const struct hit *hit, struct num_point point, struct num_dir viewer,
                 bool back, struct num_dir *normal);

#endif
