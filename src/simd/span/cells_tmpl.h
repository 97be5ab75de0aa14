/* cells_tmpl.h - the cells of the span kernels: 16 pixels, with samples at both ends and in the middle.
 *
 * Parameters: value_at() and the functions that kernel_tmpl.h defines before it includes this file. Defines:
 * take_samples(), judge_cells(), draw_flat(), draw_cell(), struct cells. */
#ifndef TIA_SIMD_SPAN_CELLS_TMPL_H
#define TIA_SIMD_SPAN_CELLS_TMPL_H

#include "bound_table.h"

#define CELLS (SIMD_BLOCK / SIMD_CELL)
#define SAMPLES (CELLS + 2 * N)
#define HALF_CELL (SIMD_CELL / 2)

/* The samples of cells. */
struct samples {
    int start; /* number of pixels of the run before the first cell */
    float x0;
    float per_s[SAMPLES], turn[SAMPLES], d[SAMPLES]; /* 1/S, |S'|, D */
};

/* A light in the cells. */
struct lines {
    float lambert[SAMPLES], far[SAMPLES];     /* at samples: the cosine, not clamped; |w| */
    float middle[SAMPLES];                    /* per cell, like all members below: the cosine in its middle */
    float turn_of[SAMPLES], bend_of[SAMPLES]; /* factors of u and |u| in store_lines() */
    float weight[3][SAMPLES];                 /* the light's colour times the transmission of casters */
};

struct cells {
    struct samples at;
    struct lines light[SIMD_LIGHTS];
    float near31[SAMPLES], near63[SAMPLES]; /* per cell */
    uint16_t pixel[SAMPLES];                /* colours of flat cells */
    uint64_t good, flat;
};

/* Returns the places of N samples, from number i on; those in the middle of cells are at i + 1/2. */
INLINE F sample_places(const struct samples *at, float i)
{
    return f_fma(f_add(f_iota(), f_set(i)), f_set(SIMD_CELL), f_set(at->x0));
}

/* Computes a light's samples from number i on. */
INLINE void sample_light(const struct simd_run *r, const struct simd_light *q, F x, const struct value *o, F per_s,
                         int i, struct lines *lines)
{
    F square = square_of(q, x, o), root = f_mul(square, f_rsqrt(square));

    f_store(lines->lambert + i, lambert_of(q, x, o, square));
    f_store(lines->far + i, f_mul(f_mul(root, per_s), f_set(r->c)));
}

/* Computes samples. |S'|, with S' = b1 + D'/(2 sqrt(D)), is enlarged by the bounds of its two terms: b_off for b1;
 * d_off/sqrt(D), and SPAN_CELL_TURN of its size, for the other. */
INLINE void take_samples(const struct simd_run *r, const struct body *k, int count, int lights, struct samples *at,
                         struct lines *lines)
{
    for (int i = 0; i < count; i += N) {
        F x = sample_places(at, (float)i);
        struct value o = value_at(k, x);
        F slope = f_fma(f_add(x, x), k->d2, k->d1), per_root = f_rsqrt(o.d);
        F part = f_mul(f_mul(slope, f_set(.5f)), per_root), turn = f_abs(f_add(part, k->b1)), per_s = f_inverse(o.s);
        F off =
            f_fma(f_abs(part), f_set((float)BOUND(SPAN_CELL_TURN)), f_fma(per_root, f_set(r->d_off), f_set(r->b_off)));
        off = BOUND_OF_FLOATS(SPAN_CELL_TURN_OFF, off);
        f_store(at->per_s + i, per_s);
        f_store(at->turn + i, f_add(turn, off));
        f_store(at->d + i, o.d);
        for (int l = 0; l < lights; l++)
            sample_light(r, &r->light[l], x, &o, per_s, i, &lines[l]);
    }
}

INLINE F larger_end(const float *samples)
{
    return f_max(f_load(samples), f_load(samples + 1));
}

INLINE F smaller_end(const float *samples)
{
    return f_min(f_load(samples), f_load(samples + 1));
}

/* Upper limits of |P'| and |P''| over a cell. */
struct motion {
    F first, second;
};

