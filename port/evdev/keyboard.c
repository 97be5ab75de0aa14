/* keyboard.c - an event device of the kernel. */
#include "keyboard.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include "console/guardian.h"
#include "console/node.h"

static bool get_pressed(const struct keyboard *keyboard, struct key_set *down)
{
    *down = (struct key_set){{0}};
    return ioctl(keyboard->fd, EVIOCGKEY(sizeof down->words), down->words) >= 0;
}

static int failed(const char *path, int error, char why[PORT_WHY])
{
    char text[PORT_WHY];

    (void)snprintf(why, PORT_WHY, "%.80s: %s", path,
                   error == EBUSY ? "another program has grabbed it" : node_error(error, text));
    return TIA_ERR_DEVICE;
}

/* Checks that the device is a keyboard that no other program has grabbed, and sets its clock to CLOCK_MONOTONIC. */
static int examine(const struct keyboard *keyboard, char why[PORT_WHY])
{
    int fd = keyboard->fd, clock = CLOCK_MONOTONIC;
    struct key_set codes = {{0}};

    if (ioctl(fd, EVIOCGBIT(EV_KEY, sizeof codes.words), codes.words) < 0 || !key_set_types(&codes)) {
        (void)snprintf(why, PORT_WHY, "%.80s: is not a keyboard", keyboard->path);
        return TIA_ERR_UNSUPPORTED;
    }
    if (ioctl(fd, EVIOCGRAB, 1) != 0 || ioctl(fd, EVIOCGRAB, 0) != 0 || ioctl(fd, EVIOCSCLOCKID, &clock) != 0)
        return failed(keyboard->path, errno, why);
    return TIA_OK;
}

/* Restricts the events to keys. The kernel queues 64 events while the program is busy drawing: scan codes (EV_MSC)
 * would take a third of the queue, and a keyboard's touchpad far more. Kernels before 4.4 have no masks. */
static void want_keys_only(const struct keyboard *keyboard)
{
    const unsigned long types = 1ul << EV_KEY;
    struct input_mask mask = {.type = EV_SYN, .codes_size = sizeof types, .codes_ptr = (uintptr_t)&types};

    (void)ioctl(keyboard->fd, EVIOCSMASK, &mask);
}

int keyboard_open(struct keyboard *keyboard, const char *path, char why[PORT_WHY])
{
    struct key_set down;
    int status;

    *keyboard = (struct keyboard){.fd = node_open(path, O_RDWR | O_NONBLOCK, why)};
    if (keyboard->fd < 0)
        return TIA_ERR_DEVICE;
    (void)snprintf(keyboard->path, sizeof keyboard->path, "%s", path);
    status = examine(keyboard, why);
    if (status) {
        keyboard_close(keyboard);
        return status;
    }
    want_keys_only(keyboard);
    (void)get_pressed(keyboard, &down);
    key_state_begin(&keyboard->state, &down);
    return TIA_OK;
}

void keyboard_close(struct keyboard *keyboard)
{
    if (keyboard->fd >= 0)
        (void)close(keyboard->fd);
    keyboard->fd = -1;
}

/* Selects keys of a set: all, the modifiers, or the others. */
enum which { ALL, MODIFIERS, OTHERS };

static bool is_meant(enum which which, unsigned code)
{
    return which == ALL || key_is_modifier(code) == (which == MODIFIERS);
}

/* Writes events for the selected keys of a set: for each key one event per value from `first` to `last` (0: release, 1:
 * press). Writes all of them at once, so that a key is unlikely to change meanwhile. If the write fails, the device is
 * unplugged, which the next read detects. */
static void write_keys(const struct keyboard *keyboard, const struct key_set *set, enum which which, int first,
                       int last)
{
    struct input_event events[KEYBOARD_EVENTS];
    size_t count = 0;

    for (unsigned code = 0; code < KEY_CNT && count + 4 <= KEYBOARD_EVENTS; code++)
        for (int value = first; key_set_has(set, code) && is_meant(which, code) && value <= last; value++) {
            events[count++] = (struct input_event){.type = EV_KEY, .code = (uint16_t)code, .value = value};
            events[count++] = (struct input_event){.type = EV_SYN, .code = SYN_REPORT};
        }
    if (count > 0 && write(keyboard->fd, events, count * sizeof events[0]) < 0)
        return;
}

static bool is_subset(const struct key_set *part, const struct key_set *whole)
{
    for (size_t i = 0; i < KEY_WORDS; i++)
        if (part->words[i] & ~whole->words[i])
            return false;
    return true;
}

/* Empties the event buffer, and initialises the key state with the keys that are down. EVIOCGKEY also removes all key
 * events from the kernel's queue, including those of write_keys. */
