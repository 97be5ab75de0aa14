/* power.h - logarithms and powers in integers. */
#ifndef TIA_MATH_POWER_H
#define TIA_MATH_POWER_H

#include "integer.h"

/* 512/x, rounded, where x is the middle of [(64 + i)/128, (65 + i)/128). */
extern const uint16_t tia_log_inverses[64];
/* log2(tia_log_inverses[i]/512), Q8.56. */
extern const int64_t tia_logs[64];

/* 2^(-i/64), Q1.62. */
extern const int64_t tia_exps[64];
/* Coefficients of the power series of log2(1 + x) and of 2^-x, beginning with that of x, Q1.62. */
extern const int64_t tia_log_series[8], tia_exp_series[6];

/* Returns -log2 d, Q8.56, within 2^-56; 0 < d <= 1, Q1.62. */
int64_t tia_log2(int64_t d);

/* Returns whole 2^-v, Q1.62, with a relative error of at most 2^-56, plus 2^-61; whole <= 1, Q1.62; v >= 0, Q8.56. */
int64_t tia_exp2(int64_t whole, int64_t v);

/* Returns whole d^(fraction/2^16) within 2^-55, Q1.62; 0 < d < 1, whole <= d. num_power_q16.h uses it for d^e without
 * roots. */
int64_t tia_power_near(int64_t whole, int64_t d, uint32_t fraction);

#endif
