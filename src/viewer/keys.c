/* keys.c - key events, and the repeat of held keys. */
#include "loop.h"

int tia_viewer_press(struct loop *loop, uint16_t key)
{
    const struct tia_viewer *v = loop->viewer;

    if (tia_viewer_is_switch(loop, key)) {
        tia_viewer_switch(loop);
        return TIA_OK;
    }
    uint32_t light = tia_key_light(loop->scene, v->lights, loop->light_count, key);
    int status = tia_press(loop->scene, v->lights, &loop->light_count, v->light_capacity, key);

    if (status < 0)
        return VIEWER_QUIT;
    if (status > 0 && loop->plays)
        v->detached[light] = true;
    loop->changed = loop->changed || status > 0;
    return TIA_OK;
}

static bool is_held_key(uint16_t key)
{
    return key >= TIA_KEY_LEFT && key <= TIA_KEY_PAGE_DOWN;
}

static int take_event(struct loop *loop, const struct tia_event *event)
{
    uint64_t *repeat = is_held_key(event->key) ? &loop->repeat_us[event->key - TIA_KEY_LEFT] : NULL;

    if (event->kind == TIA_EVENT_RELEASE) {
        if (repeat)
            *repeat = 0;
        return TIA_OK;
    }
    if (repeat && event->kind == TIA_EVENT_PRESS && loop->viewer->clock)
        *repeat = viewer_now(loop) + TIA_HOLD_DELAY_US;
    if (event->time_us && (!loop->key_us || event->time_us < loop->key_us))
        loop->key_us = event->time_us;
    return tia_viewer_press(loop, event->key);
}

int tia_viewer_take_events(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_event event;
    int status = 0;

    for (unsigned i = 0; !status && i < loop->queued; i++)
        status = take_event(loop, &loop->queue[i]);
    loop->queued = 0;
    if (status)
        return status;
    while (v->input && (status = v->input->poll(v->input_ctx, &event)) > 0) {
        status = take_event(loop, &event);
        if (status)
            return status;
    }
    return status;
}

/* Moves the light for held keys that are due. When more than a second was missed, drops the missed steps: the
 * light would jump. */
void tia_viewer_repeat_held(struct loop *loop)
{
    uint64_t time = viewer_now(loop);

    for (uint16_t i = 0; i < VIEWER_HELD_KEYS; i++) {
        uint64_t *repeat = &loop->repeat_us[i];
        if (*repeat && time > *repeat + 1000000)
            *repeat = time;
        for (; *repeat && time >= *repeat; *repeat += TIA_HOLD_STEP_US)
            tia_viewer_press(loop, (uint16_t)(TIA_KEY_LEFT + i));
    }
}

uint64_t tia_viewer_repeat_us(const struct loop *loop)
{
    uint64_t next = 0;

    for (unsigned i = 0; i < VIEWER_HELD_KEYS; i++)
        if (loop->repeat_us[i] && (!next || loop->repeat_us[i] < next))
            next = loop->repeat_us[i];
    return next;
}
