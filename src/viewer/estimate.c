/* estimate.c - the time that the rest of a coarse picture takes.
 *
 * Two things make the time so far a poor guide. Tiles cost differently: those of the sky a tenth of the others. And the
 * pixels of the first passes are drawn one by one, which for a sampled picture takes several times as long as the same
 * samples in runs of neighbours, of which the later passes consist; only the last pass of blocks has both.
 *
 * So each tile's cost is measured by the pixels that it drew one by one in the passes before that, and the ratio of the
 * two costs by the tiles that have drawn runs. Of the first pass's blocks, of AREA pixels each,
 *   half the pixels have their first sample drawn alone: in 1, 3, 12, 48 and 64 pixels by the passes of blocks;
 *   all other samples, of AREA * spp, are drawn in runs.
 *
 * Before there are runs, their samples are taken to cost 4/5 of others: in the gallery's scenes without sampling they
 * cost 0.6 to 1. This assumption stays with a weight of 1/64 of the runs of the last pass of blocks, so that the first
 * tile does not decide the ratio. */
#include "loop.h"

#define AREA (VIEWER_FIRST_BLOCK * VIEWER_FIRST_BLOCK) /* pixels of a block of the first pass */
#define QUARTER (AREA / 4)                             /* pixels that the passes before the last pass of blocks draw */

/* Times of tiles as if they had drawn just a quarter of the pixels, one by one; microseconds. */
struct costs {
    uint64_t all, alone_left, runs_left; /* of all tiles; and times the quarters that are left */
    uint64_t runs, runs_us; /* of the tiles that have drawn runs, times the quarters; and the time of these */
};

/* Returns the pixels of a block that are drawn one by one in the passes before pass `passes`; with rows all are. */
static uint32_t drawn_alone(const struct loop *loop, unsigned passes)
{
    if (tia_viewer_by_rows(loop))
        return passes ? passes > 1 ? AREA : VIEWER_FIRST_BLOCK : 0;
    return passes ? passes < VIEWER_PASSES ? UINT32_C(1) << 2 * (passes - 1) : AREA / 2 : 0;
}

/* Returns the samples in runs of a block, in quarters of it. */
static uint64_t drawn_in_runs(const struct loop *loop, unsigned passes)
{
    if (tia_viewer_by_rows(loop) || passes < VIEWER_PASSES)
        return 0;
    return (uint64_t)4 * tia_viewer_samples(loop, passes) - 2;
}

static void add_tile(const struct loop *loop, const struct tile_work *work, unsigned passes, struct costs *costs)
{
    unsigned last = tia_viewer_passes(loop);
    bool by_rows = tia_viewer_by_rows(loop);
    uint32_t drawn = drawn_alone(loop, passes), measured = by_rows || drawn < QUARTER ? drawn : QUARTER;
    uint64_t runs = drawn_in_runs(loop, passes), cost;

    if (!measured)
        return;
    cost = work->alone_us * QUARTER / measured;
    costs->all += cost;
    costs->alone_left += cost * (drawn_alone(loop, last) - drawn) / QUARTER;
    costs->runs_left += cost * (drawn_in_runs(loop, last) - runs);
    costs->runs += cost * runs;
    if (runs && work->us > 2 * cost)
        costs->runs_us += work->us - 2 * cost;
}

/* Returns a * b / c, rounded down; less exactly if the product has more than 64 bits. */
static uint64_t scaled(uint64_t a, uint64_t b, uint64_t c)
{
    unsigned shift = 0;

    for (; b >> 32; c >>= 1)
        b >>= 1;
    for (; a >> 32; shift++)
        a >>= 1;
    return c ? a * b / c << shift : 0;
}

uint64_t tia_viewer_left_us(const struct loop *loop, uint64_t spent_us)
{
    struct costs costs = {0};
    uint64_t sum_us = 0, weight;

    for (uint32_t i = 0; i < loop->tiles; i++) {
        add_tile(loop, &loop->work[i], loop->passes[i], &costs);
        sum_us += loop->work[i].us;
    }
    weight = costs.all * 2 / 64;
    if (costs.runs + weight)
        costs.runs_left = scaled(costs.runs_left, costs.runs_us + weight * 4 / 5, costs.runs + weight);
    return scaled(costs.alone_left + costs.runs_left, spent_us, sum_us);
}
