/* filter.h - textures integrated over footprints. */
#ifndef TIA_RENDER_WHITTED_FILTER_H
#define TIA_RENDER_WHITTED_FILTER_H

#include "render/trace/trace.h"

/* Computes the mean of a texture over the footprint with the two edges `edge` and the middle `point`; `value` is as
 * from ray_texture. Returns false if it is the value at the point. */
bool filter_texture(const struct ray_view *view, const struct hit *hit, struct num_point point,
                    const struct tia_texture *texture, const struct num_point edge[2], num_length value[3]);

#endif
