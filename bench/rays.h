/* rays.h - the ray renderer: sphere flakes of 10 to 7381 mirrors; and reading scene files. */
#ifndef BENCH_RAYS_H
#define BENCH_RAYS_H

void bench_rays(void);

#endif
