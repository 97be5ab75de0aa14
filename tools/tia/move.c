#include "move.h"

#include <stdio.h>
#include <string.h>

#include "arithmetic.h"
#include "clock.h"
#include "common/signals.h"
#include "save.h"

#define TOLD_US 4000000

static const char help[] = "arrows\tmove the light\n"
                           "page up, page down\traise, lower the light\n"
                           "a scene's own keys\tput lights\n"
                           "tab\tnext light\n"
                           "shift and these\tmove the eye\n"
                           "h j k l, drag\torbit\n"
                           "+ -\tzoom\n"
                           "home\tback to the scene's eye\n"
                           "n p\tnext, previous scene\n"
                           "v\tnext view in false colours\n"
                           "t\tnext shadow technique\n"
                           "space\tpause\n"
                           "c\tsave a picture\n"
                           "e\tprint the eye as a camera line\n"
                           "q, escape\tquit\n"
                           "?\tno help";

/* ---- meaning of events ---- */

static bool views_are_there(const struct options *options)
{
    return arithmetic_watched() && options->plain_core == &tia_core_q16 && !options->scene.integration.integrator;
}

static bool ends(const struct options *options, uint16_t key)
{
    if (key == MOVE_CHANGED)
        return true;
    if (key == 'n' || key == 'p')
        return options->scene_count > 1;
    return key == 'q' || key == TIA_KEY_ESCAPE || key == TIA_KEY_INTERRUPT || (key == 'v' && views_are_there(options));
}

static bool scrolls(uint16_t key)
{
    return key >= MOVE_LINE_UP && key <= MOVE_PAGE_DOWN;
}

uint16_t moves_scroll_key(const struct moves *moves, uint16_t key)
{
    if (!moves->help || !moves->text || !moves->text->more)
        return key;
    return key == TIA_KEY_UP          ? MOVE_LINE_UP
           : key == TIA_KEY_DOWN      ? MOVE_LINE_DOWN
           : key == TIA_KEY_PAGE_UP   ? MOVE_PAGE_UP
           : key == TIA_KEY_PAGE_DOWN ? MOVE_PAGE_DOWN
                                      : key;
}

/* Returns the effect of an event. The key that saves has none, since only complete pictures are saved. */
enum tia_effect moves_weigh(const struct moves *moves, const struct tia_event *event)
{
    if (event->kind == TIA_EVENT_RELEASE)
        return TIA_EFFECT_NONE;
    if (steer_points(event))
        return event->drag ? TIA_EFFECT_CAMERA : TIA_EFFECT_NONE;
    if (ends(moves->options, event->key))
        return TIA_EFFECT_END;
    if (scrolls(event->key))
        return TIA_EFFECT_PICTURE;
    if (event->key == TIA_KEY_HOME)
        return TIA_EFFECT_HOME;
    if (steer_takes(event))
        return TIA_EFFECT_CAMERA;
    return event->key == TIA_KEY_HELP ? TIA_EFFECT_PICTURE : TIA_EFFECT_NONE;
}

/* ---- actions ---- */

void moves_say(struct moves *moves, const char *text)
{
    (void)snprintf(moves->message, sizeof moves->message, "%.*s", PORT_WHY - 1, text);
    moves->until_us = clock_now_us() + TOLD_US;
}

static void save(struct moves *moves)
{
    char text[PORT_WHY];

    (void)save_numbered(moves->letterbox, &moves->saved, text);
    moves_say(moves, text);
    moves->saves = false;
}

static void save_soon(struct moves *moves)
{
    moves->saves = true;
    if (moves->viewer->incomplete)
        moves_say(moves, "saved when the picture is complete");
    else
        save(moves);
}

/* Shows the message that there is no light; the viewer passes keys for lights only if there is no light to move. */
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

/* Scrolls the help; the display lowers the number of the first line if there are not so many. */
static void scroll(struct moves *moves, uint16_t key)
{
    bool page = key == MOVE_PAGE_UP || key == MOVE_PAGE_DOWN, down = key == MOVE_LINE_DOWN || key == MOVE_PAGE_DOWN;
    unsigned step = page ? 8 : 1, *first = &moves->text->first;

    *first = down ? *first + step : *first > step ? *first - step : 0;
}

static enum tia_effect tell(struct moves *moves, uint16_t key)
{
    if (key == TIA_KEY_HELP) {
        moves->help = !moves->help;
        moves->text->first = 0;
    } else if (scrolls(key))
        scroll(moves, key);
    else if (key == 'v')
        moves_say(moves, arithmetic_watched() ? "false colours: not of this integrator or arithmetic"
                                              : "false colours: not built in (make builds them)");
    else if (key == 'n' || key == 'p')
        moves_say(moves, "there is one scene (tia SCENE SCENE ...)");
    else if (key == TIA_KEY_TAB || steer_is_arrow(key))
        say_no_light(moves);
    else
        return TIA_EFFECT_NONE;
    return TIA_EFFECT_PICTURE;
}

enum tia_effect moves_act(struct moves *moves, const struct tia_event *event, struct tia_camera *camera)
{
    uint16_t key = event->key;

    if (steer_points(event))
        return steer(&moves->steer, &moves->options->scene, event, camera);
    switch (moves_weigh(moves, event)) {
    case TIA_EFFECT_END:
        moves->to = key == 'n'            ? MOVE_NEXT_SCENE
                    : key == 'p'          ? MOVE_PREVIOUS_SCENE
                    : key == 'v'          ? MOVE_NEXT_VIEW
                    : key == MOVE_CHANGED ? MOVE_READ_AGAIN
                                          : MOVE_NOWHERE;
        return TIA_EFFECT_END;
    case TIA_EFFECT_HOME:
        return TIA_EFFECT_HOME;
    case TIA_EFFECT_CAMERA:
        return steer(&moves->steer, &moves->options->scene, event, camera);
    default:
        break;
    }
    if (key == 'e') {
        camera_line(moves->line, camera, &moves->options->file.placement);
        moves_say(moves, moves->line);
        return TIA_EFFECT_PICTURE;
    }
    if (key != 'c')
        return tell(moves, key);
    save_soon(moves);
    return TIA_EFFECT_PICTURE;
}

void moves_shown(struct moves *moves, const struct tia_frame *frame)
{
    if (frame->block == 1 && moves->saves)
        save(moves);
}

bool moves_finish(struct moves *moves, char text[PORT_WHY])
{
    bool waits = moves->saves;

    moves->saves = false;
    if (waits && signals_asked(NULL))
        (void)snprintf(text, PORT_WHY, "nothing saved: a signal came before the picture was complete");
    else if (waits && !moves->letterbox->shown)
        (void)snprintf(text, PORT_WHY, "nothing saved: there was no picture yet");
    else if (waits && !save_numbered(moves->letterbox, &moves->saved, text))
        (void)snprintf(text + strlen(text), PORT_WHY - strlen(text), ", which is not complete");
    return waits;
}

const char *moves_help(const struct moves *moves)
{
    return moves->help ? help : NULL;
}
