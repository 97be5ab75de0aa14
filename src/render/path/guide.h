/* guide.h - what a path says about what it sees first, for denoisers: see struct tia_guide. */
#ifndef TIA_RENDER_PATH_GUIDE_H
#define TIA_RENDER_PATH_GUIDE_H

#include "render/estimate/estimate.h"
#include "scatter.h"

/* What a surface sends by itself, to both sides and along its normal; false: nothing. */
bool guide_glows(const struct shading *s, num_length glow[3], num_length facing[3]);

/* See estimate_guide; the throughput is that of mirrors and glass before. */
void guide_add(struct estimate *e, const num_length throughput[3], const num_length albedo[3],
               const struct num_dir *normal, num_length depth);

/* The same of a surface, if it is more than a mirror or glass: what is behind those is seen instead. */
void guide_add_surface(struct estimate *e, const num_length throughput[3], const struct scatter *scatter,
                       num_length depth);

#endif
