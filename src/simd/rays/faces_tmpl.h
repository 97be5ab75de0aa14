/* faces_tmpl.h - the faces of a leaf of a mesh: first in floats, see pairs_tmpl.h, then those that any line may meet.
 *
 * Parameters: the doubles and pairs of floats of isa/isa.h. Defines: meet_some(). */
#ifndef TIA_SIMD_RAYS_FACES_TMPL_H
#define TIA_SIMD_RAYS_FACES_TMPL_H

#include "descend_tmpl.h"
#include "pairs_tmpl.h"
#include "triangle_tmpl.h"

/* Intersects the plane of a face with some lanes' rays, in `inside` of which they certainly pass inside its edges. */
LANE_OP void meet_lanes_of(const struct sure_tree *tree, const struct sure_flat *f, uint32_t face, unsigned lanes,
                           unsigned inside, struct query *q)
{
    struct sides sides = {mof(inside), mnot(mof(lanes))};
    double at[3];

    if (lanes & ~inside) {
        const struct sure_face whole = sure_face_from(tree, face, f);
        sides = face_sides(q->p, &q->lines->line, &whole);
    }
    sure_corner(at, &f->corner);
    q->group = q->groups ? tree->groups[face] : 0;
    meet_plane_of(q, at, f->normal, (double)f->extent, face, sides);
}

/* The same for a face of a large mesh. */
static __attribute__((noinline)) void meet_lanes_of_large(const struct sure_tree *tree, uint32_t face, unsigned lanes,
                                                          unsigned inside, struct query *q)
{
    struct sure_flat flat;

    tia_sure_set_flat(&flat, tree->mesh, face);
    meet_lanes_of(tree, &flat, face, lanes, inside, q);
}

/* Intersects one face of a pair. Bit 2 k stands for lane k: it is set in `maybe` if the line may pass inside the face's
 * edges, and in `inside` if it certainly does. The face on which rays start is most often the only one that they may
 * meet, so these lanes are left out first. */
LANE_OP void meet_one_of(const struct sure_tree *tree, uint32_t face, unsigned maybe, unsigned inside, struct query *q)
{
    unsigned lanes = half(maybe), own = lanes & q->lines->starts;

    if (own)
        lanes &= ~(own & mbits(from_element(q, vset((double)face))));
    if (!lanes)
        return;
    if (tree->faces)
        meet_lanes_of(tree, &tree->faces[face], face, lanes, half(inside), q);
    else
        meet_lanes_of_large(tree, face, lanes, half(inside), q);
}

/* Prefetches the faces of a large mesh that any line may meet, bit i of `met` being that of pair i. */
LANE_OP void prefetch_faces(const struct tia_face *faces, const struct sure_pair *pairs, unsigned met)
{
    for (; met; met &= met - 1) {
        const struct sure_pair *pair = &pairs[__builtin_ctz(met)];
        __builtin_prefetch(&faces[pair->face[0]]);
        __builtin_prefetch(&faces[pair->face[1]]);
    }
}

/* Intersects some of a leaf's faces. First finds the faces that any line may meet, without a branch for each, and then
 * intersects these. */
LANE_OP void meet_some(const struct sure_tree *tree, const struct sure_pair *pairs, uint32_t count, struct query *q)
{
    unsigned inside[SURE_LEAF / 2], maybe[SURE_LEAF / 2], met = 0, active = twice(mbits(q->active));

    for (uint32_t i = 0; i < count; i++) {
        struct passes passes = pair_passes(q->lines, &pairs[i]);
        inside[i] = passes.inside;
        maybe[i] = active & ~passes.outside;
        met |= (unsigned)(maybe[i] != 0) << i;
    }
    if (!tree->faces)
        prefetch_faces(tree->mesh->faces, pairs, met);
    for (; met; met &= met - 1) {
        int i = __builtin_ctz(met);
        if (maybe[i] & EVEN)
            meet_one_of(tree, pairs[i].face[0], maybe[i], inside[i], q);
        if (maybe[i] >> 1 & EVEN)
            meet_one_of(tree, pairs[i].face[1], maybe[i] >> 1, inside[i] >> 1, q);
    }
}

#endif
