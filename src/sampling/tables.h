/* tables.h - constants of power.c, written by tools/generate/sampling.py. */
#ifndef TIA_SAMPLING_TABLES_H
#define TIA_SAMPLING_TABLES_H

#include <stdint.h>

extern const uint32_t tia_inverses[64];  /* of the middles of 64 intervals of 1..2, Q1.31 */
extern const int64_t tia_logarithms[64]; /* their -log2, Q3.60 */
extern const int64_t tia_powers[64];     /* 2^(-i/64), Q1.62 */

#endif
