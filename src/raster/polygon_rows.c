/* polygon_rows.c - the pixels that a polygon covers, row by row.
 *
 * An edge x i + y j + c changes its sign in row j at -(y j + c)/x, a linear function of j. This position is stepped in
 * fixed point; where it is too close to a pixel, the edge itself is evaluated. So the runs are exact, no row needs a
 * division, and only such an evaluation may need more than 64 bits.
 *
 * ranges.h has the error bounds, and tests/proofs/raster_rows.g proves them. The slope of nearly horizontal edges,
 * which are rare, is too large for this; their runs are found by bisection. */
#include "polygon_rows.h"

#include "ranges.h"

#define SMALL_AREA 64 /* largest number of pixels of a box in which each pixel is tested */

struct walker {
    int64_t at, step;
    unsigned edge;
};

struct walkers {
    struct walker left[POLYGON_EDGES], right[POLYGON_EDGES];
    unsigned lefts, rights, bisected, bisect[POLYGON_EDGES];
};

/* A number in block floating point; its magnitude is top 2^(bits - 64), with top >= 2^63, or 0. */
struct block {
    uint64_t top;
    int bits;
    bool negative;
};

static struct block block_of(wide a)
{
    wide size = wide_size(a);
    int bits = wide_bits(size);

    return (struct block){bits ? (uint64_t)wide_high(wide_up(size, (unsigned)(128 - bits))) : 0, bits,
                          wide_is_negative(a)};
}

static struct block block_of_narrow(int64_t a)
{
    uint64_t size = a < 0 ? 0 - (uint64_t)a : (uint64_t)a;
    unsigned zeros = size ? tia_clz64(size) : 64;

    return (struct block){size ? size << zeros : 0, 64 - (int)zeros, a < 0};
}

/* Returns -a/b in fixed point; `reciprocal` is 2^126/b.top. */
static int64_t quotient(struct block a, struct block b, int64_t reciprocal)
{
    int shift = 125 - WALKER_BITS + b.bits - a.bits;

    if (shift > 126)
        return 0;
    int64_t size = wide_down(wide_product((int64_t)(a.top >> 1), reciprocal), (unsigned)shift);
    return a.negative == b.negative ? -size : size;
}

static void add_edge(struct walkers *w, unsigned edge, struct block x, struct block y, struct block first)
{
    if (!x.bits || first.bits - x.bits > WALKER_FIRST || y.bits - x.bits > WALKER_STEP) {
        w->bisect[w->bisected++] = edge;
        return;
    }
    int64_t reciprocal = wide_reciprocal(x.top);
    struct walker *walker = x.negative ? &w->right[w->rights++] : &w->left[w->lefts++];
    *walker = (struct walker){quotient(first, x, reciprocal) + WALKER_ERROR, quotient(y, x, reciprocal), edge};
}

static void start(struct walkers *w, const struct polygon *p)
{
    w->lefts = w->rights = w->bisected = 0;
    for (unsigned i = 0; i < p->count; i++) {
        if (p->narrow) {
            const struct narrow_form *e = &p->of.narrow_forms.edge[i];
            add_edge(w, i, block_of_narrow(e->x), block_of_narrow(e->y), block_of_narrow(narrow_form_at(e, 0, p->y0)));
        } else {
            const struct wide_form *e = &p->of.wide_forms.edge[i];
            add_edge(w, i, block_of(e->x), block_of(e->y), block_of(wide_form_at(e, 0, p->y0)));
        }
    }
}

/* True if the first pixel at or after the exact position is certainly the one after `at`. Otherwise it is that pixel or
 * the one before. The exact position is 0 to 2 WALKER_ERROR units before `at`. */
static inline bool is_sure(int64_t at)
{
    return (at & ((INT64_C(1) << WALKER_BITS) - 1)) > INT32_C(2) * WALKER_ERROR;
}

static void clip_left(const struct walkers *w, const struct polygon *p, int y, int *x0, int x1)
{
    for (unsigned i = 0; i < w->lefts; i++) {
        int64_t x = (w->left[i].at >> WALKER_BITS) + is_sure(w->left[i].at);
        if (!is_sure(w->left[i].at) && x >= *x0 && x < x1)
            x += !polygon_edge_covers(p, w->left[i].edge, (int)x, y);
        if (x > *x0)
            *x0 = x < x1 ? (int)x : x1;
    }
}

