/* kernels.h - the innermost loops: each processes a span of at most CHUNK pixels of one row.
 *
 * A kernel's arguments are constants, prepared once per span, and arrays with one entry per pixel. Kernels are called
 * through a table; a table for vector units must give the same bits.
 */
#ifndef TIA_RENDER_SPAN_KERNELS_H
#define TIA_RENDER_SPAN_KERNELS_H

#include "primary.h"

#include "math/tile.h"

/* The largest number of pixels in a call of a kernel: 64, 32 or 16. Fewer take less stack and more time; the picture is
 * the same. */
#ifndef TIA_CHUNK
#define TIA_CHUNK 64
#endif
#if TIA_CHUNK != 64 && TIA_CHUNK != 32 && TIA_CHUNK != 16
#error "TIA_CHUNK must be 64, 32 or 16"
#endif
#define CHUNK TIA_CHUNK

/* A set of pixels of a call: bit i stands for pixel i. */
#if CHUNK > 32
typedef uint64_t pixel_set;
#else
typedef uint32_t pixel_set;
#endif
#define PIXEL_BIT(i) ((pixel_set)1 << (i))
#define PIXELS_ALL ((pixel_set)-1)

/* A span of pixels that see one sphere, for the kernels that compute t. */
struct sphere_line {
    num_wide b, b_step;       /* accumulator of L.v */
    struct row_square square; /* accumulator of v.v */
    num_u c_disc, c_top;
    int t_shift, behind_shift, count;
};

/* A light Q over a sphere L, seen along a row. With G = Q - L, c = L.L - r^2 and P = t v:
 *
 *     r N.(Q - P) = c - L.Q + t G.v            since |P|^2 = 2 L.P - c; from inside N and so all is negative
 *     |Q - P|^2   = Q.Q - 2 t Q.v + t^2 v.v
 *
 * The form of |Q - P|^2 does not use the sphere's equation. With that equation, on a large sphere, the last bit of t
 * would change the result; here that bit only moves P along the ray. */
struct light_line {
    num_wide g, g_step;       /* accumulator of G.v */
    num_wide q, q_step;       /* accumulator of Q.v */
    struct row_square square; /* accumulator of v.v */
    num_wide facing;          /* c - L.Q, with the exponent of t G.v */
    num_wide distance;        /* Q.Q, with the exponent of t Q.v, e_d */
    int reach_down;           /* t v.v / 2^reach_down is a mantissa; its product with t has the exponent e_p */
    int distance_down;        /* e_p - e_d */
    int scale;                /* facing * 2^(scale + half) is a mantissa */
    num_wide facing_doubt;    /* the bound of r N.(Q - P)'s error */
    int count;
};

/* The effect of one light on each pixel of a span. Where facing is 0, the rest is undefined. */
struct lit {
    num_u facing[CHUNK];    /* r N.(Q - P), times 2^half; 0: turned away or in shadow */
    num_wide reach[CHUNK];  /* |P|^2 */
    num_wide square[CHUNK]; /* |Q - P|^2 */
    num_u near[CHUNK];      /* |Q - P|^2 as a mantissa, times 4^half */
    num_u inverse[CHUNK];   /* 1/|Q - P|, times 2^-half */
    uint8_t half[CHUNK];
    uint8_t most_half; /* the largest half of all pixels that face the light */
    pixel_set open;    /* pixels in doubt: whether they face the light, or a sphere blocks it */
};

/* A sphere, centre C and radius R, that may stand between a light Q and the points P of a span of
 * the sphere L, r. With w = Q - P and A = C - P, seen from P as the eye sees a sphere:
 *
 *     A.w         = C.Q - t (C + Q).v + |P|^2
 *     |A|^2 - R^2 = C.C - R^2 - 2 t C.v + |P|^2.
 *
 * The shadow ray starts at P + bias N in the direction w, so A' = A - bias N takes A's place:
 *
 *     A'.w         = A.w - bias N.w
 *     |A'|^2 - R^2 = (|A|^2 - R^2)(1 + bias/r) - (|L - C|^2 - r^2 - R^2) bias/r + bias^2,
 *
 * the latter with 2 r N.A = |L - C|^2 - r^2 - |A|^2; from inside N is the opposite, and so is the sign of bias/r. The
 * ray goes towards the sphere when A'.w > 0, meets it when (A'.w)^2 >= |w|^2 (|A'|^2 - R^2), and before the light,
 * unless that is inside, when |w|^2 > A'.w. */
struct shadow_line {
    num_wide a, a_step;            /* accumulator of (C + Q).v */
    num_wide c, c_step;            /* accumulator of C.v */
    num_wide toward;               /* C.Q, with the exponent e_a of A.w */
    num_wide power;                /* C.C - R^2 and the bias's terms, with the exponent e_k */
    int a_down, power_down;        /* a_down: e_p - e_a; power_down: e_p - e_k; e_p is the exponent of |P|^2 */
    int square_down, product_down; /* e_d and e_a, each minus the smaller of the two */
    num_u inverse;                 /* num_inverse(r) */
    int bias_shift;                /* num_bias_product's shift minus `half` */
    num_u swell;                   /* 1 + bias/r, or 1 - bias/r from inside */
    int exponent;                  /* 2 e_a - e_d - e_k */
    bool enclosed;                 /* the light is inside the sphere */

