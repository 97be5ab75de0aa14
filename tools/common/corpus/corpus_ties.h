/* corpus_ties.h - random scenes of balls in which comparisons of docs/definition.md have equal sides, the same scenes
 * on every machine. tia_scene_check accepts all of them. */
#ifndef TOOLS_COMMON_CORPUS_CORPUS_TIES_H
#define TOOLS_COMMON_CORPUS_CORPUS_TIES_H

#include "corpus.h"

#define CORPUS_TIES_KINDS 7

/* Makes scene number `index` of the series `seed`, in which the sides of a comparison are equal in some pixels: two
 * balls, or a ball and a light, at equal distances; a view ray that touches a ball; the eye on a ball or a light; a
 * light on a ball or in the tangent plane of the visible point; a shadow ray that touches a ball, or begins or ends
 * beside its centre; a channel halfway between two levels; the eye in balls with a light on one. The image is 30 to 63
 * pixels wide and 28 to 53 high. */
void corpus_ties(struct corpus_scene *out, uint64_t seed, unsigned index);

struct maker;

/* Makes such a scene with the eye at the origin, to be called between maker_begin() and maker_end(). `kind` modulo
 * CORPUS_TIES_KINDS is the kind of the ties. */
void corpus_make_tie(struct maker *m, unsigned kind);

#endif
