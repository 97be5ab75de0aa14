/* total_tmpl.h - a run that is drawn light by light: the sums of its pixels so far.
 *
 * Parameters: what kernel_tmpl.h and cells_tmpl.h define. Defines: total_start(), total_add(), total_finish(), union
 * working.
 *
 * A light is judged in all cells first, caster by caster. It adds nothing to cells that it certainly does not reach,
 * two lines to cells that no shadow's edge comes near, and to other cells pixel by pixel, with the casters that are
 * undecided there. An undecided pixel has the sum NaN. */
#ifndef TIA_SIMD_SPAN_TOTAL_TMPL_H
#define TIA_SIMD_SPAN_TOTAL_TMPL_H

#include "cells_tmpl.h"

#define SHORT (4 * N) /* pixels of the longest run without cells */

struct total {
    struct simd_sums sums;
    struct samples at;
    float first[SAMPLES], second[SAMPLES]; /* per cell: upper limits of |P'| and |P''|; NaN: not known */
    float lost[SAMPLES];                   /* per cell: the errors of all lines so far */
    uint64_t unlit;                        /* cells that certainly no light reaches */
    struct lines lines;                    /* of the last light, like all members below */
    uint64_t known, none, line; /* cells: its casters are judged; it adds nothing to them; it adds two lines */
};

/* The working storage of all kernels. */
union working {
    struct cells cells;
    struct total total;
};

INLINE F undecided(void)
{
    return f_set(__builtin_nanf(""));
}

/* Returns the number of cells. The pixels after them count as another one, which is never known. A short run has no
 * cells, as these would take longer than its pixels. */
INLINE int cells_of(const struct simd_run *r)
{
    return r->count > SHORT ? (r->count - 1) / SIMD_CELL : 0;
}

static void total_start(const struct simd_run *r, struct simd_sums *sums)
{
    const struct body k = body_of(r);
    struct total *t = (struct total *)(void *)sums;
    int cells = cells_of(r);

    t->at.start = 0;
    t->at.x0 = r->x0;
    take_samples(r, &k, cells + 1, 0, &t->at, NULL);
    for (int i = 0; i < cells; i += N) {
        M good;
        struct motion p = motion_over(r, &t->at, i, &good);
        f_store(t->first + i, f_sel(good, p.first, undecided()));
        f_store(t->second + i, p.second);
        f_store(t->lost + i, f_set(0));
    }
    t->unlit = ((uint64_t)1 << cells) - 1;
    for (int i = 0; i < r->count; i += N) {
        struct value o = value_at(&k, f_add(f_iota(), f_set(r->x0 + (float)i)));
        f_store(t->sums.sum[0] + i, f_sel(o.good, f_set(r->emission[0]), undecided()));
        f_store(t->sums.sum[1] + i, f_set(r->emission[1]));
        f_store(t->sums.sum[2] + i, f_set(r->emission[2]));
    }
}

/* ---- a light ---- */

/* Judges the casters of a light in cells from i on. Returns the cells where they are decided, and multiplies `tint` by
 * the transmissions of those that shadow a cell. */
INLINE struct shades judge_casters(const struct simd_light *q, F x, const struct value *o, const struct over *w,
                                   float per_c2, struct total *t, int i, F tint[3], int channels)
{
    const F zero = f_set(0);
    struct shades shades = {f_gt(zero, zero), f_gt(zero, zero)};

    for (int j = 0; j < q->casts && m_any(m_not(m_or(w->away, shades.blocked))); j++) {
        struct verdict v = judge_cell(&q->cast[j], x, o, w, per_c2);
        t->sums.open[j] |= (uint64_t)m_bits(m_and(w->good, m_not(m_or(v.lit, v.dark)))) << i;
        shade_by(&q->cast[j], v, &shades);
        tint_by(&q->cast[j], v.dark, tint, channels);
    }
    return shades;
}

