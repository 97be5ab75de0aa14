/* cancel.h - cancellation of long work: polls the caller's `stop` at intervals; the work ends once `stop` has returned
 * true. */
#ifndef TIA_SCENE_CANCEL_H
#define TIA_SCENE_CANCEL_H

#include <tia/job.h>

/* A caller's `stop`, its context, and the work since the last poll. All but the first two start as zero. */
struct cancel {
    bool (*stop)(void *ctx); /* NULL: never cancelled */
    void *ctx;
    uint32_t work; /* number of items since the last poll */
    bool stopped;
};

static inline bool workers_are_usable(const struct tia_workers *workers)
{
    return !workers || (workers->run && workers->enter && workers->leave);
}

static inline struct cancel cancel_for(const struct tia_job *job)
{
    return job ? (struct cancel){job->stop, job->ctx, 0, false} : (struct cancel){NULL, NULL, 0, false};
}

#define CANCEL_INTERVAL 4096 /* number of items between polls, since a poll may read a clock or a keyboard */

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
