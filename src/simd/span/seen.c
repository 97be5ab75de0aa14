#include "seen.h"

#include <math.h>

#include "bounds.h"
#include "distance.h"
#include "simd/simd.h"

static struct span none_seen(void)
{
    return (struct span){0, 0};
}

/* Appends a run, or lengthens the last one. */
static void push(struct simd_line *line, int first, int end, uint32_t object)
{
    struct simd_span *spans = line->spans[line->which];

    if (first >= end)
        return;
    if (line->count > 0 && spans[line->count - 1].object == object)
        spans[line->count - 1].end = (uint16_t)end;
    else
        spans[line->count++] = (struct simd_span){(uint16_t)first, (uint16_t)end, object};
}

/* Two spheres that cover the same pixels: n, and m, which is already in the line. */
struct contest {
    const struct tia_view *view;
    const struct simd_row *row;
    uint32_t n, m;
    struct simd_place place;
    struct simd_seen seen[2];
    struct simd_depth depth[2];
};

/* True if n is nearer than m at pixel x, which both cover; in a tie m stays. */
static bool wins(const struct contest *c, int x)
{
    const struct span_view *spans = span_view_of(c->view);
    struct simd_distance n, m;

    if (simd_distance_at(&spans->primary, c->row, x, &spans->spheres[c->n], &n) &&
        simd_distance_at(&spans->primary, c->row, x, &spans->spheres[c->m], &m)) {
        double off = BOUND_OF(SPAN_WINS, (n.t * n.off + m.t * m.off) * (1 + BOUND(SPAN_WINS_SECOND)));
        if (fabs(n.t - m.t) > off)
            return n.t < m.t;
    }
    struct exact_picture picture = span_picture_of(c->view);
    return tia_exact_nearer(&picture, x, c->row->y, c->n, c->m);
}

static struct simd_body body_of(const struct simd_seen *seen, const struct simd_depth *depth)
{
    const double *b = seen->b, *d = seen->d;

    return (struct simd_body){(float)b[0], (float)b[1],       (float)d[0],         (float)d[1],
                              (float)d[2], (float)depth->cut, (float)(1 / seen->c)};
}

/* Returns the bound of the relative error of a sphere's 1/t, for a comparison. */
static float bound_of(const struct simd_depth *depth)
{
    return (float)BOUND_OF(SPAN_NEARER,
                           (depth->es + depth->et) * (1 + BOUND(SPAN_NEARER_SECOND)) + BOUND(SPAN_NEARER_ROUNDING));
}

/* Decides each of the pixels first..end-1, at most 64. */
static void settle(const struct contest *c, int first, int end, struct simd_line *line)
{
    struct simd_pair pair = {.count = end - first, .x0 = (float)(first - c->place.middle)};
    uint64_t win, open;

    for (int i = 0; i < 2; i++) {
        pair.body[i] = body_of(&c->seen[i], &c->depth[i]);
        pair.bound[i] = bound_of(&c->depth[i]);
    }
    c->view->simd->kernels->nearer(&pair, &win, &open);
    for (int i = 0; i < end - first; i++) {
        bool nearer = open >> i & 1 ? wins(c, first + i) : win >> i & 1;
        push(line, first + i, first + i + 1, nearer ? c->n : c->m);
    }
}

/* Prepares the part first..end-1; false when the eye is inside one of the spheres, or b is not positive. */
static bool look(struct contest *c, int first, int end)
{
    const struct span_view *spans = span_view_of(c->view);

    tia_simd_place(&spans->primary, c->row, first, end, &c->place);
    return tia_simd_see(&spans->primary, c->row, &c->place, &spans->spheres[c->n], &c->seen[0]) &&
           tia_simd_see(&spans->primary, c->row, &c->place, &spans->spheres[c->m], &c->seen[1]);
}

enum winner { NOBODY_KNOWS, N_WINS, M_WINS };