INLINE struct motion motion_over(const struct simd_run *r, const struct samples *at, int i, M *good)
{
    F per_s = larger_end(at->per_s + i), a = f_mul(larger_end(at->turn + i), per_s);
    F d = f_sub(smaller_end(at->d + i), f_set(r->d_sag)), per_root = f_rsqrt(d);
    F b = f_mul(f_mul(f_mul(per_root, per_root), f_mul(per_root, f_set(r->bend))), per_s);
    F t = f_mul(per_s, f_set(r->c * (float)BOUND(SPAN_CELL_MOTION))), v = f_set(r->v_most), step = f_set(r->v_step);
    F twice = f_add(a, a);

    *good = m_and(f_ge(d, f_set(r->cut)), f_gt(d, f_set(0)));
    return (struct motion){
        BOUND_OF_FLOATS(SPAN_CELL_FIRST, f_mul(t, f_fma(v, a, step))),
        BOUND_OF_FLOATS(SPAN_CELL_SECOND, f_mul(t, f_fma(v, f_fma(twice, a, b), f_mul(step, twice))))};
}

/* Per cell, sums over all lights: the interpolation errors in `lost`, and the ranges of the channels. `unlit`, for a
 * run that is `tied`, has the cells that no light reaches. */
struct gained {
    F lost, low[3], high[3];
    M unlit;
};

/* Stores the two lines between a light's samples s, m and e, which meet in the middle: m + u (e - s)/2 + |u| ((s - m) +
 * (e - m))/2, u from -1 to 1; and the light's colour times `tint`. */
INLINE void store_lines(struct lines *lines, int i, F middle, const F tint[3], const float colour[3], int channels)
{
    const F step = f_set(.5f / HALF_CELL);
    F start = f_load(lines->lambert + i), end = f_load(lines->lambert + i + 1);

    f_store(lines->middle + i, middle);
    f_store(lines->turn_of + i, f_mul(f_sub(end, start), step));
    f_store(lines->bend_of + i, f_mul(f_add(f_sub(start, middle), f_sub(end, middle)), step));
    for (int c = 0; c < channels; c++)
        f_store(lines->weight[c] + i, f_mul(tint[c], f_set(colour[c])));
}

/* Adds the range of a light whose lines are stored. If a sample is NaN, the range is NaN. */
INLINE void add_range(const struct lines *lines, int i, int channels, struct gained *g)
{
    const F one = f_set(1), zero = f_set(0);
    F start = f_load(lines->lambert + i), end = f_load(lines->lambert + i + 1), middle = f_load(lines->middle + i);
    F nothing = f_mul(zero, f_add(f_add(start, end), middle)); /* NaN if a sample is NaN */
    F low = f_max(zero, f_add(f_min(f_min(start, end), middle), nothing));
    F high = f_max(zero, f_add(f_max(f_max(start, end), middle), nothing));

    for (int c = 0; c < channels; c++) {
        F weight = f_load(lines->weight[c] + i);
        g->low[c] = f_min(one, f_fma(low, weight, g->low[c]));
        g->high[c] = f_min(one, f_fma(high, weight, g->high[c]));
    }
}

/* Returns the cells where the light's colour is black. */
INLINE M no_weight(const struct lines *lines, int i, int channels)
{
    F most = f_load(lines->weight[0] + i);

    for (int c = 1; c < channels; c++)
        most = f_max(most, f_load(lines->weight[c] + i));
    return f_ge(f_set(0), most);
}

/* A light over cells: |w|^2 s^2 in their middle, half of the path of P, the inverse of the least |w|, an upper limit of
 * |w|, and the bound of a line's error. */
struct over {
    F square, half, per_d, far, off;
    M good, away; /* the light is not too near; no pixel faces it */
};