/* Judges a light in cells from i on, and stores its lines. */
INLINE void judge_light(const struct simd_run *r, const struct body *k, struct total *t, int i, int channels)
{
    const struct simd_light *q = &r->light[0];
    const F faint = f_set((float)BOUND(SPAN_TOTAL_FAINT));
    F x = sample_places(&t->at, (float)i + .5f), lost = f_load(t->lost + i);
    F tint[3] = {f_set(1), f_set(1), f_set(1)};
    struct motion p = {f_load(t->first + i), f_load(t->second + i)};
    struct value o = value_at(k, x);
    struct over w = light_over(q, x, &o, &p, &t->lines, i);
    struct shades shades = judge_casters(q, x, &o, &w, 1 / (r->c * r->c), t, i, tint, channels);
    F more = f_fma(BOUND_OF_FLOATS(SPAN_CELL_LOST, w.off), f_set(q->colour_most), lost);

    store_lines(&t->lines, i, lambert_of(q, x, &o, w.square), tint, q->colour, channels);
    M none = m_and(w.good, m_or(w.away, no_weight(&t->lines, i, channels)));
    M line = m_and(m_and(w.good, m_not(none)), m_and(is_decided(&shades), f_ge(faint, f_mul(more, f_set(63)))));
    t->known |= (uint64_t)m_bits(w.good) << i;
    t->none |= (uint64_t)m_bits(none) << i;
    t->line |= (uint64_t)m_bits(line) << i;
    f_store(t->lost + i, f_sel(line, more, lost));
}

/* Adds a light's two lines to a cell. */
INLINE void add_lines(struct total *t, int cell, int channels)
{
    const F one = f_set(1), zero = f_set(0);

    for (int i = 0; i < SIMD_CELL; i += N) {
        F at = f_add(f_iota(), f_set((float)(i - HALF_CELL)));
        F line = f_fma(at, f_set(t->lines.turn_of[cell]), f_set(t->lines.middle[cell]));
        F lambert = f_max(zero, f_fma(f_abs(at), f_set(t->lines.bend_of[cell]), line));
        for (int c = 0; c < channels; c++) {
            float *sum = t->sums.sum[c] + cell * SIMD_CELL + i;
            f_store(sum, f_min(one, f_fma(lambert, f_set(t->lines.weight[c][cell]), f_load(sum))));
        }
    }
}

/* Casters of a light by their numbers. */
struct some_casts {
    int count;
    uint8_t number[SIMD_CASTS];
};

/* Notes the casters that are undecided at undecided pixels of a cell. */
INLINE void note_casters(const struct simd_light *q, F x, const struct value *o, M sure, const struct some_casts *some,
                         int cell, struct simd_sums *sums)
{
    F square = square_of(q, x, o), zero = f_set(0);

    for (int j = 0; j < some->count; j++) {
        const struct simd_cast *cast = &q->cast[some->number[j]];
        struct toward t = toward_caster(cast, x, o);
        struct verdict v = judge(cast, &t, square, zero, zero);
        bool open = m_any(m_not(m_or(sure, m_or(v.lit, v.dark))));
        sums->open[some->number[j]] |= (uint64_t)open << cell;
    }
}

/* Adds a light to pixels first..end-1, with some casters. Returns the list's new length, which was `n`. */
INLINE int add_pixels(const struct simd_run *r, const struct body *k, struct simd_sums *sums, int first, int end,
                      const float colour[3], const struct some_casts *some, int channels, uint16_t *list, int n)
{
    const struct simd_light *q = &r->light[0];

    for (int i = first; i < end; i += N) {
        F x = f_add(f_iota(), f_set(r->x0 + (float)i)), sum[3];
        struct value o = value_at(k, x);
        for (int c = 0; c < channels; c++)
            sum[c] = f_load(sums->sum[c] + i);
        M sure = add_light_by(q, x, &o, colour, some->number, some->count, sum, channels);
        if (__builtin_expect(m_any(m_not(sure)), 0)) {
            for (int c = 0; c < channels; c++)
                sum[c] = f_sel(sure, sum[c], f_load(sums->sum[c] + i));
            note_casters(q, x, &o, sure, some, i / SIMD_CELL, sums);
            n = note_open(m_or(sure, m_not(o.good)), i, end - i, list, n);
        }
        for (int c = 0; c < channels; c++)
            f_store(sums->sum[c] + i, sum[c]);
    }
    return n;
}

/* Adds a light to a cell, or to the pixels after the last cell, pixel by pixel. Returns the list's new length, which
 * was `n`. */
