/* viewer.c - the interactive loop: handle keys, advance time, draw tiles, present. Independent of the operating system.
 */
#include "loop.h"
#include "math/divide.h"
#include "scene/check/scene_check.h"

#define RATE_MAX 1000000 /* maximum of both numbers of a rate and a pace */

/* Returns the time until the next repeat or frame is due, in ms, rounded up; -1: wait for a key. */
static int idle_ms(const struct loop *loop)
{
    uint64_t time = viewer_now(loop), next = tia_viewer_repeat_us(loop);

    if (loop->plays && !loop->state.paused && loop->viewer->ports.clock && loop->end > loop->viewer->pacing.time &&
        (!next || loop->due_us < next))
        next = loop->due_us;
    if (!next)
        return -1;
    uint64_t ms = next > time ? tia_quotient(next - time + 999, 1000) : 0;
    return ms < INT16_MAX ? (int)ms : INT16_MAX; /* early wake-ups do no harm */
}

static void keep_lights(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;

    loop->pressed = false;
    loop->keeps = v->lights.kept != NULL;
    loop->kept_count = loop->state.light_count;
    for (uint32_t i = 0; loop->keeps && i < loop->kept_count; i++)
        v->lights.kept[i] = v->lights.array[i];
}

/* Undoes the keys' changes to the lights since the last picture; false when there are none. */
static bool take_back_lights(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;

    if (!loop->pressed || !loop->keeps)
        return false;
    loop->pressed = false;
    loop->state.light_count = loop->kept_count;
    for (uint32_t i = 0; i < loop->kept_count; i++)
        v->lights.array[i] = v->lights.kept[i];
    return true;
}

/* Shows the picture and reports it. */
static int show_frame(struct loop *loop, struct tia_frame *frame)
{
    const struct tia_viewer *v = loop->viewer;
    uint64_t key_us = loop->key_us;
    int status = TIA_OK;

    viewer_tell(loop);
    if (v->hooks.frame_drawn)
        v->hooks.frame_drawn(v->hooks.ctx, frame);
    status = tia_viewer_present(loop);
    if (status && status != VIEWER_OUTDATED) /* the rest of an outdated frame is shown before the next one */
        return status;
    loop->switched = false;
    loop->changed = loop->covered = false;
    loop->key_us = 0;
    loop->state.incomplete = loop->unfinished;
    viewer_tell(loop);
    loop->good = loop->scene->camera;
    keep_lights(loop);
    loop->frame++;
    frame->key_us = key_us && v->ports.clock ? viewer_now(loop) - key_us : 0;
    return v->hooks.frame_done ? v->hooks.frame_done(v->hooks.ctx, frame) : TIA_OK;
}

static bool is_moving(const struct loop *loop)
{
    return loop->more && loop->more->is_moving(loop);
}

static struct tia_frame new_frame(const struct loop *loop)
{
    return (struct tia_frame){.number = loop->frame,
                              .block = 1,
                              .pixels = (uint32_t)loop->mode.width * loop->mode.height,
                              .moving = is_moving(loop),
                              .relit = loop->traced == VIEWER_PASSES,
                              .shadows = loop->base->shadows,
                              .simd = tia_view_simd(loop->view)};
}

static int draw_frame(struct loop *loop)
{
    struct tia_frame frame = new_frame(loop);
    bool refines = loop->more && loop->more->refines(loop);

    loop->complete = loop->unfinished = false;
    loop->state.incomplete = true;
    viewer_tell(loop);
    tia_viewer_watch_begin(loop);
    int status = refines ? loop->more->draw_passes(loop, &frame) : tia_viewer_draw_tiles(loop);
    loop->gave_up = status == VIEWER_OUTDATED;
    if (loop->gave_up && loop->answered)
        loop->key_us = 0;
    if (loop->gave_up)
        return TIA_OK;
    if (!refines)
        frame.draw_us = viewer_now(loop) - loop->lights_us;
    if (status)
        return status;
    loop->last_us = refines ? loop->more->whole_us(loop, &frame) : frame.draw_us;
    if (!refines)
        loop->traced = loop->whole ? VIEWER_PASSES : 0;
    return show_frame(loop, &frame);
}

