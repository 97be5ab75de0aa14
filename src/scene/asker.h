/* asker.h - long work on a scene calls the caller's `stop` now and then, and ends early once it returns true. */
#ifndef TIA_SCENE_ASKER_H
#define TIA_SCENE_ASKER_H

#include <stdbool.h>
#include <stdint.h>

/* All zero but the first two. */
struct asker {
    bool (*stop)(void *ctx); /* NULL: nobody */
    void *ctx;
    uint32_t work; /* items since the last question */
    bool stopped;
};

#define ASKER_PATIENCE 4096 /* items: the question may cost a look at a clock, or at a keyboard */

/* Adds some items of work. True: stop. */
static inline bool asker_stops(struct asker *asker, uint32_t work)
{
    asker->work = asker->work < ASKER_PATIENCE ? asker->work + work : asker->work;
    if (asker->stop && !asker->stopped && asker->work >= ASKER_PATIENCE) {
        asker->work = 0;
        asker->stopped = asker->stop(asker->ctx);
    }
    return asker->stopped;
}

#endif
