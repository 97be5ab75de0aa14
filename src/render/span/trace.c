/* trace.c - what the pixels of a tile see: each sphere's pixels are one span per row, found exactly;
 * where spans overlap, the nearer wins, and a tie goes to the lower index. */
#include "span.h"

static void clear(struct tia_hits *hits, struct tia_tile tile)
{
    for (unsigned y = tile.y; y < (unsigned)tile.y + tile.height; y++) {
        uint32_t *object = hits->object + hits_index(hits, tile.x, y);
        for (unsigned i = 0; i < tile.width; i++)
            object[i] = TIA_NO_OBJECT;
    }
}

static void trace_span(const struct span_view *spans, struct tia_hits *hits, uint32_t n, int y, struct span span)
{
    num_u t[CHUNK];

    for (int x = span.first; x < span.end; x += CHUNK) {
        int count = span.end - x < CHUNK ? span.end - x : CHUNK;
        size_t at = hits_index(hits, (unsigned)x, (unsigned)y);

        span_distances(spans, n, y, x, count, t);
        span_keep_nearer(spans, n, t, count, span_distances_of(hits) + at, hits->object + at);
    }
}

static void trace_sphere(const struct span_view *spans, struct tia_hits *hits, uint32_t n, struct tia_tile tile)
{
    const struct span_sphere *sphere = &spans->spheres[n];
    struct span rows = span_within(sphere->rows, (int)tile.y, tile_bottom(tile)), span = {0, 0};

    for (int y = rows.first; y < rows.end; y++) {
        span = span_sphere_row(&spans->primary, sphere, y, span);
        trace_span(spans, hits, n, y, span_within(span, (int)tile.x, tile_right(tile)));
    }
}

void span_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    clear(hits, tile);
    for (uint32_t n = 0; n < view->scene->sphere_count && !view_stops(view); n++)
        trace_sphere(view->prepared, hits, n, tile);
}
