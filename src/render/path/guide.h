/* guide.h - a path's first visible surface, for denoisers: see struct tia_guide. */
#ifndef TIA_RENDER_PATH_GUIDE_H
#define TIA_RENDER_PATH_GUIDE_H

#include "render/estimate/estimate.h"
#include "scatter.h"

/* Computes a surface's emission, `glow`, and the weight of its facing ratio, `facing`. Returns false if both are
 * black. */
bool guide_glows(const struct shading *s, num_length glow[3], num_length facing[3]);

/* Adds a surface to the guide, see estimate_guide; `throughput` is that of the mirrors and glass before the surface. */
void guide_add(struct estimate *e, const num_length throughput[3], const num_length albedo[3],
               const struct num_dir *normal, num_length depth);

/* Adds a surface to the guide, unless it is only a mirror or glass: the guide then describes the next surface of the
 * path. */
void guide_add_surface(struct estimate *e, const num_length throughput[3], const struct scatter *scatter,
                       num_length depth);

#endif
