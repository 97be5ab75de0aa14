/* rays.h - general rays: sphere flakes of 10 to 7381 mirrors, and how long scene files take to read. */
#ifndef BENCH_RAYS_H
#define BENCH_RAYS_H

void bench_rays(void);

#endif
