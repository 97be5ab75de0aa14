/* rays.h - measures the ray renderer with sphere flakes of 10 to 7381 mirrors, and the reading of scene files. */
#ifndef BENCH_RAYS_H
#define BENCH_RAYS_H

void bench_rays(void);

#endif
