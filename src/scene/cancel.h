/* cancel.h - cancellation of long work: polls the caller's `stop` at intervals, and ends once it returns true. */
#ifndef TIA_SCENE_CANCEL_H
#define TIA_SCENE_CANCEL_H

#include <stdbool.h>
#include <stdint.h>

/* All zero but the first two. */
struct cancel {
    bool (*stop)(void *ctx); /* NULL: never cancelled */
    void *ctx;
    uint32_t work; /* items since the last poll */
    bool stopped;
};

#define CANCEL_INTERVAL 4096 /* items: a poll may read a clock or a keyboard */

/* Adds `work` items; returns true once cancelled. */
static inline bool cancelled(struct cancel *cancel, uint32_t work)
{
    cancel->work = cancel->work < CANCEL_INTERVAL ? cancel->work + work : cancel->work;
    if (cancel->stop && !cancel->stopped && cancel->work >= CANCEL_INTERVAL) {
        cancel->work = 0;
        cancel->stopped = cancel->stop(cancel->ctx);
    }
    return cancel->stopped;
}

#endif
