/* keyboard.h - one keyboard: an event device of the kernel.
 *
 * Grabbing a keyboard (EVIOCGRAB) hides it from the console, which never sees the releases of keys that are down at
 * that moment: Alt would stay down for it, or Enter repeat. So all keys are released first, while the console still
 * sees it, and those that are really down are pressed again afterwards. Both are done by writing events to the device,
 * which the kernel treats like its own.
 */
#ifndef PORT_EVDEV_KEYBOARD_H
#define PORT_EVDEV_KEYBOARD_H

#include "device.h"
#include "keys.h"

#define KEYBOARD_EVENTS 64

struct keyboard {
    int fd; /* -1: none */
    char path[256];
    bool grabbed, unplugged;
    bool dropped; /* the kernel lost events: ignore the rest up to SYN_REPORT */
    struct key_state state;
    struct input_event events[KEYBOARD_EVENTS];
    size_t next, count; /* read and not yet taken: [next, count) */
};

/* TIA_ERR_UNSUPPORTED when the node is no keyboard, TIA_ERR_DEVICE when it cannot be used (another
 * program may have grabbed it); then `why` says so. Keys that are down now give no events, not even
 * a release. */
int keyboard_open(struct keyboard *keyboard, const char *path, char why[PORT_WHY]);
void keyboard_close(struct keyboard *keyboard);

/* Grabs the keyboard, and releases it. Either way the previous owner sees all keys released, and the next one sees none
 * pressed (key_state_begin). */
void keyboard_grab(struct keyboard *keyboard);
void keyboard_release(struct keyboard *keyboard);

/* Is a key down, one that types or a modifier? */
bool keyboard_is_pressed(const struct keyboard *keyboard);

/* Reads the events that are there. An unplugged keyboard has no key down. */
void keyboard_read(struct keyboard *keyboard);

/* When the next event happened, in microseconds; UINT64_MAX: there is none. */
uint64_t keyboard_next_us(const struct keyboard *keyboard);

/* Takes the next event. True: it is a change to report; false: it is not, or there is no event. */
bool keyboard_take(struct keyboard *keyboard, struct key_modifiers modifiers, struct key_change *change);

/* Throws away what was typed for somebody else. */
void keyboard_discard(struct keyboard *keyboard);

#endif
