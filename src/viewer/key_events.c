/* key_events.c - events, and the repeat of held keys. */
#include "loop.h"

#include "math/divide.h"
#include "scene/check/scene_check.h"

/* Returns the index of the light that a key sets or moves, or TIA_NO_LIGHT. *first receives the index of the first
 * light that the key may move: that of the chosen light, else 0. */
static uint32_t light_of(const struct loop *loop, uint16_t key, uint32_t *first)
{
    const struct tia_viewer *v = loop->viewer;
    uint32_t count = loop->state.light_count, light;

    *first = tia_viewer_moves(loop, key) && loop->state.light < count ? loop->state.light : 0;
    light = tia_viewer_key_light(loop->scene, v->lights.array + *first, count - *first, key);
    return light == TIA_NO_LIGHT ? light : light + *first;
}

static int press_light(struct loop *loop, uint16_t key)
{
    const struct tia_viewer *v = loop->viewer;
    uint32_t first, light = light_of(loop, key, &first), count = loop->state.light_count - first;
    int status = tia_viewer_press_lights(loop->more ? loop->more->check : tia_check_spheres, loop->scene,
                                         v->lights.array + first, &count, v->lights.capacity - first, key);

    loop->state.light_count = count + first;
    if (status > 0 && loop->plays)
        v->lights.detached[light] = true;
    loop->changed = loop->changed || status > 0;
    loop->pressed = loop->pressed || status > 0;
    return light == TIA_NO_LIGHT ? TIA_ERR_ARGUMENT : TIA_OK;
}

/* Returns the effect of an event. In the viewer of spheres alone, keys that neither set nor move lights end the
 * loop. */
enum tia_effect tia_viewer_effect_of(const struct loop *loop, const struct tia_event *event)
{
    if (loop->more)
        return loop->more->effect(loop, event);
    if (event->kind > TIA_EVENT_TAP || event->kind == TIA_EVENT_RELEASE)
        return TIA_EFFECT_NONE;
    return tia_viewer_lights(loop, event) ? TIA_EFFECT_CAMERA : TIA_EFFECT_END;
}

static int control(struct loop *loop, const struct tia_event *event)
{
    if (loop->more)
        return loop->more->control(loop, event);
    return tia_viewer_effect_of(loop, event) == TIA_EFFECT_END ? VIEWER_QUIT : TIA_OK;
}

int tia_viewer_take_key(struct loop *loop, const struct tia_event *event)
{
    if (tia_viewer_is_switch(loop, event->key)) {
        loop->more->switch_shadows(loop);
        return TIA_OK;
    }
    if (tia_viewer_lights(loop, event) && (!press_light(loop, event->key) || !loop->viewer->hooks.control))
        return TIA_OK;
    return control(loop, event);
}

/* ---- held keys ---- */

static bool is_repeated(const struct loop *loop, uint16_t key)
{
    static const char more[] = "hjkl+-";

    for (unsigned i = 0; loop->viewer->hooks.control && more[i]; i++)
        if (key == (unsigned char)more[i])
            return true;
    return key >= TIA_KEY_LEFT && key <= TIA_KEY_PAGE_DOWN;
}

static void let_go(struct loop *loop, uint16_t key)
{
    for (unsigned i = 0; i < VIEWER_HELD_KEYS; i++)
        if (loop->held[i].key == key)
            loop->held[i].due_us = 0;
}

static void hold(struct loop *loop, const struct tia_event *event)
{
    let_go(loop, event->key);
    for (unsigned i = 0; i < VIEWER_HELD_KEYS; i++)
        if (!loop->held[i].due_us) {
            loop->held[i] = (struct held){viewer_now(loop) + TIA_HOLD_DELAY_US, event->key, event->shift};
            return;
        }
}

static int take_event(struct loop *loop, const struct tia_event *event)
{
    if (event->kind == TIA_EVENT_POINT || event->kind == TIA_EVENT_MOVE)
        return control(loop, event);
    if (event->kind == TIA_EVENT_RELEASE) {
        let_go(loop, event->key);
        return TIA_OK;
    }
    if (event->kind == TIA_EVENT_PRESS && loop->viewer->ports.clock && is_repeated(loop, event->key))
        hold(loop, event);
    if (event->time_us && (!loop->key_us || event->time_us < loop->key_us))
        loop->key_us = event->time_us;
    return tia_viewer_take_key(loop, event);
}

int tia_viewer_take_events(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_event event;
    int status = 0;

    for (unsigned i = 0; !status && i < loop->queued; i++)
        status = take_event(loop, &loop->queue[i]);
    loop->queued = 0;
    loop->outdated = false;
    if (status)
        return status;
    while (v->ports.input && (status = v->ports.input->poll(v->ports.input_ctx, &event)) > 0) {
        status = take_event(loop, &event);
        if (status)
            return status;
    }
    return status;
}

void tia_viewer_take_quiet(struct loop *loop)
{
    unsigned taken = 0;

    while (taken < loop->queued && tia_viewer_effect_of(loop, &loop->queue[taken]) == TIA_EFFECT_NONE)
        (void)take_event(loop, &loop->queue[taken++]);
    loop->queued -= taken;
    for (unsigned i = 0; i < loop->queued; i++)
        loop->queue[i] = loop->queue[i + taken];
}

/* Drops repeats of a held key if pictures are so slow that more than TIA_HOLD_STEPS are due at once: the eye could not
 * follow, and the user would release the key too late. */
static void drop_steps(struct held *held, uint64_t time)
{
    uint64_t late = held->due_us && time > held->due_us ? tia_quotient(time - held->due_us, TIA_HOLD_STEP_US) : 0;

    if (late >= TIA_HOLD_STEPS)
        held->due_us += (late - (TIA_HOLD_STEPS - 1)) * TIA_HOLD_STEP_US;
}

/* Repeats the held keys that are due. */
int tia_viewer_repeat_held(struct loop *loop)
{
    uint64_t time = viewer_now(loop);
    int status = TIA_OK;

    for (unsigned i = 0; i < VIEWER_HELD_KEYS; i++) {
        struct held *held = &loop->held[i];
        const struct tia_event again = {.kind = TIA_EVENT_PRESS, .key = held->key, .shift = held->shift};
        drop_steps(held, time);
        for (; !status && held->due_us && time >= held->due_us; held->due_us += TIA_HOLD_STEP_US)
            status = tia_viewer_take_key(loop, &again);
    }
    return status;
}

uint64_t tia_viewer_repeat_us(const struct loop *loop)
{
    uint64_t next = 0;

    for (unsigned i = 0; i < VIEWER_HELD_KEYS; i++)
        if (loop->held[i].due_us && (!next || loop->held[i].due_us < next))
            next = loop->held[i].due_us;
    return next;
}
