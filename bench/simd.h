/* simd.h - compares the levels of vector units with float loops without exactness. */
#ifndef BENCH_SIMD_H
#define BENCH_SIMD_H

void bench_simd(void);

#endif
