/* crowds.h - crowds of spheres by spans and by rays. */
#ifndef BENCH_CROWDS_H
#define BENCH_CROWDS_H

/* Prints milliseconds per frame of 640x480 with the best vector units, one thread, and their ratio. */
void bench_crowds(void);

#endif
