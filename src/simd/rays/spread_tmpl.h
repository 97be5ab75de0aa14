/* spread_tmpl.h - one lane's point broadcast to all lanes, and sums over all lanes added to that lane.
 *
 * Parameters: the doubles of isa/isa.h. Defines: spread_shade(), on_several(), gain_lane(). */
#ifndef TIA_SIMD_RAYS_SPREAD_TMPL_H
#define TIA_SIMD_RAYS_SPREAD_TMPL_H

#include "surface_tmpl.h"

LANE_OP vm mspread(vm m, int k)
{
    return mof(mbits(m) >> k & 1 ? (1u << LANES) - 1 : 0);
}

/* Broadcasts the members that the lighting of a point needs. */
static void spread_shade(const struct shade *h, int k, struct shade *to)
{
    to->point = v3_spread(&h->point, k);
    to->outside = v3_spread(&h->outside, k);
    to->geometric = v3_spread(&h->geometric, k);
    to->normal = v3_spread(&h->normal, k);
    to->viewer = v3_spread(&h->viewer, k);
    to->ep = vspread(&h->ep, k);
    to->eoutside = vspread(&h->eoutside, k);
    to->eg = vspread(&h->eg, k);
    to->en = vspread(&h->en, k);
    to->ev = vspread(&h->ev, k);
    to->facing = vspread(&h->facing, k);
    to->efacing = vspread(&h->efacing, k);
    to->ecolour = vspread(&h->ecolour, k);
    to->exponent = vspread(&h->exponent, k);
    for (int c = 0; c < 3; c++) {
        to->colour[c] = vspread(&h->colour[c], k);
        to->specular[c] = vspread(&h->specular[c], k);
    }
    to->glossy = mspread(h->glossy, k);
    to->back = mspread(h->back, k);
    to->id = vspread(&h->id, k);
    to->part = vspread(&h->part, k);
    for (int i = 0; i < LANES; i++) {
        to->index[i] = h->index[k];
        to->element[i] = h->element[k];
    }
}

/* True if the lanes' points are on different objects. */
LANE_OP bool on_several(const struct shade *h, unsigned lanes)
{
    bool several = false;

    for (int k = 0; k < LANES; k++)
        several = several || (lanes >> k & 1 && h->index[k] != h->index[__builtin_ctz(lanes)]);
    return several;
}

/* Returns v with the sum of all lanes of `more` added to lane k. */
LANE_OP vd gain_lane(vd v, int k, vd more)
{
    double lanes[LANES], added[LANES], sum = 0;

    vstore(lanes, v);
    vstore(added, more);
    for (int i = 0; i < LANES; i++)
        sum += added[i];
    lanes[k] += sum;
    return vload(lanes);
}

#endif
