/* keyboard.h - one keyboard: an event device of the kernel.
 *
 * Taking a keyboard (EVIOCGRAB) hides it from the console below. The kernel does not tell the
 * console about keys that are down at that moment: it would wait for their releases for ever,
 * with Alt stuck or Enter repeating. So a keyboard changes hands with all its keys up: releases
 * are written to the device (write to an event device and the kernel takes it for its keyboard's)
 * while the old hands still see them, and what is really down is pressed again in the new ones.
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
    bool dropped; /* the kernel lost events: the rest up to SYN_REPORT is in pieces */
    struct key_state state;
    struct input_event events[KEYBOARD_EVENTS];
    size_t next, count; /* read and not yet taken: [next, count) */
};

/* TIA_ERR_UNSUPPORTED when the node is no keyboard, TIA_ERR_DEVICE when it cannot be used (another
 * program may have grabbed it); then `why` tells. Keys that are down now are told neither now nor
 * when they come up. */
int keyboard_open(struct keyboard *keyboard, const char *path, char why[PORT_WHY]);
void keyboard_close(struct keyboard *keyboard);

/* Hides the keyboard from everybody else, and gives it back. Either way the keys that are down are
 * over for their old hands, and nothing for the new ones (key_state_begin). */
void keyboard_grab(struct keyboard *keyboard);
void keyboard_release(struct keyboard *keyboard);

/* Is a key down that types, or a modifier? */
bool keyboard_is_pressed(const struct keyboard *keyboard);

/* Reads what is there. An unplugged keyboard has all keys up. */
void keyboard_read(struct keyboard *keyboard);

/* When the next event happened, in microseconds; UINT64_MAX: there is none. */
uint64_t keyboard_next_us(const struct keyboard *keyboard);

/* Takes the next event: true and what it means, or false. */
bool keyboard_take(struct keyboard *keyboard, struct key_modifiers modifiers, struct key_change *change);

/* Throws away what was typed for somebody else. */
void keyboard_discard(struct keyboard *keyboard);

#endif
