/* control.c - the effects of keys and pointers that neither set nor move lights. */
#include "loop.h"

static bool is_pointer(const struct tia_event *event)
{
    return event->kind == TIA_EVENT_POINT || event->kind == TIA_EVENT_MOVE;
}

/* True for the loop's own keys: TIA_KEY_TAB, and in a scene that plays TIA_KEY_SPACE. */
static bool is_own(const struct loop *loop, uint16_t key)
{
    return loop->viewer->hooks.control && (key == TIA_KEY_TAB || (key == TIA_KEY_SPACE && loop->plays));
}

enum tia_effect tia_viewer_effect(const struct loop *loop, const struct tia_event *event)
{
    const struct tia_viewer *v = loop->viewer;
    enum tia_effect other = v->hooks.control ? v->hooks.control->weigh(v->hooks.ctx, event) : TIA_EFFECT_NONE;

    if (event->kind == TIA_EVENT_RELEASE)
        return TIA_EFFECT_NONE;
    if (is_pointer(event))
        return other == TIA_EFFECT_NONE && loop->gaze.view_angle && loop->canvas ? TIA_EFFECT_PICTURE : other;
    if (tia_viewer_is_switch(loop, event->key) || tia_viewer_lights(loop, event))
        return TIA_EFFECT_CAMERA;
    if (is_own(loop, event->key))
        return TIA_EFFECT_PICTURE;
    return v->hooks.control ? other : TIA_EFFECT_END;
}

/* ---- the camera ---- */

static void set_camera(struct loop *loop, const struct tia_camera *camera)
{
    struct tia_scene *variant = loop->viewer->variant;

    variant->camera = *camera;
    loop->state.camera = *camera;
    if (loop->current)
        loop->current->camera = *camera;
    loop->view_ready = false;
    loop->changed = true;
    if (loop->core->view_size(loop->core, loop->base, loop->viewer->lights.capacity) != loop->view_size)
        loop->view = NULL; /* the scene now has another renderer */
}

/* Moves the camera if its own fields are valid. Preparing the view checks the scene's distance from it, see
 * tia_viewer_go_back. */
static void move_camera(struct loop *loop, const struct tia_camera *camera)
{
    const struct tia_scene alone = {.camera = *camera};

    if (tia_scene_check(&alone, NULL))
        return;
    loop->state.moved = true;
    set_camera(loop, camera);
}

static void go_home(struct loop *loop)
{
    loop->state.moved = false;
    set_camera(loop, &loop->viewer->scene->camera);
    if (loop->plays)
        loop->time = -1; /* differs from any time: the camera follows its track again */
}

static bool same_place(struct tia_vec3 a, struct tia_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

bool tia_viewer_go_back(struct loop *loop)
{
    const struct tia_camera *now = &loop->state.camera;

    if (!loop->state.moved ||
        (same_place(now->eye, loop->good.eye) && same_place(now->reference, loop->good.reference) &&
         same_place(now->up, loop->good.up) && now->fov == loop->good.fov))
        return false;
    set_camera(loop, &loop->good);
    return true;
}

/* ---- events ---- */

static void pause(struct loop *loop)
{
    uint64_t now = viewer_now(loop);

    loop->state.paused = !loop->state.paused;
    if (loop->state.paused)
        loop->paused_us = now;
    else
        loop->start_us += now - loop->paused_us;
    loop->covered = true;
}

/* Chooses the next light that keys move, cyclically; false: there is none. */
static bool choose_light(struct loop *loop)
{
    const struct tia_light *lights = loop->viewer->lights.array;
    uint32_t count = loop->state.light_count, from = loop->state.light < count ? loop->state.light : 0;

    while (from + 1 < count && tia_light_has(lights[from].kind, TIA_LIGHT_EVERYWHERE))
        from++;
    for (uint32_t i = 1; i <= count; i++) {
        uint32_t next = (from + i) % count;
        if (!tia_light_has(lights[next].kind, TIA_LIGHT_EVERYWHERE)) {
            loop->state.light = next;
            loop->covered = true;
            return true;
        }
    }
    return false;
}

static int act(struct loop *loop, const struct tia_event *event)
{
    const struct tia_viewer *v = loop->viewer;
    struct tia_camera camera = loop->scene->camera;
    enum tia_effect effect = v->hooks.control->act(v->hooks.ctx, event, &camera);

    if (effect == TIA_EFFECT_CAMERA)
        move_camera(loop, &camera);
    else if (effect == TIA_EFFECT_HOME)
        go_home(loop);
    loop->covered = loop->covered || effect != TIA_EFFECT_NONE;
    return TIA_OK;
}

int tia_viewer_control(struct loop *loop, const struct tia_event *event)
{
    const struct tia_viewer *v = loop->viewer;

    if (tia_viewer_effect(loop, event) == TIA_EFFECT_END) {
        loop->last = *event;
        return VIEWER_QUIT;
    }
    if (is_pointer(event) && tia_viewer_point(loop, event) && !event->drag)
        return TIA_OK;
    if (!v->hooks.control)
        return TIA_OK;
    if (is_own(loop, event->key) && event->key == TIA_KEY_SPACE) {
        pause(loop);
        return TIA_OK;
    }
    if (is_own(loop, event->key) && choose_light(loop))
        return TIA_OK;
    return act(loop, event);
}

static int32_t at_most(int32_t step)
{
    return step > INT16_MAX ? INT16_MAX : step < -INT16_MAX ? -INT16_MAX : step;
}

static bool are_alike(const struct tia_event *a, const struct tia_event *b)
{
    return a->kind == b->kind && a->drag == b->drag;
}

/* Merges pointer events. A pointer reports every step, so the last of the queued events is enough. A drag from one
 * position to another also needs the first, which may be the start of the drag. */
bool tia_viewer_joins(struct loop *loop, const struct tia_event *event)
{
    unsigned n = loop->queued, first = event->kind == TIA_EVENT_POINT && event->drag ? 2 : 1;
    struct tia_event *last = n ? &loop->queue[n - 1] : NULL;

    if (n < first || !is_pointer(event) || !are_alike(last, event) || !are_alike(&loop->queue[n - first], event))
        return false;
    if (event->kind == TIA_EVENT_MOVE) {
        last->x = at_most(last->x + event->x);
        last->y = at_most(last->y + event->y);
    } else {
        last->x = event->x;
        last->y = event->y;
    }
    return true;
}
