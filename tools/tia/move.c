#include "move.h"

#include <stdio.h>
#include <string.h>
#include <tia/orbit.h>

#include "clock.h"
#include "save.h"

#define STEP TIA_Q16(5)       /* degrees, of a key that orbits */
#define PIXEL_STEP TIA_Q16(1) /* and of four pixels of a mouse */
#define TURN 180              /* degrees, of a pointer that goes through the whole picture */
#define TOLD_US 4000000

static const char help[] = "arrows, page up, page down: move the light\n"
                           "a scene's own keys: put lights; tab: next light\n"
                           "shift and these: move the eye\n"
                           "h j k l, or drag the mouse: orbit\n"
                           "+ -: zoom   home: back\n"
                           "n p: next, previous scene\n"
                           "v: next view   t: shadows\n"
                           "space: pause   c: save a picture\n"
                           "q, escape: quit   ?: no help";

/* ---- what events mean ---- */

static bool is_pointer(const struct tia_event *event)
{
    return event->kind == TIA_EVENT_POINT || event->kind == TIA_EVENT_MOVE;
}

static bool is_arrow(uint16_t key)
{
    return key >= TIA_KEY_LEFT && key <= TIA_KEY_PAGE_DOWN;
}

static bool views_are_there(const struct options *options)
{
    return options->plain_core == &tia_core_q16 && !options->scene.integration.integrator;
}

static bool ends(const struct options *options, uint16_t key)
{
    if (key == 'n' || key == 'p')
        return options->scene_count > 1;
    return key == 'q' || key == TIA_KEY_ESCAPE || key == TIA_KEY_INTERRUPT || (key == 'v' && views_are_there(options));
}

static bool is_for_camera(const struct tia_event *event)
{
    uint16_t key = event->key;

    return (is_arrow(key) && event->shift) || key == 'h' || key == 'j' || key == 'k' || key == 'l' ||
           key == TIA_KEY_PLUS || key == TIA_KEY_MINUS;
}

/* A picture is saved when it is complete, so that key interrupts nothing. */
static enum tia_effect weigh(void *ctx, const struct tia_event *event)
{
    const struct moves *moves = ctx;

    if (event->kind == TIA_EVENT_RELEASE)
        return TIA_EFFECT_NONE;
    if (is_pointer(event))
        return event->drag ? TIA_EFFECT_CAMERA : TIA_EFFECT_NONE;
    if (ends(moves->options, event->key))
        return TIA_EFFECT_END;
    if (event->key == TIA_KEY_HOME)
        return TIA_EFFECT_HOME;
    if (is_for_camera(event))
        return TIA_EFFECT_CAMERA;
    return event->key == TIA_KEY_HELP ? TIA_EFFECT_PICTURE : TIA_EFFECT_NONE;
}

/* ---- what they do ---- */

void moves_say(struct moves *moves, const char *text)
{
    (void)snprintf(moves->message, sizeof moves->message, "%s", text);
    moves->until_us = clock_now_us() + TOLD_US;
}

static void save(struct moves *moves)
{
    char text[PORT_WHY];

    save_numbered(moves->letterbox, &moves->saved, text);
    moves_say(moves, text);
    moves->saves = false;
}

static void orbit(const struct moves *moves, struct tia_camera *camera, tia_q16 right, tia_q16 up)
{
    tia_camera_aim(camera, &moves->options->scene);
    tia_camera_orbit(camera, right, up);
}

/* The scene follows the hand, so the eye goes the other way. */
static enum tia_effect point(struct moves *moves, const struct tia_event *event, struct tia_camera *camera)
{
    int32_t x = event->x * (PIXEL_STEP / 4), y = event->y * (PIXEL_STEP / 4);
    bool begins = event->kind == TIA_EVENT_POINT && !moves->has_place;

