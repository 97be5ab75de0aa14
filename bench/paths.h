/* paths.h - measures light along random paths. */
#ifndef BENCH_PATHS_H
#define BENCH_PATHS_H

void bench_paths(void);

#endif
