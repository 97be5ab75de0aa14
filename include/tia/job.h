/* job.h - long work: the threads that share it, and a function that can stop it. */
#ifndef TIA_JOB_H
#define TIA_JOB_H

#include <tia/fixed.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A pool of threads. Without one tia runs jobs one after the other. All functions must be set. */
struct tia_workers {
    /* Runs job(arg, 0) .. job(arg, count - 1), in any order, on any threads, and returns when all are done. */
    void (*run)(void *ctx, void (*job)(void *arg, unsigned index), void *arg, unsigned count);
    /* Acquires the lock for work that only one job at a time may do; leave releases it. Returns false, without waiting,
     * when another job holds it. */
    bool (*enter)(void *ctx);
    void (*leave)(void *ctx);
    void *ctx;
    unsigned count; /* largest number of jobs that run at once; 0 means 1 */
};

/* The last argument of functions that may take a while. NULL, or all zero: one thread, never stopped. */
struct tia_job {
    const struct tia_workers *workers; /* threads among which a function divides the work if it can; NULL: none */
    /* NULL, or a function that is polled after every few thousand items of work. Once it returns true, the polling
     * function soon returns TIA_STOPPED, with an undefined result. `stop` may be called again until then and must
     * return true again. Any thread may call it, but only one at a time. */
    bool (*stop)(void *ctx);
    void *ctx; /* argument of `stop` */
};

#ifdef __cplusplus
}
#endif

#endif