    if (event->kind == TIA_EVENT_POINT) {
        x = (event->x - moves->x) * TURN;
        y = (event->y - moves->y) * TURN;
        moves->x = event->x;
        moves->y = event->y;
        moves->has_place = event->drag;
    }
    if (!event->drag || begins || (!x && !y))
        return TIA_EFFECT_NONE;
    orbit(moves, camera, -x % TIA_Q16(180), y % TIA_Q16(180));
    return TIA_EFFECT_CAMERA;
}

static void walk(const struct moves *moves, struct tia_camera *camera, uint16_t key)
{
    tia_camera_aim(camera, &moves->options->scene);
    tia_camera_walk(camera, (key == TIA_KEY_RIGHT) - (key == TIA_KEY_LEFT),
                    (key == TIA_KEY_PAGE_UP) - (key == TIA_KEY_PAGE_DOWN), (key == TIA_KEY_UP) - (key == TIA_KEY_DOWN));
}

static enum tia_effect move_camera(struct moves *moves, uint16_t key, struct tia_camera *camera)
{
    if (is_arrow(key))
        walk(moves, camera, key);
    else if (key == TIA_KEY_PLUS || key == TIA_KEY_MINUS)
        tia_camera_zoom(camera, key == TIA_KEY_PLUS);
    else
        orbit(moves, camera, ((key == 'l') - (key == 'h')) * STEP, ((key == 'k') - (key == 'j')) * STEP);
    return TIA_EFFECT_CAMERA;
}

/* The loop tells of these only where there is no light to move. */
static void say_no_light(struct moves *moves)
{
    const struct tia_scene *scene = &moves->options->scene;
    char text[PORT_WHY] = "this scene has no light to move", *at = text + strlen(text);

    for (uint32_t i = 0; i < scene->binding_count && at < text + 80; i++) {
        uint16_t key = scene->bindings[i].key;
        at += snprintf(at, 4, "%s%c", i ? " " : ": ", key > ' ' && key < 127 ? key : '?');
        if (i + 1 == scene->binding_count || at >= text + 80)
            (void)snprintf(at, 16, " put one");
    }
    moves_say(moves, text);
}

static enum tia_effect tell(struct moves *moves, uint16_t key)
{
    if (key == TIA_KEY_HELP)
        moves->help = !moves->help;
    else if (key == 'v')
        moves_say(moves, "false colours: not of this integrator or arithmetic");
    else if (key == 'n' || key == 'p')
        moves_say(moves, "there is one scene (tia SCENE SCENE ...)");
    else if (key == TIA_KEY_TAB || is_arrow(key))
        say_no_light(moves);
    else
        return TIA_EFFECT_NONE;
    return TIA_EFFECT_PICTURE;
}

static enum tia_effect act(void *ctx, const struct tia_event *event, struct tia_camera *camera)
{
    struct moves *moves = ctx;
    uint16_t key = event->key;

    if (is_pointer(event))
        return point(moves, event, camera);
    switch (weigh(moves, event)) {
    case TIA_EFFECT_END:
        moves->to = key == 'n'   ? MOVE_NEXT_SCENE
                    : key == 'p' ? MOVE_PREVIOUS_SCENE
                    : key == 'v' ? MOVE_NEXT_VIEW
                                 : MOVE_NOWHERE;
        return TIA_EFFECT_END;
    case TIA_EFFECT_HOME:
        return TIA_EFFECT_HOME;
    case TIA_EFFECT_CAMERA:
        return move_camera(moves, key, camera);
    default:
        break;
    }
    if (key != 'c')
        return tell(moves, key);
    moves->saves = true;
    if (moves->shown)
        save(moves);
    return TIA_EFFECT_PICTURE;
}

const struct tia_control moves_control = {weigh, act};

void moves_shown(struct moves *moves, const struct tia_frame *frame)
{
    moves->shown = frame->block == 1;
    if (moves->shown && moves->saves)
        save(moves);
}

const char *moves_help(const struct moves *moves)
{
    return moves->help ? help : NULL;
}
