/* corpus_hard.h - random scenes of balls whose pixels take many digits to decide, the same scenes on every machine.
 * tia_scene_check accepts all of them. */
#ifndef TOOLS_COMMON_CORPUS_CORPUS_HARD_H
#define TOOLS_COMMON_CORPUS_CORPUS_HARD_H

#include "corpus.h"

/* Makes scene number `index` of the series `seed`: a scene of corpus_ties whose lengths are changed by up to 3 steps of
 * 2^-16; balls of 2^-8 to 2^-21 of their distance; a half-transparent ball, which may be tiny, with a light at its
 * centre, around its top, or anywhere above or below its centre; a light, or the eye and a light, within a few steps of
 * a surface. The image is at most 320x240. */
void corpus_hard(struct corpus_scene *out, uint64_t seed, unsigned index);

#endif
