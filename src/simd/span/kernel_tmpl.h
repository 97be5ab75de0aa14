/* kernel_tmpl.h - the template of the span kernels, included once by the file of each instruction set.
 *
 * Parameters: the floats of isa/isa.h. Defines: `kernels`, a struct simd_kernels (run.h).
 *
 * A run is drawn in cells of 16 pixels. Everything is computed at a cell's ends and in its middle. In between, r N.w/(r
 * |w|) is interpolated where its second derivative is small enough and no shadow's edge comes near. A cell of a single
 * colour is filled. Pixels of interpolated cells that are too near a boundary between two levels, and the pixels of all
 * other cells, are computed one by one; undecided pixels are appended to `list`.
 *
 * The constants are broadcast into locals first, since for the compiler they may be aliased by `out`. */
#ifndef TIA_SIMD_SPAN_KERNEL_TMPL_H
#define TIA_SIMD_SPAN_KERNEL_TMPL_H

#include "bound_table.h"
#include "run.h"

#define INLINE static inline __attribute__((always_inline))

struct body {
    F b0, b1, d0, d1, d2, cut, v0, v1, v2;
};

/* Values at a pixel or a sample: D, S and v.v; `good` where D is not below the cut. */
struct value {
    F d, s, vv;
    M good;
};

INLINE F form1(F x, float c0, float c1)
{
    return f_fma(x, f_set(c1), f_set(c0));
}

INLINE struct body body_of(const struct simd_run *r)
{
    return (struct body){f_set(r->b0),  f_set(r->b1), f_set(r->d0), f_set(r->d1), f_set(r->d2),
                         f_set(r->cut), f_set(r->v0), f_set(r->v1), f_set(r->v2)};
}

INLINE struct value value_at(const struct body *k, F x)
{
    struct value o;

    o.d = f_fma(x, f_fma(x, k->d2, k->d1), k->d0);
    o.vv = f_fma(x, f_fma(x, k->v2, k->v1), k->v0);
    o.good = f_ge(o.d, k->cut);
    o.s = f_add_root(f_fma(x, k->b1, k->b0), o.d);
    return o;
}

INLINE F square_of(const struct simd_light *q, F x, const struct value *o)
{
    return f_fma(o->s, f_fma(o->s, f_set(q->qq), form1(x, q->q0, q->q1)), o->vv);
}

INLINE F lambert_of(const struct simd_light *q, F x, const struct value *o, F square)
{
    F facing = f_fma(o->s, f_set(q->k), form1(x, q->g0, q->g1));

    return f_over_root(f_mul(facing, f_set(q->per_r)), square);
}

/* The forms A'.w s^2 and k s^2, and S^2. */
struct toward {
    F a, k, s2;
};

INLINE struct toward toward_caster(const struct simd_cast *c, F x, const struct value *o)
{
    F s2 = f_mul(o->s, o->s);
    F a = f_fma(o->s, f_fma(o->s, f_set(c->aq), form1(x, c->h0, c->h1)), o->vv);
    F k = f_fma(o->s, f_fma(o->s, f_set(c->p0), form1(x, c->c0, c->c1)), o->vv);

    return (struct toward){a, k, s2};
}

struct verdict {
    M lit, dark;
};

/* Decides a shadow. `near` and `aside`, for s^2 in units of S^2, are added to the margins of k and of A'.w. */
INLINE struct verdict judge(const struct simd_cast *c, const struct toward *t, F w, F near, F aside)
{
    F a2 = f_mul(t->a, t->a), zero = f_set(0), size = f_abs(t->a);
    F ea = f_mul(t->s2, f_set(c->ea));
    F bound = f_fma(ea, f_add(f_add(size, size), ea), f_mul(a2, f_set(c->ew)));
    bound = BOUND_OF_FLOATS(SPAN_VERDICT,
                            f_fma(f_mul(w, f_mul(t->s2, f_set(c->swell * (float)(1 + BOUND(SPAN_RUN_SWELL))))),
                                  f_add(f_set(c->ek), near), bound));
    F delta = f_fnma(f_mul(w, t->k), f_set(c->swell), a2), low = f_sub(zero, bound);
    F ew = f_mul(w, f_set(c->ew)), off = f_fma(t->s2, aside, ea), past = f_fnma(w, f_set(c->ends), t->a);
    F clear = BOUND_OF_FLOATS(SPAN_BEHIND, off), beyond = BOUND_OF_FLOATS(SPAN_BEYOND, f_add(off, ew));
    struct verdict v = {m_or(m_or(f_gt(low, delta), f_gt(f_sub(zero, clear), t->a)), f_gt(past, beyond)),
                        m_and(m_and(f_gt(delta, bound), f_gt(t->a, clear)), f_gt(f_sub(zero, beyond), past))};

    return v;
}

