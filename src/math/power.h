/* power.h - logarithms and powers in integers. */
#ifndef TIA_MATH_POWER_H
#define TIA_MATH_POWER_H

#include "integer.h"

/* 512/x, rounded, for x in the middle of [(64 + i)/128, (65 + i)/128); log2 of that, over 512, Q8.56. */
extern const uint16_t tia_log_inverses[64];
extern const int64_t tia_logs[64];

/* 2^(-i/64), and the coefficients of log2(1 + x) and 2^-x from x on, Q1.62. */
extern const int64_t tia_exps[64];
extern const int64_t tia_log_series[8], tia_exp_series[6];

/* Returns -log2 d, Q8.56, within 2^-56; 0 < d <= 1, Q1.62. */
int64_t tia_log2(int64_t d);

/* Returns whole times 2^-v with an error of at most 2^-56 of the result plus 2^-61; whole <= 1, Q1.62; v >= 0,
 * Q8.56. */
int64_t tia_exp2(int64_t whole, int64_t v);

/* Returns whole times d^(fraction/2^16), within 2^-55: d^e for num_power_q16.h, without roots; Q1.62, whole <= d < 1, 0
 * < d. */
int64_t tia_power_near(int64_t whole, int64_t d, uint32_t fraction);

#endif
