/* corpus_flat.h - random scenes of flat faces, which all techniques for shadows can draw, the same on every machine. */
#ifndef TOOLS_COMMON_CORPUS_CORPUS_FLAT_H
#define TOOLS_COMMON_CORPUS_CORPUS_FLAT_H

#include "corpus_parts.h"

/* Makes random scene number `index` of the series `seed` of corpus_rays.h, flattened: each sphere, disc, cylinder, cone
 * or grid is replaced by a box of its size, all materials are opaque, disc and sphere lights become rectangles, and
 * area lights have at most 9 samples. tia_scene_check accepts it with every technique. */
void corpus_random_flat(struct corpus_rays *out, uint64_t seed, unsigned index);

/* Makes the scene of corpus_random_flat with its curved shapes, which are drawn by rays or tessellated. */
void corpus_random_opaque(struct corpus_rays *out, uint64_t seed, unsigned index);

#endif