    /* Bounds of errors: of A'.w, of (|A'|^2 - R^2)/(1 + bias/r), and of |w|^2 - A'.w as compared. */
    num_wide a_doubt, k_doubt, beyond_doubt;
    num_wide a_clear, k_clear; /* above these num_cover_order's margin of 14 includes all errors */
    int margin;                /* that of |w|^2 is 2^-margin of itself */
    int first, count;          /* pixels first..count - 1 are tried */
};

struct span_kernels {
    /* Computes t from outside the sphere: c / (b + sqrt(b^2 - c v.v)). */
    void (*sphere)(const struct sphere_line *line, num_u *t);
    /* Computes t from inside the sphere: (b + sqrt(b^2 + |c| v.v)) / v.v, or |c| / (|b| + sqrt(b^2 + |c| v.v)). */
    void (*sphere_inside)(const struct sphere_line *line, num_u *t);

    /* Fills `lit`; false when no pixel faces the light. */
    bool (*light)(const struct light_line *line, const num_u *t, struct lit *lit);

    /* Sets facing to 0 where the sphere blocks the light; where that is in doubt, sets the pixel's bit in `open`. */
    void (*shadow)(const struct shadow_line *line, const num_u *t, struct lit *lit);

    /* Computes lambert = max(0, N.w/|w|), where NUM_ONE is 1; `inverse` is num_inverse of the lit sphere's radius. */
    void (*lambert)(const struct lit *lit, num_u inverse, int count, num_u *lambert);

    /* Adds light: sum = min(1, sum + lambert * colour). */
    void (*add)(num_u *sum, const num_u *lambert, num_u colour, int count);

    /* Converts clamped linear colours to RGB565; `threshold` has the 8 rounding offsets of the row, by x & 7. Returns
     * the set of those whose level another channel within `doubt` of it may not have. */
    pixel_set (*pack)(const num_u *const rgb[3], num_u doubt, const num_u *threshold, int x, int count,
                      tia_rgb565 *out);
};

/* Returns |P|^2, from the accumulator of v.v. */
static inline num_wide light_reach(const struct light_line *line, num t, num_wide square)
{
    num reach = num_signed((num_u)num_down(num_mul(t, num_top(square)), line->reach_down));
    return num_mul(t, reach);
}

/* Returns |Q - P|^2, from |P|^2 and the accumulator of Q.v. */
static inline num_wide light_square(const struct light_line *line, num t, num_wide q, num_wide reach)
{
    return line->distance - 2 * num_mul(t, num_top(q)) + num_down(reach, line->distance_down);
}

/* Returns A.w, from t (C + Q).v and |P|^2. */
static inline num_wide shadow_toward(const struct shadow_line *line, num_wide product, num_wide reach)
{
    return line->toward - product + num_down(reach, line->a_down);
}

/* Returns bias N.w. */
static inline num_wide shadow_bias(const struct shadow_line *line, num_u facing, int half)
{
    return num_bias_product(facing, line->inverse, line->bias_shift + half);
}

/* Returns (|A'|^2 - R^2)/(1 + bias/r), from t C.v and |P|^2. */
static inline num_wide shadow_power(const struct shadow_line *line, num_wide turn, num_wide reach)
{
    return line->power - 2 * turn + num_down(reach, line->power_down);
}

/* The rounding offsets of a row's pixels, by x & 7, see dither.h; and, if surfaces may have the other byte order, one
 * number more, not 0 if the row's has. So the pixels are in the surface's order when they are first written. */
#define THRESHOLDS (8 + TIA_SWAP)

static INLINED void span_set_order(num_u threshold[THRESHOLDS], bool swap)
{
    if (TIA_SWAP)
        threshold[THRESHOLDS - 1] = swap;
}

static INLINED bool span_swaps(const num_u threshold[THRESHOLDS])
{
    return TIA_SWAP && threshold[THRESHOLDS - 1] > 0;
}

/* Returns a pixel in the order of the row's surface. */
static INLINED tia_rgb565 span_order(const num_u threshold[THRESHOLDS], tia_rgb565 pixel)
{
    return pixel_order(pixel, span_swaps(threshold));
}

static inline void span_fill(tia_rgb565 *pixels, int count, tia_rgb565 pixel)
{
    tia_rgb565 *const end = pixels + count;

    for (; end - pixels >= 8; pixels += 8) {
        pixels[0] = pixels[1] = pixels[2] = pixels[3] = pixel;
        pixels[4] = pixels[5] = pixels[6] = pixels[7] = pixel;
    }
    while (pixels < end)
        *pixels++ = pixel;
}

/* Returns the pixel of an exact colour. */
tia_rgb565 span_pixel(const num_u rgb[3], num_u threshold);

/* The plain kernel `sphere_inside`. */
void span_sphere_inside(const struct sphere_line *line, num_u *t);

extern const struct span_kernels span_kernels_plain;

#endif
