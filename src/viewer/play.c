/* play.c - animation: the current time, and the scene at that time. */
#include <tia/bvh.h>
#include <tia/motion.h>

#include "loop.h"
#include "math/align.h"
#include "math/divide.h"

#define SCENE_SIZE ALIGN(sizeof(struct tia_scene))

/* Returns the time of a frame. n * TIA_Q16_ONE cannot overflow: n < 2^15 rate[0], and rate[0] < 2^20. */
tia_q16 tia_viewer_frame_time(tia_q16 start, uint32_t frame, const uint32_t rate[2])
{
    if (!rate)
        return start;
    uint64_t n = (uint64_t)frame * rate[1], time;

    if (n >= (uint64_t)rate[0] << 15)
        return INT32_MAX;
    time = (uint64_t)start + (n * TIA_Q16_ONE + rate[0] / 2) / rate[0];
    return time < INT32_MAX ? (tia_q16)time : INT32_MAX;
}

/* Returns the scene's time by the clock; it starts over after the last keyframe. */
static tia_q16 clock_time(const struct loop *loop)
{
    tia_q16 begin = loop->viewer->pacing.time;
    uint64_t length = loop->end > begin ? (uint64_t)(loop->end - begin) * 1000000 / TIA_Q16_ONE : 0;

    if (loop->state.paused && loop->started && loop->time >= 0)
        return loop->time;
    if (!length || !loop->started)
        return begin;
    return begin + (tia_q16)tia_quotient(divide_rest(viewer_now(loop) - loop->start_us, length) * TIA_Q16_ONE, 1000000);
}

static bool is_stepped(const struct loop *loop)
{
    return loop->viewer->pacing.rate[0] && loop->viewer->pacing.frame_limit;
}

static tia_q16 time_now(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    return is_stepped(loop) ? tia_viewer_frame_time(v->pacing.time, loop->frame, v->pacing.rate) : clock_time(loop);
}

/* Updates from their tracks the lights that no key has set or moved. */
static void follow(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;

    for (uint32_t i = 0; i < loop->current->light_count; i++)
        if (!v->lights.detached[i])
            v->lights.array[i] = loop->current->lights[i];
}

static int update_scene(struct loop *loop, tia_q16 time)
{
    const struct tia_job job = {.stop = tia_viewer_stops, .ctx = loop};
    int status = tia_scene_at(loop->current, (char *)loop->current + SCENE_SIZE, loop->current_size - SCENE_SIZE,
                              loop->base, time, &job);

    if (status)
        return status;
    if (loop->state.moved)
        loop->current->camera = loop->state.camera;
    loop->scene = loop->current;
    loop->time = time;
    follow(loop);
    return TIA_OK;
}

static bool moves_only_lights(const struct tia_scene *scene)
{
    for (uint32_t i = 0; i < scene->track_count; i++) {
        enum tia_target target = scene->tracks[i].target;
        if (target != TIA_MOVES_LIGHT && target != TIA_ROTATES_LIGHT && target != TIA_SHOWS_LIGHT)
            return false;
    }
    return !scene->falling;
}

int tia_viewer_play_begin(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;

    loop->scene = loop->base;
    loop->plays = tia_scene_moves(v->scene);
    if (!loop->plays)
        return TIA_OK;
    if (!v->lights.detached)
        return TIA_ERR_ARGUMENT;
    for (uint32_t i = 0; i < v->lights.capacity && !loop->state.goes_on; i++)
        v->lights.detached[i] = false;
    loop->end = tia_scene_duration(v->scene);
    loop->only_lights = moves_only_lights(v->scene);
    loop->bvh_size = v->scene->bvh ? tia_bvh_move_size(v->scene) : 0;
    loop->current_size = tia_scene_at_size(v->scene) + SCENE_SIZE;
    if (loop->current_size < SIZE_MAX / 8 && loop->current_size >= SCENE_SIZE)
        loop->current = v->hooks.memory(v->hooks.ctx, loop->current_size);
    return memory_is_usable(loop->current) ? update_scene(loop, loop->state.time) : TIA_ERR_MEMORY;
}

/* Updates the view. When only lights move, the view and the hierarchy stay valid, since the lights are set before each
 * frame anyway. */
static int update_view(struct loop *loop, tia_q16 time)
{
    bool anew = !loop->view_ready || !loop->only_lights;
    const struct tia_bvh *bvh = anew ? NULL : loop->current->bvh;
    int status = update_scene(loop, time);

    loop->current->bvh = bvh;
    if (!status && anew && loop->bvh_size)
        status = tia_bvh_move(&loop->current->bvh, loop->bvh_memory, loop->bvh_size, loop->current, loop->base,
                              &(struct tia_job){.stop = tia_viewer_stops, .ctx = loop});
    if (!status && anew)
        status = tia_viewer_prepare_view(loop);
    loop->changed = true;
    return status;
}

/* Returns the time when the next frame is due: with a pace, one period after the time when the last one was due, or now
 * if that is past; else TIA_PLAY_STEP_US from now. */
static uint64_t next_due(const struct loop *loop, uint64_t now)
{
    uint64_t next = loop->due_us + tia_viewer_period_us(loop);

    return !loop->viewer->pacing.pace[0] ? now + TIA_PLAY_STEP_US : next > now ? next : now;
}

int tia_viewer_play(struct loop *loop)
{
    uint64_t now = viewer_now(loop);
    tia_q16 time = time_now(loop);

    if (!loop->plays)
        return loop->view_ready ? TIA_OK : tia_viewer_prepare_view(loop);
    if (!loop->started) {
        loop->due_us = loop->paused_us = now;
        loop->start_us = now - (uint64_t)(loop->state.time - loop->viewer->pacing.time) * 1000000 / TIA_Q16_ONE;
    }
    loop->started = true;
    bool due = now >= loop->due_us || loop->changed || loop->viewer->pacing.frame_limit;
    if (loop->view_ready && (time == loop->time || !due))
        return TIA_OK;
    loop->due_us = next_due(loop, now);
    return update_view(loop, time);
}
