/* row.h - where a run lies in its row, and the sphere that it sees: exact coefficients, in double precision. */
#ifndef TIA_LEVELS_ROW_H
#define TIA_LEVELS_ROW_H

#include "render/span/span.h"

#define LEVEL_NEVER 1e30 /* a bound for what cannot be bounded */

struct level_row {
    int y;
    double per_depth, per_depth2;  /* 1/depth, in units of pixel coordinates */
    num_wide y_coordinate, square; /* Y, and Y^2 + depth^2 */
};

void tia_level_row(const struct primary_rays *primary, int y, struct level_row *row);

/* The pixels first..end-1; x is counted from `middle`. */
struct level_place {
    int middle;
    double low, high, reach;            /* of x; the larger in size */
    double v0, v1, v2;                  /* v.v = v0 + v1 x + v2 x^2, at depth 1 */
    double square_most, v_most, v_step; /* v.v and |v| at most; |v'| */
    double square_least;
};

void tia_level_place(const struct primary_rays *primary, const struct level_row *row, int first, int end,
                     struct level_place *place);

/* a.v = c[0] + c[1] x. */
void tia_level_form(const struct primary_rays *primary, const struct level_row *row, const struct level_place *place,
                    struct num_vec a, double c[2]);

/* A sphere seen from outside, over a place. */
struct level_seen {
    double b[2], d[3], c;
    double size;            /* |d0| + |d1| X + |d2| X^2 */
    double b_least, b_most; /* of b */
    double least;           /* of D; it may be negative */
};

/* False when a run cannot be had: the eye is inside, or b is not positive. */
bool tia_level_see(const struct primary_rays *primary, const struct level_row *row, const struct level_place *place,
                   const struct span_sphere *sphere, struct level_seen *seen);

/* Between which distances the integer code sees the sphere all along the place, at its outline too. */
void tia_level_between(const struct primary_rays *primary, const struct level_row *row, const struct level_place *place,
                       const struct span_sphere *sphere, const struct level_seen *seen, double t[2]);

/* The same with the bounds that come with a cut: pixels where D is less are left out. */
struct level_depth {
    double cut, floor; /* of D; of sqrt(D) */
    double sum_least;  /* of S */
    double es, et;     /* relative bounds of 1/t: of the kernels', of the integer code's */
    double t_least, t_most;
    double p_least, p_most; /* |P| */
    double mantissa_most;   /* of the integer t */
};

/* `unit` is half an ulp of the arithmetic; `cut` a fraction of the size. */
void tia_level_depth(const struct primary_rays *primary, const struct level_row *row, const struct level_place *place,
                     const struct span_sphere *sphere, const struct level_seen *seen, double unit, double cut,
                     struct level_depth *depth);

/* 2^e, |e| < 1000. */
static inline double level_power(int e)
{
    union {
        uint64_t bits;
        double value;
    } power = {(uint64_t)(e + 1023) << 52};

    return power.value;
}

#endif
