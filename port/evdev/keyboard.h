/* keyboard.h - one keyboard: an event device of the kernel.
 *
 * Grabbing a keyboard (EVIOCGRAB) hides it from the console. The console would miss the releases of keys that are down
 * at that moment: Alt would stay down, or Enter repeat. So before the grab, releases of these keys are written to the
 * device, while the console still gets its events; after the grab, presses of the same keys are written. The kernel
 * treats written events like the device's own.
 */
#ifndef PORT_EVDEV_KEYBOARD_H
#define PORT_EVDEV_KEYBOARD_H

#include "device.h"
#include "key_codes.h"

#define KEYBOARD_EVENTS 64

struct keyboard {
    int fd; /* -1: none */
    char path[256];
    bool grabbed, unplugged;
    bool dropped; /* the kernel lost events: ignore the rest up to SYN_REPORT */
    struct key_state state;
    struct input_event events[KEYBOARD_EVENTS];
    size_t next, count; /* unread part of the events: [next, count) */
};

/* Opens a keyboard. Returns TIA_OK or, with the reason in `why`, TIA_ERR_UNSUPPORTED when the node is not a keyboard,
 * and TIA_ERR_DEVICE when it cannot be used (another program may have grabbed it). Keys that are down now give no
 * events, not even a release. */
int keyboard_open(struct keyboard *keyboard, const char *path, char why[PORT_WHY]);
void keyboard_close(struct keyboard *keyboard);

/* Grabs the keyboard: the console gets the releases of all keys, and this program begins with no key pressed
 * (key_state_begin). */
void keyboard_grab(struct keyboard *keyboard);
/* Ends the grab: the console then has no key pressed except the modifiers that are down. */
void keyboard_release(struct keyboard *keyboard);

/* True if a key that types or a modifier is down. */
bool keyboard_is_pressed(const struct keyboard *keyboard);

/* Reads the pending events. If the keyboard was unplugged, all its keys count as up. */
void keyboard_read(struct keyboard *keyboard);

/* Returns the time of the next event in microseconds; UINT64_MAX: there is none. */
uint64_t keyboard_next_us(const struct keyboard *keyboard);

/* Takes the next event; true if *change is to be reported, false if not, or if there is no event. */
bool keyboard_take(struct keyboard *keyboard, struct key_modifiers modifiers, struct key_change *change);

/* Discards keys that were typed for another program. */
void keyboard_discard(struct keyboard *keyboard);

#endif
