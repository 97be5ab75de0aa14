/* watch.c - events that end a frame that is being drawn. A key that quits, or the viewer's `stop`, ends the frame at
 * once, even in the middle of a ray's tree. A key that moves a light, pressed or held, makes the frame out of date.
 * Such a frame ends at once if a coarse picture of it has been shown; else at the next tile, if it has already taken
 * long. A full queue ends the frame at the next tile, too, since more keys are waiting. */
#include "loop.h"

#define PATIENCE_US 250000 /* time after which a frame that is out of date is given up */
#define STEP_US 20000      /* time between two checks */

static bool is_full(const struct loop *loop)
{
    return loop->queued == VIEWER_QUEUE;
}

static void keep(struct loop *loop, const struct tia_event *event)
{
    enum tia_effect effect = tia_viewer_effect_of(loop, event);

    loop->ends = effect == TIA_EFFECT_END;
    if (loop->ends)
        loop->last = *event;
    loop->outdated = loop->outdated || effect != TIA_EFFECT_NONE;
    if (!loop->more || !loop->more->joins(loop, event))
        loop->queue[loop->queued++] = *event;
}

/* Polls the input. Events that the queue cannot hold stay in the input, so that no key is lost. */
static void poll_input(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_event event;
    int status = 0;

    while (v->ports.input && !loop->ends && !is_full(loop) &&
           (status = v->ports.input->poll(v->ports.input_ctx, &event)) > 0)
        keep(loop, &event);
    if (status < 0) {
        loop->failure = status;
        loop->ends = true;
    }
}

static bool is_held_due(const struct loop *loop, uint64_t now)
{
    uint64_t next = tia_viewer_repeat_us(loop);
    return next && now >= next;
}

/* Returns the time after which a frame that is out of date is given up: 0 in a playing scene whose frames can be shown
 * before they are complete, unless this frame shows a key press. */
static uint64_t patience_us(const struct loop *loop)
{
    return loop->plays && loop->canvas && !loop->key_us ? 0 : PATIENCE_US;
}

/* Checks for events. Never gives up two frames in a row: while keys keep coming, some frames are still shown. */
static void look(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    uint64_t now = viewer_now(loop);

    if (loop->ends || (v->ports.clock && now < loop->look_us))
        return;
    loop->look_us = now + STEP_US;
    loop->ends = v->job.stop && v->job.stop(v->job.ctx);
    poll_input(loop);
    loop->outdated = loop->outdated || (loop->answered && is_held_due(loop, now));
    loop->gives_up = v->ports.clock && loop->outdated &&
                     (loop->answered || (!loop->gave_up && now >= loop->begun_us + patience_us(loop)));
}

void tia_viewer_watch_begin(struct loop *loop)
{
    loop->begun_us = viewer_now(loop);
    loop->look_us = loop->begun_us + STEP_US;
    loop->gives_up = loop->answered = false;
    loop->showing_us = 0;
}

/* Acquires the lock; false: another thread holds it. Fields of struct loop that change while tiles are drawn are only
 * used between enter and leave. */
static bool enter(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    return !v->job.workers || v->job.workers->enter(v->job.workers->ctx);
}

static void leave(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    if (v->job.workers)
        v->job.workers->leave(v->job.workers->ctx);
}

int tia_viewer_watch(struct loop *loop)
{
    int status;

    if (!enter(loop))
        return TIA_OK;
    look(loop);
    status = loop->ends ? TIA_STOPPED : loop->gives_up || is_full(loop) ? VIEWER_OUTDATED : TIA_OK;
    leave(loop);
    return status;
}

bool tia_viewer_stops(void *ctx)
{
    const struct loop *loop = ctx;
    int status = tia_viewer_watch(ctx);
    return status == TIA_STOPPED || (status && loop->refining);
}
