/* power.h - logarithms and powers in integers. */
#ifndef TIA_SAMPLING_POWER_H
#define TIA_SAMPLING_POWER_H

#include <tia/fixed.h>

/* -log2 x of 0 < x <= 1, Q1.62, with 56 bits behind the point: 0 up to 62 2^56, within 2^-55. */
int64_t tia_log2(int64_t x);

/* 2^-y of y >= 0 with 56 bits behind the point: Q1.62, within 2^-55 of itself and 2^-62. */
int64_t tia_exp2(int64_t y);

#endif
