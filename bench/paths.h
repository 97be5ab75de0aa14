/* paths.h - measures the path integrator. */
#ifndef BENCH_PATHS_H
#define BENCH_PATHS_H

void bench_paths(void);

#endif
