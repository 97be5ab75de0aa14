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

struct cells {
    int start; /* number of pixels of the run before the first cell */
    float x0;
    float per_s[SAMPLES], turn[SAMPLES], d[SAMPLES];                /* at samples: 1/S, |S'|, D */
    float lambert[SIMD_LIGHTS][SAMPLES], far[SIMD_LIGHTS][SAMPLES]; /* cosines, not clamped; |w| */
    float middle[SIMD_LIGHTS][SAMPLES]; /* per cell, like all members below: the cosine in its middle */
    float turn_of[SIMD_LIGHTS][SAMPLES], bend_of[SIMD_LIGHTS][SAMPLES]; /* factors of u and |u| in add_range() */
    float weight[SIMD_LIGHTS][3][SAMPLES]; /* the light's colour times the transmission of casters */
    float near31[SAMPLES], near63[SAMPLES];
    uint16_t pixel[SAMPLES]; /* colours of flat cells */
    uint64_t good, flat;
};

/* Computes samples. |S'|, with S' = b1 + D'/(2 sqrt(D)), is enlarged by the bounds of its two terms: b_off for b1;
 * d_off/sqrt(D), and SPAN_CELL_TURN of its size, for the other. */
INLINE void take_samples(const struct simd_run *r, const struct body *k, int count, int lights, struct cells *cells)
{
    for (int i = 0; i < count; i += N) {
        F x = f_fma(f_add(f_iota(), f_set((float)i)), f_set(SIMD_CELL), f_set(cells->x0));
        struct value o = value_at(k, x);
        F slope = f_fma(f_add(x, x), k->d2, k->d1), per_root = f_rsqrt(o.d);
        F part = f_mul(f_mul(slope, f_set(.5f)), per_root), turn = f_abs(f_add(part, k->b1)), per_s = f_inverse(o.s);
        F off =
            f_fma(f_abs(part), f_set((float)BOUND(SPAN_CELL_TURN)), f_fma(per_root, f_set(r->d_off), f_set(r->b_off)));
        off = BOUND_OF_FLOATS(SPAN_CELL_TURN_OFF, off);
        f_store(cells->per_s + i, per_s);
        f_store(cells->turn + i, f_add(turn, off));
        f_store(cells->d + i, o.d);
        for (int l = 0; l < lights; l++) {
            F square = square_of(&r->light[l], x, &o);
            f_store(cells->lambert[l] + i, lambert_of(&r->light[l], x, &o, square));
            F root = f_mul(square, f_rsqrt(square));
            f_store(cells->far[l] + i, f_mul(f_mul(root, per_s), f_set(r->c)));
        }
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

INLINE struct motion motion_over(const struct simd_run *r, const struct cells *cells, int i, M *good)
{
    F per_s = larger_end(cells->per_s + i), a = f_mul(larger_end(cells->turn + i), per_s);
    F d = f_sub(smaller_end(cells->d + i), f_set(r->d_sag)), per_root = f_rsqrt(d);
    F b = f_mul(f_mul(f_mul(per_root, per_root), f_mul(per_root, f_set(r->bend))), per_s);
    F t = f_mul(per_s, f_set(r->c * (float)BOUND(SPAN_CELL_MOTION))), v = f_set(r->v_most), step = f_set(r->v_step);
    F twice = f_add(a, a);

    *good = m_and(f_ge(d, f_set(r->cut)), f_gt(d, f_set(0)));
    return (struct motion){
        BOUND_OF_FLOATS(SPAN_CELL_FIRST, f_mul(t, f_fma(v, a, step))),
        BOUND_OF_FLOATS(SPAN_CELL_SECOND, f_mul(t, f_fma(v, f_fma(twice, a, b), f_mul(step, twice))))};
}

/* Decides if a caster shadows none (`lit`) or all (`dark`) of a cell, from the sample in the middle. P is at most p
 * away from this sample. */
INLINE struct verdict judge_cell(const struct simd_cast *c, F x, const struct value *o, F square, F p, F per_d, F far,
                                 float per_c2)
{
    const F two = f_set(2), unit = f_set(per_c2 * (float)BOUND(SPAN_EDGE_UNIT));
    struct toward t = toward_caster(c, x, o);
    F m = BOUND_OF_FLOATS(SPAN_EDGE_MOVE, f_mul(p, f_fma(per_d, f_set(c->turn), f_set(c->shift))));
    F e = f_fma(per_d, f_set(c->fuzz_a), f_set(c->fuzz_k));
    F near = BOUND_OF_FLOATS(SPAN_EDGE, f_fma(two, f_fma(m, f_add(m, f_set(c->radius)), e), e));
    F aside = BOUND_OF_FLOATS(SPAN_EDGE_ASIDE, f_mul(p, f_fma(far, f_set(3), f_add(p, f_set(c->size)))));

    aside = f_fma(BOUND_OF_FLOATS(SPAN_EDGE_FAR, f_mul(far, far)), f_set(c->ew), aside);
    return judge(c, &t, square, f_mul(near, unit), f_fma(aside, unit, f_set(c->ea)));
}

/* Per cell, sums over all lights: the interpolation errors in `lost`, and the ranges of the channels. `unlit`, for a
 * run that is `tied`, has the cells that no light reaches. */
struct gained {
    F lost, low[3], high[3];
    M unlit;
};

/* Adds the range of light l, and stores the two lines between its samples s, m and e, which meet in the middle: m + u
 * (e - s)/2 + |u| ((s - m) + (e - m))/2, u from -1 to 1. If a sample is NaN, the range is NaN. */
INLINE void add_range(struct cells *cells, int l, int i, F middle, const F tint[3], const struct simd_light *q,
                      int channels, struct gained *g)
{
    const F one = f_set(1), zero = f_set(0), step = f_set(.5f / HALF_CELL);
    F start = f_load(cells->lambert[l] + i), end = f_load(cells->lambert[l] + i + 1);
    F nothing = f_mul(zero, f_add(f_add(start, end), middle)); /* NaN if a sample is NaN */
    F low = f_max(zero, f_add(f_min(f_min(start, end), middle), nothing));
    F high = f_max(zero, f_add(f_max(f_max(start, end), middle), nothing));

    f_store(cells->middle[l] + i, middle);
    f_store(cells->turn_of[l] + i, f_mul(f_sub(end, start), step));
    f_store(cells->bend_of[l] + i, f_mul(f_add(f_sub(start, middle), f_sub(end, middle)), step));
    for (int c = 0; c < channels; c++) {
        F weight = f_mul(tint[c], f_set(q->colour[c]));
        f_store(cells->weight[l][c] + i, weight);
        g->low[c] = f_min(one, f_fma(low, weight, g->low[c]));
        g->high[c] = f_min(one, f_fma(high, weight, g->high[c]));
    }
}

/* Returns the cells where the light's colour is black. */
INLINE M no_weight(const struct cells *cells, int l, int i, int channels)
{
    F most = f_load(cells->weight[l][0] + i);

    for (int c = 1; c < channels; c++)
        most = f_max(most, f_load(cells->weight[l][c] + i));
    return f_ge(f_set(0), most);
}

/* Adds light l to the cells and to `gained`. Returns the cells that may be interpolated: the light is not too near, and
 * no shadow's edge crosses them. */
INLINE M light_cells(const struct simd_run *r, int l, F x, const struct value *o, const struct motion *p,
                     struct cells *cells, int i, struct gained *gained, int channels, int casts)
{
    const struct simd_light *q = &r->light[l];
    const F zero = f_set(0), half = f_mul(p->first, f_set(HALF_CELL)), square = square_of(q, x, o);
    F d = f_sub(f_mul(smaller_end(cells->far[l] + i), f_set(1 - (float)BOUND(SPAN_CELL_FAR))), half);
    F per_d = f_inverse(d), per_r = f_set(q->per_r);
    F bend = f_mul(p->second, f_add(per_r, per_d));
    F pull = f_mul(per_d, f_fma(f_set(2), per_r, f_mul(f_set((float)BOUND(SPAN_CELL_BEND)), per_d)));
    F off = BOUND_OF_FLOATS(SPAN_CELL_LINE, f_mul(f_fma(f_mul(p->first, p->first), pull, bend),
                                                  f_set(HALF_CELL * HALF_CELL / 8 * (float)BOUND(SPAN_CELL_OFF))));
    F tint[3] = {f_set(1), f_set(1), f_set(1)};
    M good = f_gt(d, f_mul(f_set((float)BOUND(SPAN_CELL_NEAR)), half));
    M away = f_gt(zero, f_add(f_add(larger_end(cells->lambert[l] + i), off), f_set(q->faint)));

    gained->lost = f_fma(BOUND_OF_FLOATS(SPAN_CELL_LOST, off), f_set(q->colour_most), gained->lost);
    if (casts) {
        F far = f_fma(larger_end(cells->far[l] + i), f_set(1 + (float)BOUND(SPAN_CELL_FAR)), half);
        struct shades shades = {f_gt(zero, zero), f_gt(zero, zero)};
        for (int j = 0; j < casts && m_any(m_not(m_or(away, shades.blocked))); j++) {
            struct verdict v = judge_cell(&q->cast[j], x, o, square, half, per_d, far, 1 / (r->c * r->c));
            shade_by(&q->cast[j], v, &shades);
            tint_by(&q->cast[j], v.dark, tint, channels);
        }
        good = m_and(good, m_or(away, is_decided(&shades)));
    }
    add_range(cells, l, i, lambert_of(q, x, o, square), tint, q, channels, gained);
    if (r->tied)
        gained->unlit = m_and(gained->unlit, m_or(away, no_weight(cells, l, i, channels)));
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
        F x = f_fma(f_add(f_iota(), f_set((float)i + .5f)), f_set(SIMD_CELL), f_set(cells->x0));
        struct value o = value_at(k, x);
        struct gained gained;
        M good;
        struct motion p = motion_over(r, cells, i, &good);
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
            F line = f_fma(at, f_set(cells->turn_of[l][cell]), f_set(cells->middle[l][cell]));
            F lambert = f_max(zero, f_fma(f_abs(at), f_set(cells->bend_of[l][cell]), line));
            for (int c = 0; c < (grey ? 1 : 3); c++)
                sum[c] = f_min(one, f_fma(lambert, f_set(cells->weight[l][c][cell]), sum[c]));
        }
        struct levels found = levels_of(sum, half[i / N & 1], near31, near63, grey);
        i_pack(found.red, found.green, found.blue, out + cell * SIMD_CELL + i);
        if (__builtin_expect(m_any(m_not(found.sure)), 0))
            n = note_open(found.sure, cells->start + cell * SIMD_CELL + i, N, list, n);
    }
    return n;
}

#endif