INLINE struct over light_over(const struct simd_light *q, F x, const struct value *o, const struct motion *p,
                              const struct lines *lines, int i)
{
    struct over w = {.square = square_of(q, x, o), .half = f_mul(p->first, f_set(HALF_CELL))};
    F d = f_sub(f_mul(smaller_end(lines->far + i), f_set(1 - (float)BOUND(SPAN_CELL_FAR))), w.half);
    F per_r = f_set(q->per_r);

    w.per_d = f_inverse(d);
    F bend = f_mul(p->second, f_add(per_r, w.per_d));
    F pull = f_mul(w.per_d, f_fma(f_set(2), per_r, f_mul(f_set((float)BOUND(SPAN_CELL_BEND)), w.per_d)));
    w.off = BOUND_OF_FLOATS(SPAN_CELL_LINE, f_mul(f_fma(f_mul(p->first, p->first), pull, bend),
                                                  f_set(HALF_CELL * HALF_CELL / 8 * (float)BOUND(SPAN_CELL_OFF))));
    w.far = f_fma(larger_end(lines->far + i), f_set(1 + (float)BOUND(SPAN_CELL_FAR)), w.half);
    w.good = f_gt(d, f_mul(f_set((float)BOUND(SPAN_CELL_NEAR)), w.half));
    w.away = f_gt(f_set(0), f_add(f_add(larger_end(lines->lambert + i), w.off), f_set(q->faint)));
    return w;
}

/* Decides if a caster shadows none (`lit`) or all (`dark`) of a cell, from the sample in the middle. P is at most
 * w->half away from this sample. */
INLINE struct verdict judge_cell(const struct simd_cast *c, F x, const struct value *o, const struct over *w,
                                 float per_c2)
{
    const F two = f_set(2), unit = f_set(per_c2 * (float)BOUND(SPAN_EDGE_UNIT)), p = w->half;
    struct toward t = toward_caster(c, x, o);
    F m = BOUND_OF_FLOATS(SPAN_EDGE_MOVE, f_mul(p, f_fma(w->per_d, f_set(c->turn), f_set(c->shift))));
    F e = f_fma(w->per_d, f_set(c->fuzz_a), f_set(c->fuzz_k));
    F near = BOUND_OF_FLOATS(SPAN_EDGE, f_fma(two, f_fma(m, f_add(m, f_set(c->radius)), e), e));
    F aside = BOUND_OF_FLOATS(SPAN_EDGE_ASIDE, f_mul(p, f_fma(w->far, f_set(3), f_add(p, f_set(c->size)))));

    aside = f_fma(BOUND_OF_FLOATS(SPAN_EDGE_FAR, f_mul(w->far, w->far)), f_set(c->ew), aside);
    return judge(c, &t, w->square, f_mul(near, unit), f_fma(aside, unit, f_set(c->ea)));
}

/* Adds light l to the cells and to `gained`. Returns the cells that may be interpolated: the light is not too near, and
 * no shadow's edge crosses them. */
INLINE M light_cells(const struct simd_run *r, int l, F x, const struct value *o, const struct motion *p,
                     struct cells *cells, int i, struct gained *gained, int channels, int casts)
{
    const struct simd_light *q = &r->light[l];
    struct lines *lines = &cells->light[l];
    struct over w = light_over(q, x, o, p, lines, i);
    const F zero = f_set(0);
    F tint[3] = {f_set(1), f_set(1), f_set(1)};
    M good = w.good;

    gained->lost = f_fma(BOUND_OF_FLOATS(SPAN_CELL_LOST, w.off), f_set(q->colour_most), gained->lost);
    if (casts) {
        struct shades shades = {f_gt(zero, zero), f_gt(zero, zero)};
        for (int j = 0; j < casts && m_any(m_not(m_or(w.away, shades.blocked))); j++) {
            struct verdict v = judge_cell(&q->cast[j], x, o, &w, 1 / (r->c * r->c));
            shade_by(&q->cast[j], v, &shades);
            tint_by(&q->cast[j], v.dark, tint, channels);
        }
        good = m_and(good, m_or(w.away, is_decided(&shades)));
    }
    store_lines(lines, i, lambert_of(q, x, o, w.square), tint, q->colour, channels);
    add_range(lines, i, channels, gained);
    if (r->tied)
        gained->unlit = m_and(gained->unlit, m_or(w.away, no_weight(lines, i, channels)));
    return good;
}

/* Returns the flat cells, and stores their colours. All pixels of a flat cell have one colour, to which both ends of
 * the cell's range round. */
INLINE M flat_cells(const struct simd_run *r, const struct gained *g, F near31, F near63, bool grey,
                    struct cells *cells, int i)
{
    const F half = f_set(r->threshold[0]);
    struct levels low = levels_of(g->low, half, near31, near63, grey);
    struct levels high = levels_of(g->high, half, near31, near63, grey);
    M same = m_and(m_and(low.sure, high.sure), m_and(f_ge(low.red, high.red), f_ge(low.green, high.green)));