/* ---- colours: the distance of each channel from a boundary between levels ---- */

struct levels {
    F red, green, blue;
    M sure;
};

INLINE struct levels levels_of(const F sum[3], F half, F near31, F near63, bool grey)
{
    F y31 = f_fma(sum[0], f_set(31), half), y63 = f_fma(sum[grey ? 0 : 1], f_set(63), half);
    struct levels o = {f_round(y31), f_round(y63), f_round(y31), f_ge(near31, near31)};

    o.sure = m_and(f_ge(near31, f_abs(f_sub(y31, o.red))), f_ge(near63, f_abs(f_sub(y63, o.green))));
    if (!grey) {
        F blue = f_fma(sum[2], f_set(31), half);
        o.blue = f_round(blue);
        o.sure = m_and(o.sure, f_ge(near31, f_abs(f_sub(blue, o.blue))));
    }
    return o;
}

/* ---- pixels one by one ---- */

INLINE void tint_by(const struct simd_cast *c, M dark, F tint[3], int channels)
{
    for (int i = 0; i < channels; i++)
        tint[i] = f_sel(dark, f_mul(tint[i], f_set(c->clear ? c->through[i] : 0)), tint[i]);
}

/* What casters do to a light: where an opaque one certainly blocks it (`blocked`), it does not matter whether others do
 * (`open`: it is undecided whether some one does). */
struct shades {
    M blocked, open;
};

INLINE void shade_by(const struct simd_cast *c, struct verdict v, struct shades *shades)
{
    shades->open = m_or(shades->open, m_not(m_or(v.lit, v.dark)));
    if (!c->clear)
        shades->blocked = m_or(shades->blocked, v.dark);
}

INLINE M is_decided(const struct shades *shades)
{
    return m_or(shades->blocked, m_not(shades->open));
}

/* Adds a light with the given colour to the sums. The casters are the first `casts` of it, or those whose `casts`
 * numbers are in `which`. Returns the pixels where all is decided. */
INLINE M add_light_by(const struct simd_light *q, F x, const struct value *o, const float colour[3],
                      const uint8_t *which, int casts, F sum[3], int channels)
{
    const F one = f_set(1), zero = f_set(0);
    F square = square_of(q, x, o), lambert = f_min(one, f_max(zero, lambert_of(q, x, o, square)));
    M facing = f_gt(lambert, zero), good = f_ge(lambert, zero), none = f_gt(zero, zero); /* false where it is NaN */
    F tint[3] = {one, one, one};
    struct shades shades = {none, none};

    for (int j = 0; j < casts && m_any(m_and(facing, m_not(shades.blocked))); j++) {
        const struct simd_cast *cast = &q->cast[which ? which[j] : j];
        struct toward t = toward_caster(cast, x, o);
        struct verdict v = judge(cast, &t, square, zero, zero);
        shade_by(cast, v, &shades);
        tint_by(cast, v.dark, tint, channels);
    }
    if (casts)
        good = m_and(good, m_or(m_not(facing), is_decided(&shades)));
    for (int c = 0; c < channels; c++)
        sum[c] = f_min(one, f_fma(casts ? f_mul(lambert, tint[c]) : lambert, f_set(colour[c]), sum[c]));
    return good;
}

INLINE M add_light(const struct simd_light *q, F x, const struct value *o, F sum[3], int channels, int casts)
{
    return add_light_by(q, x, o, q->colour, NULL, casts, sum, channels);
}