/* Shows the picture again when only the overlay on it has changed. */
static int show_again(struct loop *loop)
{
    struct tia_frame frame = new_frame(loop);
    uint64_t start = viewer_now(loop);
    int status;

    frame.moving = false;
    tia_viewer_watch_begin(loop);
    status = loop->more ? loop->more->copy(loop) : tia_viewer_draw_tiles(loop);
    frame.pixels = loop->more ? 0 : frame.pixels;
    frame.draw_us = viewer_now(loop) - start;
    return status ? status : show_frame(loop, &frame);
}

/* True if the picture must be drawn, and not only shown again. */
static bool is_due(const struct loop *loop)
{
    return loop->changed || loop->viewer->pacing.frame_limit || (loop->unfinished && !is_moving(loop)) ||
           (loop->covered && !loop->complete && !loop->unfinished);
}

static int set_lights(struct loop *loop)
{
    loop->lights_us = viewer_now(loop);
    return tia_view_set_lights(loop->view, loop->viewer->lights.array, loop->state.light_count);
}

/* Updates the view. */
static int play(struct loop *loop)
{
    if (loop->more)
        return loop->more->play(loop);
    return loop->view_ready ? TIA_OK : tia_viewer_prepare_view(loop);
}

/* Prepares memory and view. A scene that passes the check may still be impossible to draw, because an object or a light
 * is too far away or memory is short. Then the changes that keys made to the technique, the lights or the camera are
 * undone: the earlier state can be drawn. */
static int prepare(struct loop *loop)
{
    enum tia_shadows first = loop->base->shadows;
    int status;

    do {
        status = loop->view ? TIA_OK : tia_viewer_prepare(loop);
        if (!status)
            status = play(loop);
        if (!status && is_due(loop))
            status = set_lights(loop);
        if ((status != TIA_ERR_RANGE && status != TIA_ERR_MEMORY) ||
            !(loop->switched || take_back_lights(loop) || (loop->more && loop->more->go_back(loop))))
            break;
        if (loop->switched)
            loop->more->switch_shadows(loop);
    } while (!loop->switched || loop->base->shadows != first);
    return status;
}

/* Draws a frame if one is needed. TIA_HIDDEN while another program has the display. */
static int show(struct loop *loop)
{
    struct tia_mode mode;
    int status = viewer_mode(loop, &mode);

    if (status == TIA_HIDDEN)
        loop->changed = true;
    if (!status && (mode.width - 1u >= TIA_SIZE_MAX || mode.height - 1u >= TIA_SIZE_MAX))
        return TIA_ERR_ARGUMENT;
    if (!status && !tia_viewer_same_mode(&mode, &loop->mode)) {
        loop->mode = mode;
        loop->view = NULL;
    }
    if (!status)
        status = prepare(loop);
    if (status)
        return status;
    if (is_due(loop))
        return draw_frame(loop);
    return loop->covered && loop->complete ? show_again(loop) : tia_viewer_go_on(loop);
}

/* Waits until there may be work; if work is left, only delivers pending signals. */
static int rest(struct loop *loop, bool hidden)
{
    const struct tia_viewer *v = loop->viewer;
    bool unfinished = loop->unfinished && !is_moving(loop);
    bool busy = loop->queued || (!hidden && (loop->changed || v->pacing.frame_limit || unfinished || loop->showing));

    if (!v->ports.input)
        return hidden ? TIA_HIDDEN : TIA_OK;
    return v->ports.input->wait(v->ports.input_ctx, busy ? 0 : hidden ? -1 : idle_ms(loop));
}

static bool is_stopped(const struct tia_viewer *v)
{
    return v->job.stop && v->job.stop(v->job.ctx);
}

