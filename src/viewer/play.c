/* play.c - scenes that move: which time it is, and the scene at that time. */
#include <tia/bvh.h>
#include <tia/motion.h>

#include "loop.h"
#include "math/align.h"

#define SCENE_SIZE ALIGN(sizeof(struct tia_scene))

/* The product stays below 2^15 2^20 2^16. */
tia_q16 tia_frame_time(tia_q16 start, uint32_t frame, const uint32_t rate[2])
{
    uint64_t n = (uint64_t)frame * rate[1], time;

    if (n >= (uint64_t)rate[0] << 15)
        return INT32_MAX;
    time = (uint64_t)start + (n * TIA_Q16_ONE + rate[0] / 2) / rate[0];
    return time < INT32_MAX ? (tia_q16)time : INT32_MAX;
}

/* By the clock, from the beginning again after the end. */
static tia_q16 clock_time(const struct loop *loop)
{
    tia_q16 begin = loop->viewer->time;
    uint64_t length = loop->end > begin ? (uint64_t)(loop->end - begin) * 1000000 / TIA_Q16_ONE : 0;

    if (!length || !loop->started)
        return begin;
    return begin + (tia_q16)((viewer_now(loop) - loop->start_us) % length * TIA_Q16_ONE / 1000000);
}

static bool is_stepped(const struct loop *loop)
{
    return loop->viewer->rate[0] != 0;
}

static tia_q16 time_now(const struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    return is_stepped(loop) ? tia_frame_time(v->time, loop->frame, v->rate) : clock_time(loop);
}

/* Lights that no key holds follow the scene. */
static void follow(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;

    for (uint32_t i = 0; i < loop->moment->light_count; i++)
        if (!v->held[i])
            v->lights[i] = loop->moment->lights[i];
}

static int place(struct loop *loop, tia_q16 time)
{
    int status = tia_scene_at(loop->moment, (char *)loop->moment + SCENE_SIZE, loop->moment_size - SCENE_SIZE,
                              loop->viewer->scene, time);

    if (status)
        return status;
    loop->scene = loop->moment;
    loop->time = time;
    follow(loop);
    return TIA_OK;
}

static bool moves_only_lights(const struct tia_scene *scene)
{
    for (uint32_t i = 0; i < scene->track_count; i++)
        if (scene->tracks[i].target != TIA_MOVES_LIGHT && scene->tracks[i].target != TIA_TURNS_LIGHT)
            return false;
    return true;
}

/* Keys that are pressed before the first frame are pressed at its time. */
int tia_viewer_play_begin(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;

    loop->scene = v->scene;
    loop->plays = v->scene->track_count > 0;
    if (!loop->plays)
        return TIA_OK;
    if (!v->held)
        return TIA_ERR_ARGUMENT;
    for (uint32_t i = 0; i < v->light_capacity; i++)
        v->held[i] = false;
    loop->end = tia_scene_duration(v->scene);
    loop->only_lights = moves_only_lights(v->scene);
    loop->moment_size = tia_scene_at_size(v->scene) + SCENE_SIZE;
    if (loop->moment_size < SIZE_MAX / 8 && loop->moment_size >= SCENE_SIZE)
        loop->moment = v->memory(v->memory_ctx, loop->moment_size);
    return loop->moment ? place(loop, v->time) : TIA_ERR_MEMORY;
}

/* Where only lights move the view and the boxes stay: lights are set before each frame. */
static int place_view(struct loop *loop, tia_q16 time)
{
    bool anew = !loop->view_ready || !loop->only_lights;
    const struct tia_bvh *boxes = anew ? NULL : loop->moment->bvh;
    int status = place(loop, time);

    loop->moment->bvh = boxes;
    if (!status && anew && loop->boxes_size)
        status = tia_bvh_build(&loop->moment->bvh, loop->boxes_memory, loop->boxes_size, NULL, loop->moment);
    if (!status && anew)
        status = tia_viewer_prepare_view(loop);
    loop->changed = true;
    return status;
}

int tia_viewer_play(struct loop *loop)
{
    uint64_t now = viewer_now(loop);
    tia_q16 time = time_now(loop);

    if (!loop->plays)
        return loop->view_ready ? TIA_OK : tia_viewer_prepare_view(loop);
    if (!loop->started)
        loop->start_us = loop->due_us = now;
    loop->started = true;
    bool due = now >= loop->due_us || loop->changed || loop->viewer->frame_limit;
    if (loop->view_ready && (time == loop->time || !due))
        return TIA_OK;
    loop->due_us = now + TIA_PLAY_STEP_US;
    return place_view(loop, time);
}