INLINE struct levels levels_at(const struct simd_run *r, const struct body *k, F x, F half, bool grey, int lights,
                               int casts)
{
    struct value o = value_at(k, x);
    F sum[3] = {f_set(r->emission[0]), f_set(r->emission[1]), f_set(r->emission[2])};

    for (int l = 0; l < lights; l++)
        o.good =
            m_and(o.good, add_light(&r->light[l], x, &o, sum, grey ? 1 : 3, casts < 2 ? casts : r->light[l].casts));
    struct levels found = levels_of(sum, half, f_set(r->near31), f_set(r->near63), grey);
    found.sure = m_and(found.sure, o.good);
    return found;
}

/* True if pixels of an interpolated cell may have to be listed. Many such cells have one, so that a test does not pay
 * where listing takes no branch. */
INLINE bool may_list(M sure)
{
#ifdef NOTE_OPEN
    (void)sure;
    return true;
#else
    return m_any(m_not(sure));
#endif
}

#ifndef NOTE_OPEN /* an instruction set may have a faster one */
INLINE int note_open(M sure, int at, int count, uint16_t *list, int n)
{
    unsigned bits = m_bits(m_not(sure));

    if (count < N)
        bits &= (1u << count) - 1;
    for (; bits; bits &= bits - 1)
        list[n++] = (uint16_t)(at + __builtin_ctz(bits));
    return n;
}
#endif

/* Draws pixels first..end-1. Returns the list's new length, which was `n`. */
INLINE int draw_pixels(const struct simd_run *r, const struct body *k, int first, int end, bool grey, int lights,
                       int casts, uint16_t *out, uint16_t *list, int n)
{
    for (int i = first; i < end; i += N) {
        F x = f_add(f_iota(), f_set(r->x0 + (float)i)), half = f_load(r->threshold + (i & 7));
        struct levels found = levels_at(r, k, x, half, grey, lights, casts);
        uint16_t pixel[N];
        if (end - i >= N) {
            i_pack(found.red, found.green, found.blue, out + i);
        } else {
            i_pack(found.red, found.green, found.blue, pixel);
            for (int j = 0; j < end - i; j++)
                out[i + j] = pixel[j];
        }
        if (__builtin_expect(m_any(m_not(found.sure)), 0))
            n = note_open(found.sure, i, end - i, list, n);
    }
    return n;
}

/* Draws the listed pixels, which may be anywhere in the run. Keeps undecided pixels in the list, and returns their
 * number. */
INLINE int draw_listed(const struct simd_run *r, const struct body *k, bool grey, int lights, int casts, uint16_t *out,
                       uint16_t *list, int count)
{
    bool dithered = r->threshold[0] != r->threshold[1];
    F half = f_set(r->threshold[0]);
    int n = 0;

    for (int j = 0; count && j < N; j++)
        list[count + j] = list[0];
    for (int i = 0; i < count; i += N) {
        int left = count - i < N ? count - i : N;
        float threshold[N];
        uint16_t pixel[N];
        for (int j = 0; dithered && j < N; j++)
            threshold[j] = r->threshold[list[i + j] & 7];
        if (dithered)
            half = f_load(threshold);
        F x = f_add(f_whole(list + i), f_set(r->x0));
        struct levels found = levels_at(r, k, x, half, grey, lights, casts);
        unsigned open = m_bits(m_not(found.sure));
        i_pack(found.red, found.green, found.blue, pixel);
        for (int j = 0; j < left; j++) {
            uint16_t place = list[i + j];
            out[place] = pixel[j];
            list[n] = place;
            n += (int)(open >> j & 1);
        }
    }
    return n;
}

/* ---- a run ---- */

#include "cells_tmpl.h"

