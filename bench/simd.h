/* simd.h - compares the SIMD kernels with float loops without exactness. */
#ifndef BENCH_SIMD_H
#define BENCH_SIMD_H

void bench_simd(void);

#endif
