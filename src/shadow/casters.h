/* casters.h - finds the faces that may stand between a pixel's visible point and a light: a hierarchy of boxes is
 * tested against the segment from the point to the light. The test may find too many faces, never too few; occluder.h
 * decides.
 *
 * The boxes' coordinates have 27 bits; their unit is 2^shift units of the vertices. The visible point is rounded, and a
 * segment that reaches far outside the root is cut by halving; together these move the segment's points by less than 48
 * units of the vertices. Each box is enlarged by as much. */
#ifndef TIA_SHADOW_CASTERS_H
#define TIA_SHADOW_CASTERS_H

#include <tia/bvh.h>

#include "occluder.h"
#include "scene/cancel.h"

struct tia_casters {
    struct tia_bvh_tree tree;
    const uint32_t *unbounded; /* faces with a corner at infinity, which are in no box */
    uint32_t unbounded_count;
    int shift;
};

/* Returns the number of bytes for a hierarchy of this number of faces. */
uint64_t tia_casters_size(uint64_t faces);
/* Builds the hierarchy in memory aligned for uint64_t; TIA_STOPPED when cancelled. */
int tia_casters_build(struct tia_casters *casters, void *memory, const struct tia_flat_scene *flat,
                      struct cancel *cancel);

/* A segment from a to b, in the boxes' units. */
struct tia_segment {
    int64_t sum[3], way[3]; /* a + b, b - a */
};

enum tia_segment_kind {
    TIA_SEGMENT_MISSES, /* the segment is near no box */
    TIA_SEGMENT_INSIDE,
    TIA_SEGMENT_FAR /* the visible point is too far away for this test: any face may hide the light */
};

/* Prepares the segment from a visible point to a light. */
enum tia_segment_kind tia_segment_init(struct tia_segment *segment, const struct tia_casters *casters,
                                       const struct tia_seen *seen, const struct tia_flat_scene *flat,
                                       const tia_flat_light *light);

struct tia_segment_walk {
    const struct tia_casters *casters;
    struct tia_segment segment;
    unsigned depth;
    uint32_t stack[TIA_BVH_DEPTH_MAX + 2];
};

/* Begins a walk through the leaves near walk->segment, which must be set. */
void tia_segment_walk_start(struct tia_segment_walk *walk, const struct tia_casters *casters);

/* Returns the next leaf near the segment, or NULL. */
const struct tia_bvh_node *tia_segment_walk_leaf(struct tia_segment_walk *walk);

#endif
