/* levels.h - the levels of vector units beside float loops without exactness. */
#ifndef BENCH_LEVELS_H
#define BENCH_LEVELS_H

void bench_levels(void);

#endif
