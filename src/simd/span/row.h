/* row.h - a run's place in its row, and the sphere that its pixels see: coefficients of the exact forms, in double
 * precision. */
#ifndef TIA_SIMD_SPAN_ROW_H
#define TIA_SIMD_SPAN_ROW_H

#include "sums.h"

#define SIMD_NEVER 1e30   /* the bound of a value that cannot be bounded */
#define SIMD_BIAS 0x1p-13 /* distance from a sphere at which shadow rays start */

/* Sets row y, and what all rows of a picture have in common. */
void tia_simd_row(const struct span_view *spans, int y, struct simd_row *row);

/* Moves a row to row y of the same picture. */
static inline void simd_row_to(const struct primary_rays *primary, int y, struct simd_row *row)
{
    row->y = y;
    row->y_coordinate = primary_y(primary, y);
    row->square = row->y_coordinate * row->y_coordinate + primary->depth * primary->depth;
}

/* The pixels first..end-1; x is counted from `middle`. */
struct simd_place {
    int middle;
    double low, high, reach;            /* range of x, and the largest |x| */
    double v0, v1, v2;                  /* v.v = v0 + v1 x + v2 x^2, at depth 1 */
    double square_most, v_most, v_step; /* upper limits of v.v and |v|; |v'| */
    double square_least;
};

void tia_simd_place(const struct primary_rays *primary, const struct simd_row *row, int first, int end,
                    struct simd_place *place);

/* Gives the coefficients of a.v = c[0] + c[1] x. */
void tia_simd_form(const struct primary_rays *primary, const struct simd_row *row, const struct simd_place *place,
                   struct num_vec a, double c[2]);

/* A sphere seen from outside by the pixels of a place: b = b[0] + b[1] x, D = d[0] + d[1] x + d[2] x^2, and c. */
struct simd_seen {
    double b[2], d[3], c;
    double size;            /* |d0| + |d1| X + |d2| X^2 */
    double b_least, b_most; /* range of b */
    double least;           /* least D, which may be negative */
};

/* Gives a sphere's coefficients over a place; false when no run can be drawn: the eye is inside the sphere, or b is not
 * positive everywhere. */
bool tia_simd_see(const struct primary_rays *primary, const struct simd_row *row, const struct simd_place *place,
                  const struct span_sphere *sphere, struct simd_seen *seen);

/* Gives a range that contains the sphere's distances t at all pixels of the place, even at the sphere's outline. */
void tia_simd_between(const struct simd_row *row, const struct span_sphere *sphere, const struct simd_seen *seen,
                      double t[2]);

/* Depths and their bounds for a cut: pixels whose D is below the cut are left undecided. */
struct simd_depth {
    double cut, floor; /* lower limits of D and of sqrt(D) */
    double sum_least;  /* lower limit of S */
    double es, et;     /* bounds of the relative errors of 1/t in the kernels, and of P by the error of K */
    double t_least, t_most;
    double p_least, p_most; /* range of |P| */
};

/* Gives depths; `unit` is the rounding unit u of the arithmetic, `cut` a share of D's size. */
void tia_simd_depth(const struct simd_row *row, const struct simd_place *place, const struct span_sphere *sphere,
                    const struct simd_seen *seen, double unit, double cut, struct simd_depth *depth);

/* Returns 2^e, |e| < 1000. */
static inline double simd_power(int e)
{
    union {
        uint64_t bits;
        double value;
    } power = {(uint64_t)(e + 1023) << 52};

    return power.value;
}

#endif