/* Draws pixels start..start + size - 1, at most SIMD_BLOCK. Returns the list's new length, which was `open`. */
INLINE int draw_block(const struct simd_run *r, const struct body *k, int start, int size, bool grey, int lights,
                      int casts, uint16_t *out, uint16_t *list, int open, struct cells *restrict cells)
{
    const F half[2] = {f_load(r->threshold), f_load(r->threshold + (N & 7))};
    int count = (size - 1) / SIMD_CELL, n = open;

    cells->at.start = start;
    cells->at.x0 = r->x0 + (float)start;
    take_samples(r, k, count + 1, lights, &cells->at, cells->light);
    judge_cells(r, k, count, grey, lights, casts, cells);
    draw_flat(cells, out + start);
    for (uint64_t left = cells->good & ~cells->flat; left; left &= left - 1)
        n = draw_cell(r, cells, __builtin_ctzll(left), grey, lights, half, out + start, list, n);
    n = open + draw_listed(r, k, grey, lights, casts, out, list + open, n - open);
    for (int cell = 0; cell <= count;) { /* the last iteration draws the rest, which has no cell */
        int first = __builtin_ctzll(~cells->good >> cell << cell);
        uint64_t next = cells->good >> first << first;
        cell = next ? __builtin_ctzll(next) : count + 1;
        int end = next ? cell * SIMD_CELL : size;
        n = draw_pixels(r, k, start + first * SIMD_CELL, start + end, grey, lights, casts, out, list, n);
    }
    return n;
}

INLINE int draw_run(const struct simd_run *r, uint16_t *out, uint16_t *list, struct cells *restrict cells, bool grey,
                    int lights, int casts)
{
    const struct body k = body_of(r);
    int n = 0;

    for (int start = 0; start < r->count; start += SIMD_BLOCK) {
        int size = r->count - start < SIMD_BLOCK ? r->count - start : SIMD_BLOCK;
        n = draw_block(r, &k, start, size, grey, lights, casts, out, list, n, cells);
    }
    return n;
}

/* Grey runs with one light and at most one caster are the most frequent, and have specialised code. */
static int shade(const struct simd_run *r, uint16_t *out, uint16_t *list, void *cells)
{
    if (r->grey && r->lights == 1 && r->light[0].casts <= 1)
        return r->light[0].casts ? draw_run(r, out, list, cells, true, 1, 1)
                                 : draw_run(r, out, list, cells, true, 1, 0);
    return draw_run(r, out, list, cells, r->grey, r->lights, 2);
}

#include "total_tmpl.h"

/* ---- the nearer of two spheres ---- */

INLINE F per_t(const struct simd_body *b, F x, M *good)
{
    F d = f_fma(x, f_fma(x, f_set(b->d2), f_set(b->d1)), f_set(b->d0));

    *good = m_and(*good, f_ge(d, f_set(b->cut)));
    return f_mul(f_add_root(form1(x, b->b0, b->b1), d), f_set(b->per_c));
}

static void nearer(const struct simd_pair *pair, uint64_t *nearer, uint64_t *open)
{
    *nearer = *open = 0;
    for (int i = 0; i < pair->count; i += N) {
        F x = f_add(f_iota(), f_set(pair->x0 + (float)i));
        M good = f_ge(x, x);
        F s = per_t(&pair->body[0], x, &good), t = per_t(&pair->body[1], x, &good);
        F bound = f_fma(s, f_set(pair->bound[0]), f_mul(t, f_set(pair->bound[1]))), past = f_sub(s, t);
        M win = f_gt(past, bound), lose = f_gt(f_sub(f_set(0), bound), past);
        *nearer |= (uint64_t)m_bits(win) << i;
        *open |= (uint64_t)m_bits(m_not(m_and(good, m_or(win, lose)))) << i;
    }
    if (pair->count < 64)
        *open &= ((uint64_t)1 << pair->count) - 1;
}

/* Compilers make stores of vectors from copies of a constant size, from loops over pixels often none. */
static void fill(uint16_t *out, int count, const uint16_t pixels[8])
{
    const uint16_t *const end = out + count;
    uint16_t own[8];

    __builtin_memcpy(own, pixels, sizeof own);
    for (; end - out >= 32; out += 32)
        for (int i = 0; i < 32; i += 8)
            __builtin_memcpy(out + i, own, sizeof own);
    for (; end - out >= 8; out += 8)
        __builtin_memcpy(out, own, sizeof own);
    for (int i = 0; out < end; i++)
        *out++ = own[i];
}

#ifndef STREAM /* an instruction set may define it */
#define STREAM NULL, NULL
#endif

static const struct simd_kernels kernels = {
    shade, sizeof(union working), total_start, total_add, total_finish, nearer, fill, STREAM};

#endif