    if (!grey)
        same = m_and(same, f_ge(low.blue, high.blue));
    i_pack(low.red, low.green, low.blue, cells->pixel + i);
    return same;
}

/* Makes cells from i on flat, with the pixel of no light: those whose bit is set. */
INLINE void set_unlit(const struct simd_run *r, unsigned bits, struct cells *cells, int i)
{
    cells->flat |= (uint64_t)bits << i;
    for (; bits; bits &= bits - 1)
        cells->pixel[i + __builtin_ctz(bits)] = r->unlit;
}

INLINE void judge_cells(const struct simd_run *r, const struct body *k, int count, bool grey, int lights, int casts,
                        struct cells *cells)
{
    bool plain = r->threshold[0] == r->threshold[1]; /* not dithered */

    cells->good = cells->flat = 0;
    for (int i = 0; i < count; i += N) {
        F x = sample_places(&cells->at, (float)i + .5f);
        struct value o = value_at(k, x);
        struct gained gained;
        M good;
        struct motion p = motion_over(r, &cells->at, i, &good);
        gained.lost = f_set(0);
        gained.unlit = good;
        for (int c = 0; c < (grey ? 1 : 3); c++)
            gained.low[c] = gained.high[c] = f_set(r->emission[c]);
        for (int l = 0; l < lights; l++)
            good = m_and(good, light_cells(r, l, x, &o, &p, cells, i, &gained, grey ? 1 : 3,
                                           casts < 2 ? casts : r->light[l].casts));
        F lost63 = f_mul(gained.lost, f_set(63)), near63 = f_sub(f_set(r->near63), lost63);
        F near31 = f_fma(gained.lost, f_set(-31), f_set(r->near31));
        good = m_and(good, f_ge(f_set((float)BOUND(SPAN_CELL_FAINT)), lost63));
        f_store(cells->near63 + i, near63);
        f_store(cells->near31 + i, near31);
        cells->good |= (uint64_t)m_bits(good) << i;
        if (plain)
            cells->flat |= (uint64_t)m_bits(m_and(good, flat_cells(r, &gained, near31, near63, grey, cells, i))) << i;
        if (plain && r->tied)
            set_unlit(r, m_bits(m_and(good, gained.unlit)), cells, i);
    }
    cells->good &= ((uint64_t)1 << count) - 1;
    cells->flat &= cells->good;
}

INLINE void draw_flat(const struct cells *cells, uint16_t *out)
{
    for (uint64_t left = cells->flat; left; left &= left - 1) {
        int cell = __builtin_ctzll(left);
        uint16_t pixel = cells->pixel[cell], *at = out + cell * SIMD_CELL;
        for (int i = 0; i < SIMD_CELL; i++)
            at[i] = pixel;
    }
}

/* Draws one cell by interpolation. Returns the list's new length, which was `n`. */
INLINE int draw_cell(const struct simd_run *r, const struct cells *cells, int cell, bool grey, int lights,
                     const F half[2], uint16_t *out, uint16_t *list, int n)
{
    const F one = f_set(1), zero = f_set(0);
    F near31 = f_set(cells->near31[cell]), near63 = f_set(cells->near63[cell]);

    for (int i = 0; i < SIMD_CELL; i += N) {
        F sum[3] = {f_set(r->emission[0]), f_set(r->emission[1]), f_set(r->emission[2])};
        F at = f_add(f_iota(), f_set((float)(i - HALF_CELL)));
        for (int l = 0; l < lights; l++) {
            F line = f_fma(at, f_set(cells->light[l].turn_of[cell]), f_set(cells->light[l].middle[cell]));
            F lambert = f_max(zero, f_fma(f_abs(at), f_set(cells->light[l].bend_of[cell]), line));
            for (int c = 0; c < (grey ? 1 : 3); c++)
                sum[c] = f_min(one, f_fma(lambert, f_set(cells->light[l].weight[c][cell]), sum[c]));
        }
        struct levels found = levels_of(sum, half[i / N & 1], near31, near63, grey);
        i_pack(found.red, found.green, found.blue, out + cell * SIMD_CELL + i);
        if (may_list(found.sure))
            n = note_open(found.sure, cells->at.start + cell * SIMD_CELL + i, N, list, n);
    }
    return n;
}

#endif