static int step(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    int status = tia_viewer_take_events(loop);

    if (status)
        return status;
    status = tia_viewer_repeat_held(loop);
    if (!status)
        status = show(loop);
    if (loop->ends)
        return VIEWER_QUIT;
    if (status && status != TIA_HIDDEN)
        return status;
    if (v->pacing.frame_limit && loop->frame >= v->pacing.frame_limit)
        return VIEWER_QUIT;
    if (is_stopped(v)) /* a signal may have come while the display waited */
        return VIEWER_QUIT;
    return rest(loop, status == TIA_HIDDEN);
}

static bool is_rate(const uint32_t rate[2])
{
    return !rate[0] || (rate[0] <= RATE_MAX && rate[1] - 1 < RATE_MAX);
}

/* True if all required ports and hooks are set. */
static bool is_complete(const struct tia_viewer *v)
{
    const struct tia_display *d = v->ports.display;

    return d && d->mode && d->acquire && d->submit && d->present && v->hooks.memory &&
           (v->ports.input ? v->ports.input->poll && v->ports.input->wait : v->pacing.frame_limit > 0) &&
           (!v->ports.clock || v->ports.clock->now_us) && workers_are_usable(v->job.workers) &&
           (!v->hooks.control || (v->hooks.control->weigh && v->hooks.control->act && v->variant));
}

static bool is_acceptable(const struct tia_viewer *v)
{
    return v && v->scene && is_complete(v) && v->lights.capacity >= v->scene->light_count &&
           (v->lights.array || !v->lights.capacity) && (v->keys || !v->key_count) && v->pacing.time >= 0 &&
           is_rate(v->pacing.rate) && (!v->pacing.rate[0] || v->pacing.frame_limit) && is_rate(v->pacing.pace) &&
           !(v->state && v->state->goes_on && v->state->light_count > v->lights.capacity);
}

/* Sets the scene and its lights, or the lights from an earlier run of the loop. */
static void begin(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;

    loop->scene = v->scene;
    loop->state = (struct tia_viewer_state){.light_count = v->scene->light_count, .time = v->pacing.time};
    if (v->state && v->state->goes_on)
        loop->state = *v->state;
    else
        for (uint32_t i = 0; i < v->scene->light_count; i++)
            v->lights.array[i] = v->scene->lights[i];
    loop->state.incomplete = true;
    loop->good = v->scene->camera;
    if (!v->variant)
        return;
    *v->variant = *v->scene;
    if (loop->state.moved)
        v->variant->camera = loop->state.camera;
    loop->scene = loop->base = v->variant;
}

static int press_first(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    int status = TIA_OK;

    for (size_t i = 0; !status && i < v->key_count; i++) {
        struct tia_event event = {.kind = TIA_EVENT_TAP, .key = v->keys[i]};
        status = tia_viewer_take_key(loop, &event);
    }
    return status;
}

/* Passes the event that has ended the loop, if any, to the caller's control. */
static void end(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_camera camera = loop->scene->camera;

    viewer_tell(loop);
    if (!loop->last.key || !v->hooks.control)
        return;
    if (loop->more)
        loop->more->copy_last(loop);
    (void)v->hooks.control->act(v->hooks.ctx, &loop->last, &camera);
}

int tia_viewer_loop(struct tia_viewer *viewer, const struct tia_core *core, const struct viewer_more *more)
{
    if (!is_acceptable(viewer) || !(viewer->core || core))
        return TIA_ERR_ARGUMENT;
    struct loop loop = {.viewer = viewer,
                        .more = more,
                        .core = viewer->core ? viewer->core : core,
                        .base = viewer->scene,
                        .gaze = viewer->gaze,
                        .changed = true};
    struct cancel cancel = cancel_for(&viewer->job);
    int status = (more ? more->check : tia_check_spheres)(viewer->scene, NULL, &cancel);

    if (status)
        return status == TIA_STOPPED ? TIA_OK : TIA_ERR_RANGE;
    begin(&loop);
    if (more)
        status = more->play_begin(&loop);
    if (!status)
        status = press_first(&loop);
    while (!status && !is_stopped(viewer))
        status = step(&loop);
    end(&loop);
    if (loop.ends)
        return loop.failure;
    return status == VIEWER_QUIT ? TIA_OK : status;
}