static void clip_right(const struct walkers *w, const struct polygon *p, int y, int x0, int *x1)
{
    for (unsigned i = 0; i < w->rights; i++) {
        int64_t x = (w->right[i].at >> WALKER_BITS) + is_sure(w->right[i].at);
        if (!is_sure(w->right[i].at) && x >= x0 && x < *x1)
            x += polygon_edge_covers(p, w->right[i].edge, (int)x, y);
        if (x < *x1)
            *x1 = x > x0 ? (int)x : x0;
    }
}

/* Clips the run at the left edges, then steps them. If the greatest position is certain, no other edge leads farther to
 * the right: an uncertain one leads at most to the pixel after it. */
static inline void step_left(struct walkers *w, const struct polygon *p, int y, int *x0, int x1)
{
    int64_t most = INT64_MIN;

    for (unsigned i = 0; i < w->lefts; i++)
        most = w->left[i].at > most ? w->left[i].at : most;
    int64_t x = (most >> WALKER_BITS) + 1;
    if (w->lefts && !is_sure(most))
        clip_left(w, p, y, x0, x1);
    else if (x > *x0)
        *x0 = x < x1 ? (int)x : x1;
    for (unsigned i = 0; i < w->lefts; i++)
        w->left[i].at += w->left[i].step;
}

/* Clips the run at the right edges, then steps them. If the least position is certain, uncertain ones are greater, so
 * none leads farther to the left. */
static inline void step_right(struct walkers *w, const struct polygon *p, int y, int x0, int *x1)
{
    int64_t least = INT64_MAX;

    for (unsigned i = 0; i < w->rights; i++)
        least = w->right[i].at < least ? w->right[i].at : least;
    int64_t x = (least >> WALKER_BITS) + 1;
    if (w->rights && !is_sure(least))
        clip_right(w, p, y, x0, x1);
    else if (x < *x1)
        *x1 = x > x0 ? (int)x : x0;
    for (unsigned i = 0; i < w->rights; i++)
        w->right[i].at += w->right[i].step;
}

/* Reduces the run to the part on the inner side of the edge: the whole run, nothing, its left part or its right
 * part. */
static void bisect(const struct polygon *p, unsigned edge, int y, int *x0, int *x1)
{
    bool first = polygon_edge_covers(p, edge, *x0, y), last = polygon_edge_covers(p, edge, *x1 - 1, y);
    int low = *x0, high = *x1 - 1;

    if (first == last) {
        *x1 = first ? *x1 : *x0;
        return;
    }
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (polygon_edge_covers(p, edge, middle, y) == first)
            low = middle;
        else
            high = middle;
    }
    if (first)
        *x1 = high;
    else
        *x0 = high;
}

static void large_rows(const struct polygon *p, raster_run *run, void *ctx)
{
    struct walkers w;

    start(&w, p);
    for (int y = p->y0; y < p->y1; y++) {
        int x0 = p->x0, x1 = p->x1;
        step_left(&w, p, y, &x0, x1);
        step_right(&w, p, y, x0, &x1);
        for (unsigned i = 0; i < w.bisected && x0 < x1; i++)
            bisect(p, w.bisect[i], y, &x0, &x1);
        if (x0 < x1)
            run(ctx, y, x0, x1);
    }
}

/* True if the pixel is covered: no edge has its sign bit set. */
static inline bool is_covered(const int64_t e[], unsigned count)
{
    int64_t all = e[0] | e[1] | e[2];

    for (unsigned i = 3; i < count; i++)
        all |= e[i];
    return all >= 0;
}

static inline void step_edges(int64_t e[], const struct polygon *p)
{
    for (unsigned i = 0; i < p->count; i++)
        e[i] += p->of.narrow_forms.edge[i].x;
}

static void small_rows(const struct polygon *p, raster_run *run, void *ctx)
{
    int64_t e[POLYGON_EDGES];

    for (int y = p->y0; y < p->y1; y++) {
        int x0 = p->x0, x1;
        for (unsigned i = 0; i < p->count; i++)
            e[i] = narrow_form_at(&p->of.narrow_forms.edge[i], x0, y);
        for (; x0 < p->x1 && !is_covered(e, p->count); x0++)
            step_edges(e, p);
        for (x1 = x0; x1 < p->x1 && is_covered(e, p->count); x1++)
            step_edges(e, p);
        if (x0 < x1)
            run(ctx, y, x0, x1);
    }
}

void tia_polygon_rows(const struct polygon *p, raster_run *run, void *ctx)
{
    if (p->narrow && (int32_t)(p->x1 - p->x0) * (p->y1 - p->y0) <= SMALL_AREA)
        small_rows(p, run, ctx);
    else
        large_rows(p, run, ctx);
}
