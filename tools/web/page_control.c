/* page_control.c - control of the session by keys and the pointer, except for lights (light_control.c), and its
 * input. */
#include "page.h"

/* ---- control ---- */

static enum tia_effect weigh(void *ctx, const struct tia_event *event)
{
    (void)ctx;
    if (event->kind == TIA_EVENT_RELEASE)
        return TIA_EFFECT_NONE;
    if (steer_points(event))
        return event->drag ? TIA_EFFECT_CAMERA : TIA_EFFECT_NONE;
    if (event->key == TIA_KEY_ESCAPE)
        return TIA_EFFECT_END;
    if (event->key == TIA_KEY_HOME)
        return TIA_EFFECT_HOME;
    return steer_takes(event) ? TIA_EFFECT_CAMERA : TIA_EFFECT_NONE;
}

static enum tia_effect act(void *ctx, const struct tia_event *event, struct tia_camera *camera)
{
    enum tia_effect effect = weigh(ctx, event);

    if (steer_points(event)) {
        session.pointer_x = event->x;
        session.pointer_y = event->y;
        session.rays_due = session.settings.rays;
    }
    return effect == TIA_EFFECT_CAMERA || steer_points(event) ? steer(&session.steer, &session.variant, event, camera)
                                                              : effect;
}

const struct tia_control session_control = {weigh, act};

/* ---- input ---- */

static int input_open(void *ctx)
{
    return web_input.open(ctx);
}

static int input_poll(void *ctx, struct tia_event *event)
{
    int status = web_input.poll(ctx, event);

    while (status > 0 && event->kind == TIA_EVENT_POINT && event->key == WEB_DRAGGED) {
        if (light_drag(event->x, event->y)) {
            *event = (struct tia_event){.kind = TIA_EVENT_TAP, .key = WEB_DRAGGED, .time_us = event->time_us};
            break;
        }
        status = web_input.poll(ctx, event);
    }
    session.polled = session.polled || status > 0;
    return status;
}

static void show_rays(void)
{
    static struct web_line out[512];
    const struct line *lines;
    unsigned count, x = (unsigned)((uint64_t)session.pointer_x * session.screen.width >> 16),
                    y = (unsigned)((uint64_t)session.pointer_y * session.screen.height >> 16);

    session.rays_due = false;
    if (seat.base == &difference_core || session.pointer_x < 0 || session.pointer_y < 0 ||
        views_point(seat.view, x, y, &lines, &count))
        return;
    for (unsigned i = 0; i < count && i < sizeof out / sizeof out[0]; i++)
        out[i] = (struct web_line){{{(float)lines[i].ends[0][0], (float)lines[i].ends[0][1]},
                                    {(float)lines[i].ends[1][0], (float)lines[i].ends[1][1]}},
                                   lines[i].colour};
    web_draw_lines(out, count);
}

/* True if rays are to be shown and the core observes rays, see seat_core. */
static bool has_rays(void)
{
    return session.rays_due && seat.view && session.settings.rays && session.settings.arithmetic == ARITHMETIC_Q16 &&
           session.scene.integration.integrator == TIA_WHITTED;
}

/* Draws samples until an event has been polled. */
static int input_wait(void *ctx, int timeout_ms)
{
    session.polled = false;
    if (timeout_ms != 0 && has_rays())
        show_rays();
    while (timeout_ms < 0 && samples_left() && !session.polled && !web_look()) {
        int status = samples_go_on();
        if (status)
            return status == TIA_STOPPED ? TIA_OK : status;
    }
    return session.polled ? TIA_OK : web_input.wait(ctx, timeout_ms);
}

static void input_close(void *ctx)
{
    web_input.close(ctx);
}

const struct tia_input session_input = {input_open, input_poll, input_wait, input_close};
