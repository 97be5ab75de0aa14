/* run.h - a run, the pixels of one row that see one sphere: the input of the vector kernels.
 *
 * Everything is a function of x, in pixels from the run's middle, with directions v scaled to depth 1. Then for a
 * sphere L, r with c = L.L - r^2, seen from outside,
 *
 *     S = c/t = b + sqrt(D),   b = L.v linear, D = b^2 - c v.v quadratic in x
 *
 * and the quantities of lighting at the point P = t v, multiplied by s = 1/t or its square, need no division:
 *
 *     r N.w  s   = K s + G.v                 with w = Q - P, K = c - L.Q, G = Q - L
 *     |w|^2  s^2 = Q.Q s^2 - 2 Q.v s + v.v
 *     A'.w   s^2 = (C.Q - B K) s^2 - ((C + Q).v + B G.v) s + v.v      with B = bias/r
 *     k      s^2 = (C.C - R^2 - apart bias/(r + bias)) s^2 - 2 C.v s + v.v
 *
 * with apart = |L - C|^2 - r^2 - R^2 - bias r. A sphere C, R stands between P and the light where A'.w > 0, (A'.w)^2 >=
 * |w|^2 k (1 + B) and, unless the light is in the sphere, A'.w < |w|^2. This is the rule of docs/definition.md, which
 * has A for A' = C - P - bias N, as
 *
 *     |A'|^2 - R^2 = k (1 + B)               since 2 r N.(C - P) = |L - C|^2 - r^2 - |C - P|^2
 *
 * The structs here have the coefficients of forms in S = c s.
 *
 * Every value has a bound on its difference from the exact value, see bounds.h. Undecided pixels are listed by their
 * index in the run. */
#ifndef TIA_SIMD_SPAN_RUN_H
#define TIA_SIMD_SPAN_RUN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define SIMD_LIGHTS 8      /* of a run that is drawn with all its lights at once */
#define SIMD_CASTS_FEW 3   /* of each light of such a run */
#define SIMD_CASTS_KEPT 24 /* of a light and a sphere, for a frame */
#define SIMD_CASTS 256     /* of a run: all lights of such a run, or one light, whose casters may be all spheres */
#define SIMD_RUN 2048      /* largest number of pixels in a run */
#define SIMD_BLOCK 1024    /* largest number of pixels that a kernel draws at once */
#define SIMD_MORE 32       /* entries beyond a list, or beyond thresholds, that kernels may access */
#define SIMD_CELL 16       /* pixels of a cell */

/* A sphere that may occlude the light of a run. */
struct simd_cast {
    float aq, h0, h1;  /* A'.w s^2 = aq S^2 + (h0 + h1 x) S + v.v */
    float p0, c0, c1;  /* k s^2 in the same way */
    float swell;       /* 1 + B */
    float ends;        /* the shadow ray's length in units of |w|: 1, or far more where the light is in the sphere */
    float ea, ek, ew;  /* error bounds: of A'.w and k, for s^2 in units of S^2; of |w|^2, relative */
    int clear;         /* true if the sphere transmits light */
    float through[3];  /* then its transmission */
    float radius;      /* R */
    float turn, shift; /* turn/|w| + shift: largest change of the shadow ray's distance from C, per unit that P moves */
    float size;        /* upper limit of |A'| */
    float fuzz_a;      /* 2 size times A'.w's bound, to be divided by |w| */
    float fuzz_k;      /* k's bound plus size^2 times |w|^2's */
};

struct simd_light {
    float k, g0, g1;   /* r N.w s = k S + g0 + g1 x */
    float qq, q0, q1;  /* |w|^2 s^2 */
    float per_r;       /* 1/r */
    float colour[3];   /* the product of both colours and of the shades' transmissions, see pair.h */
    float colour_most; /* the largest component of `colour` */
    float faint;       /* bound of lambert's error */
    int casts;
    const struct simd_cast *cast;
};

struct simd_run {
    int count;
    bool grey; /* all channels are equal to the first */
    int lights;
    float x0;                      /* x of the first pixel */
    float b0, b1, d0, d1, d2, cut; /* pixels whose D is below cut are undecided */
    float c;                       /* c of the sphere: t = c/S */
    float v0, v1, v2;
    float v_step, v_most; /* upper limits of |v'| and |v| */
    float bend;           /* |4 d0 d2 - d1^2|/4, so that S'' = -bend/D^1.5 */
    float d_sag;          /* largest amount by which D is below both neighbouring samples */
    float b_off, d_off;   /* error of |S'|: b_off + d_off/sqrt(D), plus 2^-CELL_TURN of D'/(2 sqrt(D)) */
    float emission[3];
    float near31, near63;   /* half a level less the error bound */
    bool tied;              /* a channel without light is too near a boundary between two levels for floats */
    uint16_t unlit;         /* if `tied`, the exact pixel without light, for the first threshold */
    const float *threshold; /* less 1/2, from the run's first pixel on; repeats after 8 */
    struct simd_light light[SIMD_LIGHTS];
    struct simd_cast cast[SIMD_CASTS]; /* of the lights, one light after the other */
};

/* One of two spheres that cover the same pixels. */
struct simd_body {
    float b0, b1, d0, d1, d2, cut, per_c;
};

struct simd_pair {
    int count; /* at most 64 */
    float x0;
    struct simd_body body[2];
    float bound[2]; /* bounds of the relative errors of 1/t */
};

/* The colours of a run's pixels with the lights so far. */
struct simd_sums {
    float sum[3][SIMD_BLOCK + SIMD_MORE]; /* the first is NaN where a pixel is undecided */
    uint64_t open[SIMD_CASTS];            /* for each caster of the last light the cells with pixels where both are
                                             undecided, a bit for SIMD_CELL pixels */
};

struct simd_kernels {
    /* Draws the pixels that can be decided. Lists the undecided ones, whose places in `out` it may overwrite, and
     * returns their number. The list has room for all pixels and SIMD_MORE entries. `cells` points to working storage,
     * whose size is in the member `cells`. */
    int (*shade)(const struct simd_run *run, uint16_t *out, uint16_t *list, void *cells);
    size_t cells;

    /* Draws a run of at most SIMD_BLOCK pixels light by light: `start`, then `add` with each light as the run's only
     * one, then `finish`, which alone needs near31, near63, tied and unlit. All three have the same `sums`, which are
     * the beginning of the working storage. `add` lists the pixels where its light is undecided, and leaves their sums
     * as they are; `finish` lists the undecided pixels. Both return their number. */
    void (*start)(const struct simd_run *run, struct simd_sums *sums);
    int (*add)(const struct simd_run *run, struct simd_sums *sums, uint16_t *list);
    int (*finish)(const struct simd_run *run, struct simd_sums *sums, uint16_t *out, uint16_t *list);

    /* nearer: bit i is set if body 0 is nearer at pixel i; open: bit i is set if that is undecided. */
    void (*nearer)(const struct simd_pair *pair, uint64_t *nearer, uint64_t *open);

    /* Repeats eight pixels. */
    void (*fill)(uint16_t *out, int count, const uint16_t pixels[8]);

    /* Copies pixels past the caches, for pictures that do not fit into them. NULL without such an instruction. */
    void (*stream)(uint16_t *out, const uint16_t *from, int count);

    /* Makes streamed pixels visible before all later stores. NULL if `stream` is NULL. */
    void (*settle)(void);
};

#endif
