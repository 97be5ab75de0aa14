/* workers_in_turn.h - functions for struct tia_workers that run jobs one after the other, on the caller's thread. */
#ifndef TESTS_WORKERS_IN_TURN_H
#define TESTS_WORKERS_IN_TURN_H

#include <stdbool.h>

static inline void run_in_turn(void *ctx, void (*job)(void *arg, unsigned index), void *arg, unsigned count)
{
    (void)ctx;
    for (unsigned i = 0; i < count; i++)
        job(arg, i);
}

static inline bool enter_in_turn(void *ctx)
{
    (void)ctx;
    return true;
}

static inline void leave_in_turn(void *ctx)
{
    (void)ctx;
}

#endif
