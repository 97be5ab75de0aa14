/* ray_levels.h - general rays by each level of vector units, beside plain C and double precision. */
#ifndef BENCH_RAY_LEVELS_H
#define BENCH_RAY_LEVELS_H

/* NULL, or only scenes whose name contains it are measured. */
extern const char *bench_scene;

void bench_ray_levels(void);

#endif
