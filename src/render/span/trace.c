/* trace.c - what the pixels of a tile see: each sphere's pixels are one run a row, found exactly;
 * where runs overlap, the nearer wins, and a tie goes to the lower index. */
#include "kernels.h"
#include "span.h"

static void clear(struct tia_hits *hits, struct tia_tile tile)
{
    for (unsigned y = tile.y; y < (unsigned)tile.y + tile.height; y++) {
        uint32_t *object = hits->object + hits_index(hits, tile.x, y);
        for (unsigned i = 0; i < tile.width; i++)
            object[i] = TIA_NO_OBJECT;
    }
}

static void trace_run(const struct tia_view *view, struct tia_hits *hits, uint32_t n, int y, struct run run)
{
    num_u t[CHUNK];

    for (int x = run.first; x < run.end; x += CHUNK) {
        int count = run.end - x < CHUNK ? run.end - x : CHUNK;
        size_t at = hits_index(hits, (unsigned)x, (unsigned)y);

        sphere_distances(&view->span.lattice, &view->span.bodies[n], y, x, count, t);
        span_keep_nearer(view, n, t, count, hits->t + at, hits->object + at);
    }
}

static void trace_sphere(const struct tia_view *view, struct tia_hits *hits, uint32_t n, struct tia_tile tile)
{
    const struct body *body = &view->span.bodies[n];
    struct run rows = run_within(body->rows, tile.y, tile.y + tile.height), run = {0, 0};

    for (int y = rows.first; y < rows.end; y++) {
        run = sphere_run(&view->span.lattice, body, y, run);
        trace_run(view, hits, n, y, run_within(run, tile.x, tile.x + tile.width));
    }
}

void span_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    clear(hits, tile);
    for (uint32_t n = 0; n < view->scene->sphere_count; n++)
        trace_sphere(view, hits, n, tile);
}
