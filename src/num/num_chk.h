/* num_chk.h - q16 with range checks: reports each intermediate value out of range, with the file and line of the call.
 * Numbers and pixels are the same as in q16.
 *
 * The program that links this build defines tia_chk_report. Sums and differences use C's operators; for them
 * the Makefile turns on the compiler's own overflow checks. */
#ifndef TIA_NUM_NUM_CHK_H
#define TIA_NUM_NUM_CHK_H

#define NUM_NAME "chk"
#define NUM_PREFIX tia_chk_
#define NUM_CORE tia_core_chk
#define NUM_ESTIMATOR tia_estimator_chk

void tia_chk_report(const char *file, int line, const char *range);

/* The call being checked. Each source file has its own variable in each thread. */
static _Thread_local struct num_site {
    const char *file;
    int line;
} num_site;

static inline void num_at(const char *file, int line)
{
    num_site.file = file;
    num_site.line = line;
}

#define NUM_CHECK(condition) ((condition) ? (void)0 : tia_chk_report(num_site.file, num_site.line, #condition))

#include "num_q16.h"

#define NUM_AT num_at(__FILE__, __LINE__)
#define num_pixel_coordinate(n, e) (NUM_AT, num_pixel_coordinate(n, e))
#define num_depth(h, c, e) (NUM_AT, num_depth(h, c, e))
#define num_colour_product(a, b) (NUM_AT, num_colour_product(a, b))
#define num_signed(t) (NUM_AT, num_signed(t))
#define num_shift(x, s) (NUM_AT, num_shift(x, s))
#define num_down(x, s) (NUM_AT, num_down(x, s))
#define num_top_u(x) (NUM_AT, num_top_u(x))
#define num_quotient(a, b, s) (NUM_AT, num_quotient(a, b, s))
#define num_normal(x) (NUM_AT, num_normal(x))
#define num_inverse(r) (NUM_AT, num_inverse(r))
#define num_cone(b, c, q, d) (NUM_AT, num_cone(b, c, q, d))
#define num_product_above(a, b, c, d) (NUM_AT, num_product_above(a, b, c, d))
#define num_scale(x, s) (NUM_AT, num_scale(x, s))
#define num_scale_within(x, s) (NUM_AT, num_scale_within(x, s))
#define num_cover_order(a, n, h, k, s, e, m) (NUM_AT, num_cover_order(a, n, h, k, s, e, m))
#define num_lambert(s, i) (NUM_AT, num_lambert(s, i))
#define num_swell(i, b, n) (NUM_AT, num_swell(i, b, n))
#define num_bias_product(f, i, s) (NUM_AT, num_bias_product(f, i, s))
#define num_bias_of(x, i, b, e) (NUM_AT, num_bias_of(x, i, b, e))
#define num_light_doubt(p, l, t) (NUM_AT, num_light_doubt(p, l, t))
#define num_quantise(c, l, t) (NUM_AT, num_quantise(c, l, t))
#define num_square(x) (NUM_AT, num_square(x))
#define num_sum_of_squares30(x, y, z) (NUM_AT, num_sum_of_squares30(x, y, z))

#endif