static void begin(struct keyboard *keyboard)
{
    struct key_set down;

    (void)get_pressed(keyboard, &down);
    keyboard->next = keyboard->count = 0;
    keyboard->dropped = false;
    key_state_begin(&keyboard->state, &down);
}

/* Grabs the keyboard; false when a key went down between the query and the grab: the console got the press and would
 * miss the release. */
static bool try_grab(struct keyboard *keyboard)
{
    struct key_set before, after;

    if (!get_pressed(keyboard, &before))
        return true;
    write_keys(keyboard, &before, ALL, 0, 0);
    keyboard->grabbed = ioctl(keyboard->fd, EVIOCGRAB, 1) == 0;
    if (!keyboard->grabbed)
        return true;
    (void)guardian_keep_keyboard(keyboard->fd);
    write_keys(keyboard, &before, ALL, 1, 1);
    return !get_pressed(keyboard, &after) || is_subset(&after, &before);
}

/* Tries three times: nobody types fast enough to spoil all three. */
void keyboard_grab(struct keyboard *keyboard)
{
    if (keyboard->grabbed || keyboard->unplugged)
        return;
    for (int tries = 1; !try_grab(keyboard) && tries < 3; tries++)
        (void)ioctl(keyboard->fd, EVIOCGRAB, 0);
    begin(keyboard);
}

/* Releases the grab and forwards the state of the modifiers to the console, so that Ctrl-Alt-F2 and then F1 works while
 * Ctrl and Alt stay down. Other keys, such as F2, are not forwarded: the console would take them as typed. */
void keyboard_release(struct keyboard *keyboard)
{
    struct key_set down;

    if (keyboard->unplugged)
        return;
    if (keyboard->grabbed && get_pressed(keyboard, &down)) {
        write_keys(keyboard, &down, OTHERS, 0, 0);
        (void)ioctl(keyboard->fd, EVIOCGRAB, 0);
        (void)get_pressed(keyboard, &down);
        write_keys(keyboard, &down, MODIFIERS, 0, 1);
    }
    keyboard->grabbed = false;
    guardian_forget_keyboard(keyboard->fd);
    begin(keyboard);
}

bool keyboard_is_pressed(const struct keyboard *keyboard)
{
    struct key_set down;

    if (keyboard->unplugged || !get_pressed(keyboard, &down))
        return false;
    for (unsigned code = 0; code < KEY_CNT; code++)
        if (key_set_has(&down, code) && (key_at(code) != 0 || key_is_modifier(code)))
            return true;
    return false;
}

static void unplug(struct keyboard *keyboard)
{
    keyboard->unplugged = true;
    keyboard->grabbed = false;
    guardian_forget_keyboard(keyboard->fd);
    key_state_begin(&keyboard->state, &(struct key_set){{0}});
}

void keyboard_read(struct keyboard *keyboard)
{
    ssize_t n;

    if (keyboard->unplugged || keyboard->next < keyboard->count)
        return;
    n = read(keyboard->fd, keyboard->events, sizeof keyboard->events);
    keyboard->next = 0;
    keyboard->count = n > 0 ? (size_t)n / sizeof keyboard->events[0] : 0;
    if (n < 0 && errno != EAGAIN && errno != EINTR)
        unplug(keyboard);
}

uint64_t keyboard_next_us(const struct keyboard *keyboard)
{
    const struct input_event *e = &keyboard->events[keyboard->next];

    if (keyboard->next == keyboard->count)
        return UINT64_MAX;
    return (uint64_t)e->input_event_sec * 1000000u + (uint64_t)e->input_event_usec;
}

/* Handles SYN_DROPPED (Documentation/input/event-codes.rst): ignores events up to SYN_REPORT, then queries the state.
 * Later events are processed as usual: an event that agrees with the state changes nothing. */
static void synchronise(struct keyboard *keyboard, const struct input_event *e)
{
    struct key_set down;

    if (e->code == SYN_DROPPED) {
        keyboard->dropped = true;
    } else if (e->code == SYN_REPORT && keyboard->dropped) {
        keyboard->dropped = false;
        if (get_pressed(keyboard, &down))
            key_state_lost(&keyboard->state, &down);
    }
}

bool keyboard_take(struct keyboard *keyboard, struct key_modifiers modifiers, struct key_change *change)
{
    const struct input_event *e = &keyboard->events[keyboard->next];

    if (keyboard->next == keyboard->count)
        return false;
    keyboard->next++;
    if (e->type == EV_SYN)
        synchronise(keyboard, e);
    return e->type == EV_KEY && !keyboard->dropped &&
           key_state_take(&keyboard->state, e->code, e->value, modifiers, change);
}

void keyboard_discard(struct keyboard *keyboard)
{
    do {
        keyboard->next = keyboard->count;
        keyboard_read(keyboard);
    } while (keyboard->next < keyboard->count);
}
