/* span_trace.c - finds the visible sphere of each pixel of a tile. Each sphere's pixels are one span per row, which is
 * found exactly. Where spans overlap, the nearer sphere is visible; in a tie, the one with the lower index. */
#include "math/fast.h"

#include "math/integer.h"
#include "span.h"

/* Returns a sum to which the differences of four objects and `seen` are added. */
static INLINED uint32_t others(uint32_t sum, const uint32_t *object, uint32_t seen)
{
    sum = tia_add_difference(sum, object[0], seen);
    sum = tia_add_difference(sum, object[1], seen);
    sum = tia_add_difference(sum, object[2], seen);
    return tia_add_difference(sum, object[3], seen);
}

int span_same(const uint32_t *object, int count)
{
    uint32_t seen = object[0];
    int end = 1;

    for (; end + 8 <= count; end += 8)
        if (others(others(0, object + end, seen), object + end + 4, seen))
            break;
    while (end < count && object[end] == seen)
        end++;
    return end;
}

static void fill(uint32_t *object, int count, uint32_t n)
{
    int i = 0;

    for (; i + 8 <= count; i += 8) {
        object[i] = object[i + 1] = object[i + 2] = object[i + 3] = n;
        object[i + 4] = object[i + 5] = object[i + 6] = object[i + 7] = n;
    }
    for (; i < count; i++)
        object[i] = n;
}

static void clear(struct tia_hits *hits, struct tia_tile tile)
{
    for (unsigned y = tile.y; y < (unsigned)tile.y + tile.height; y++)
        fill(hits->object + hits_index(hits, tile.x, y), (int)tile.width, TIA_NO_OBJECT);
}

/* True if sphere `n` is certainly nearer than sphere `other` in a span of pixels, found by few of them. */
static bool is_in_front(const struct span_view *spans, uint32_t n, uint32_t other, int y, struct span span)
{
    return spans->coherence && spans->spheres[other].steps && spans->coherence->nearer(spans, n, other, y, span);
}

/* Traces sphere `n` in up to CHUNK pixels, all of which show the same object so far, or none. */
static void trace_chunk(const struct tia_view *view, uint32_t n, int y, struct span span, num_u *distance,
                        uint32_t *object)
{
    const struct span_view *spans = view->prepared;
    int count = span.end - span.first;
    num_u t[CHUNK];

    if (object[0] == TIA_NO_OBJECT || is_in_front(spans, n, object[0], y, span)) {
        fill(object, count, n);
        if (!spans->spheres[n].steps)
            span_distances(spans, n, y, span.first, count, distance);
        return;
    }
    span_distances(spans, n, y, span.first, count, t);
    if (spans->spheres[object[0]].steps)
        span_distances(spans, object[0], y, span.first, count, distance);
    span_keep_nearer(view, n, y, span.first, t, count, distance, object);
}

static void trace_span(const struct tia_view *view, struct tia_hits *hits, uint32_t n, int y, struct span span)
{
    for (struct span part = span; part.first < span.end && !view_stops(view); part.first = part.end) {
        size_t at = hits_index(hits, (unsigned)part.first, (unsigned)y);
        uint32_t *object = hits->object + at;
        int limit = span.end - part.first < CHUNK ? span.end - part.first : CHUNK;
        part.end = part.first + (n ? span_same(object, limit) : limit); /* of sphere 0: no objects yet */
        trace_chunk(view, n, y, part, span_distances_of(hits) + at, object);
    }
}

static void trace_sphere(const struct tia_view *view, struct tia_hits *hits, uint32_t n, struct tia_tile tile)
{
    const struct span_view *spans = view->prepared;
    const struct span_sphere *sphere = &spans->spheres[n];
    struct span rows = span_within(sphere->rows, (int)tile.y, tile_bottom(tile)), span = {0, 0};

    for (int y = rows.first; y < rows.end && !view_stops(view); y++) {
        span = span_sphere_row(view, n, y, span);
        trace_span(view, hits, n, y, span_within(span, (int)tile.x, tile_right(tile)));
    }
}

void span_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    clear(hits, tile);
    for (uint32_t n = 0; n < view->scene->sphere_count; n++)
        trace_sphere(view, hits, n, tile);
}