/* Compares the ranges of the spheres' distances over the whole part, which is usually enough. */
static enum winner before(const struct contest *c)
{
    const struct span_sphere *spheres = span_view_of(c->view)->spheres;
    double n[2], m[2];

    tia_simd_between(c->row, &spheres[c->n], &c->seen[0], n);
    tia_simd_between(c->row, &spheres[c->m], &c->seen[1], m);
    return n[1] < m[0] ? N_WINS : m[1] < n[0] ? M_WINS : NOBODY_KNOWS;
}

static bool deepen(struct contest *c)
{
    const struct span_view *spans = span_view_of(c->view);
    const uint32_t sphere[2] = {c->n, c->m};

    for (int i = 0; i < 2; i++)
        tia_simd_depth(c->row, &c->place, &spans->spheres[sphere[i]], &c->seen[i], SIMD_FLOAT, SIMD_FLOAT_CUT,
                       &c->depth[i]);
    return c->depth[0].es + c->depth[0].et < BOUND(SPAN_KNOWN) && c->depth[1].es + c->depth[1].et < BOUND(SPAN_KNOWN);
}

/* Decides pixels first..end-1 in parts. A part is halved until it can be decided as a whole or has at most 64
 * pixels. */
static void contend(struct contest *c, int first, int end, struct simd_line *line)
{
    int part = end - first;

    for (int at = first; at < end; at += part) {
        part = end - at < part ? end - at : part;
        bool good = look(c, at, at + part);
        enum winner winner = good ? before(c) : NOBODY_KNOWS;
        while (part > 64 && winner == NOBODY_KNOWS) {
            part = (part + 1) / 2;
            good = look(c, at, at + part);
            winner = good ? before(c) : NOBODY_KNOWS;
        }
        if (winner != NOBODY_KNOWS)
            push(line, at, at + part, winner == N_WINS ? c->n : c->m);
        else if (good && deepen(c))
            settle(c, at, at + part, line);
        else
            for (int x = at; x < at + part; x++)
                push(line, x, x + 1, wins(c, x) ? c->n : c->m);
    }
}

/* Merges object n, which covers `span`, into the runs of the line. */
static void merge(const struct tia_view *view, const struct simd_row *row, uint32_t n, struct span span,
                  struct simd_line *line)
{
    const struct simd_span *old = line->spans[line->which];
    int count = line->count;
    struct contest contest = {.view = view, .row = row, .n = n};

    line->which = !line->which;
    line->count = 0;
    for (int i = 0; i < count; i++) {
        struct span both = span_within(span, old[i].first, old[i].end);
        contest.m = old[i].object;
        if (both.first >= both.end) {
            push(line, old[i].first, old[i].end, old[i].object);
            continue;
        }
        push(line, old[i].first, both.first, old[i].object);
        if (old[i].object == TIA_NO_OBJECT)
            push(line, both.first, both.end, n);
        else
            contend(&contest, both.first, both.end, line);
        push(line, both.end, old[i].end, old[i].object);
    }
}

void tia_simd_find(const struct tia_view *view, const struct simd_row *row, struct tia_tile tile, struct span *guess,
                   struct simd_line *line)
{
    const struct span_view *spans = span_view_of(view);
    uint32_t objects = view->scene->sphere_count + view->light_count;

    line->which = 0;
    line->count = 0;
    push(line, (int)tile.x, tile_right(tile), TIA_NO_OBJECT);
    for (uint32_t n = 0; n < objects; n++) {
        const struct span_sphere *sphere = &spans->spheres[n];
        struct span *last = &guess[n < SIMD_GUESSES ? n : SIMD_GUESSES - 1];
        if (row->y < sphere->rows.first || row->y >= sphere->rows.end)
            continue;
        *last = span_sphere_row(view, n, row->y, n < SIMD_GUESSES ? *last : none_seen());
        struct span span = span_within(*last, (int)tile.x, tile_right(tile));
        if (span.first < span.end)
            merge(view, row, n, span, line);
    }
}
