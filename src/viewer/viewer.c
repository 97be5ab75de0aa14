/* viewer.c - the interactive loop: handle keys, advance time, draw tiles, present. Knows no OS. */
#include "loop.h"

/* The time until the next repeat or frame is due, in ms, rounded up; -1: wait for a key. */
static int idle_ms(const struct loop *loop)
{
    uint64_t time = viewer_now(loop), next = tia_viewer_repeat_us(loop);

    if (loop->plays && loop->viewer->clock && loop->end > loop->viewer->time && (!next || loop->due_us < next))
        next = loop->due_us;
    if (!next)
        return -1;
    uint64_t ms = next > time ? (next - time + 999) / 1000 : 0;
    return ms < INT16_MAX ? (int)ms : INT16_MAX; /* too early does no harm */
}

static int draw_frame(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_frame frame = {
        .number = loop->frame, .relit = loop->traced == VIEWER_PASSES, .shadows = loop->base->shadows, .block = 1};
    uint64_t start = viewer_now(loop), key_us = loop->key_us;
    bool refines = tia_viewer_refines(loop);
    int status = loop->core->set_lights(loop->view, v->lights, loop->light_count);

    frame.level = loop->core->level_name ? loop->core->level_name(loop->view) : "plain";
    tia_viewer_watch_begin(loop);
    if (!status)
        status = refines ? tia_viewer_draw_passes(loop, &frame) : tia_viewer_draw_tiles(loop);
    loop->gave_up = status == VIEWER_OUTDATED;
    if (loop->gave_up && loop->answered)
        loop->key_us = 0;
    if (loop->gave_up)
        return TIA_OK;
    if (!refines)
        frame.draw_us = viewer_now(loop) - start;
    loop->last_us = frame.draw_us;
    if (!status && v->frame_drawn)
        v->frame_drawn(v->frame_ctx, &frame);
    if (!status)
        status = v->display->present(v->display_ctx);
    if (status)
        return status;
    loop->traced = loop->whole ? VIEWER_PASSES : 0;
    loop->switched = false;
    loop->changed = false;
    loop->key_us = 0;
    loop->frame++;
    frame.key_us = key_us && v->clock ? viewer_now(loop) - key_us : 0;
    return v->frame_done ? v->frame_done(v->frame_ctx, &frame) : TIA_OK;
}

/* A technique that cannot draw what the check lets pass, such as a point that is too far away, or that there is no
 * memory for, is left out. The one before the key can. */
static int prepare(struct loop *loop)
{
    enum tia_shadows first = loop->base->shadows;
    int status;

    do {
        status = loop->view ? TIA_OK : tia_viewer_prepare(loop);
        if (!status)
            status = tia_viewer_play(loop);
        if ((status != TIA_ERR_RANGE && status != TIA_ERR_MEMORY) || !loop->switched)
            break;
        tia_viewer_switch(loop);
    } while (loop->base->shadows != first);
    return status;
}

/* Draws a frame if one is needed. TIA_HIDDEN while another program has the display. */
static int show(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_mode mode;
    int status = v->display->mode(v->display_ctx, &mode);

    if (status == TIA_HIDDEN)
        loop->changed = true;
    if (!status && !tia_viewer_same_mode(&mode, &loop->mode)) {
        loop->mode = mode;
        loop->view = NULL;
    }
    if (!status)
        status = prepare(loop);
    if (!status && (loop->changed || v->frame_limit))
        status = draw_frame(loop);
    return status;
}

/* Sleeps until there can be something to do; with frames left to draw, it only delivers pending signals. */
static int rest(struct loop *loop, bool hidden)
{
    const struct tia_viewer *v = loop->viewer;
    bool busy = loop->queued || (!hidden && (loop->changed || v->frame_limit));

    if (!v->input)
        return hidden ? TIA_HIDDEN : TIA_OK;
    return v->input->wait(v->input_ctx, busy ? 0 : hidden ? -1 : idle_ms(loop));
}

static bool is_stopped(const struct tia_viewer *v)
{
    return v->stop && v->stop(v->stop_ctx);
}

static int step(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    int status = tia_viewer_take_events(loop);

    if (status)
        return status;
    tia_viewer_repeat_held(loop);
    status = show(loop);
    if (loop->ends)
        return VIEWER_QUIT;
    if (status && status != TIA_HIDDEN)
        return status;
    if (v->frame_limit && loop->frame >= v->frame_limit)
        return VIEWER_QUIT;
    if (is_stopped(v)) /* a signal may have come while the display waited */
        return VIEWER_QUIT;
    return rest(loop, status == TIA_HIDDEN);
}

static bool is_acceptable(const struct tia_viewer *v)
{
    return v->light_capacity >= v->scene->light_count && (v->input || v->frame_limit) && !v->options.path_hash &&
           !v->options.lit && !v->options.observer && v->time >= 0 && (!v->rate[0] || (v->rate[1] && v->frame_limit));
}

int tia_viewer_run(struct tia_viewer *viewer)
{
    struct loop loop = {
        .viewer = viewer, .core = viewer->core ? viewer->core : &tia_core_q16, .base = viewer->scene, .changed = true};
    const struct tia_scene *scene = viewer->scene;
    int status = is_acceptable(viewer) ? TIA_OK : TIA_ERR_ARGUMENT;

    for (uint32_t i = 0; !status && i < scene->light_count; i++)
        viewer->lights[i] = scene->lights[i];
    loop.light_count = scene->light_count;
    if (viewer->variant) {
        *viewer->variant = *scene;
        loop.base = viewer->variant;
    }
    if (!status)
        status = tia_viewer_play_begin(&loop);
    for (size_t i = 0; !status && i < viewer->key_count; i++)
        status = tia_viewer_press(&loop, viewer->keys[i]);
    while (!status && !is_stopped(viewer))
        status = step(&loop);
    if (loop.ends)
        return loop.failure;
    return status == VIEWER_QUIT ? TIA_OK : status;
}