INLINE int add_cell(const struct simd_run *r, const struct body *k, struct total *t, int cell, int channels,
                    uint16_t *list, int n)
{
    const struct simd_light *q = &r->light[0];
    int first = cell * SIMD_CELL, end = cell < cells_of(r) ? first + SIMD_CELL : r->count;
    bool known = t->known >> cell & 1;
    struct some_casts some;
    float colour[3];

    for (int c = 0; c < channels; c++)
        colour[c] = known ? t->lines.weight[c][cell] : q->colour[c];
    some.count = 0;
    for (int j = 0; j < q->casts; j++) {
        some.number[some.count] = (uint8_t)j;
        some.count += !known || (t->sums.open[j] >> cell & 1);
        t->sums.open[j] &= ~((uint64_t)1 << cell);
    }
    return add_pixels(r, k, &t->sums, first, end, colour, &some, channels, list, n);
}

INLINE int add_to(const struct simd_run *r, struct total *t, int channels, uint16_t *list)
{
    const struct body k = body_of(r);
    int cells = cells_of(r), n = 0;
    uint64_t whole = ((uint64_t)1 << cells) - 1;

    t->known = t->none = t->line = 0;
    for (int j = 0; j < r->light[0].casts; j++)
        t->sums.open[j] = 0;
    for (int i = 0; i <= cells && cells; i += N) {
        F x = sample_places(&t->at, (float)i);
        struct value o = value_at(&k, x);
        sample_light(r, &r->light[0], x, &o, f_load(t->at.per_s + i), i, &t->lines);
    }
    for (int i = 0; i < cells; i += N)
        judge_light(r, &k, t, i, channels);
    t->known &= whole;
    t->none &= whole;
    t->line &= whole;
    t->unlit &= t->none;
    for (uint64_t left = t->line; left; left &= left - 1)
        add_lines(t, __builtin_ctzll(left), channels);
    for (uint64_t left = ~(t->line | t->none) & (2 * whole + 1); left; left &= left - 1)
        n = add_cell(r, &k, t, __builtin_ctzll(left), channels, list, n);
    return n;
}

static int total_add(const struct simd_run *r, struct simd_sums *sums, uint16_t *list)
{
    struct total *t = (struct total *)(void *)sums;

    return r->grey ? add_to(r, t, 1, list) : add_to(r, t, 3, list);
}

/* ---- the pixels ---- */

/* Draws pixels of a cell, or after the last one. Returns the list's new length, which was `n`. */
INLINE int finish_cell(const struct simd_run *r, const struct total *t, int cell, bool grey, uint16_t *out,
                       uint16_t *list, int n)
{
    bool whole = cell < cells_of(r);
    F lost = f_set(whole ? t->lost[cell] : 0);
    int end = whole ? (cell + 1) * SIMD_CELL : r->count;
    F near31 = f_fma(lost, f_set(-31), f_set(r->near31)), near63 = f_fma(lost, f_set(-63), f_set(r->near63));

    for (int i = cell * SIMD_CELL; i < end; i += N) {
        F sum[3] = {f_load(t->sums.sum[0] + i), f_load(t->sums.sum[1] + i), f_load(t->sums.sum[2] + i)};
        struct levels found = levels_of(sum, f_load(r->threshold + (i & 7)), near31, near63, grey);
        uint16_t pixel[N];
        i_pack(found.red, found.green, found.blue, pixel);
        for (int j = 0; j < N && j < r->count - i; j++)
            out[i + j] = pixel[j];
        if (__builtin_expect(m_any(m_not(found.sure)), 0))
            n = note_open(found.sure, i, r->count - i, list, n);
    }
    return n;
}

static int total_finish(const struct simd_run *r, struct simd_sums *sums, uint16_t *out, uint16_t *list)
{
    const struct total *t = (const struct total *)(const void *)sums;
    uint64_t unlit = r->tied && r->threshold[0] == r->threshold[1] ? t->unlit : 0; /* not dithered */
    int n = 0, cells = cells_of(r);

    for (int cell = 0; cell <= cells; cell++)
        if (unlit >> cell & 1)
            for (int i = 0; i < SIMD_CELL; i++)
                out[cell * SIMD_CELL + i] = r->unlit;
        else
            n = r->grey ? finish_cell(r, t, cell, true, out, list, n) : finish_cell(r, t, cell, false, out, list, n);
    return n;
}

#endif
