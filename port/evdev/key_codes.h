/* key_codes.h - turns the kernel's key events into tia's. Uses no device and no clock.
 *
 * A keyboard sends presses, repeats and releases of codes, which are positions on the keyboard. Modifiers and locks are
 * not reported as keys. Ctrl turns KEY_C into Ctrl-C, Ctrl-Alt turns F1 to F12 into console switches, and Shift is a
 * flag of other keys' events.
 */
#ifndef PORT_EVDEV_KEY_CODES_H
#define PORT_EVDEV_KEY_CODES_H

#include <limits.h>
#include <linux/input.h>

#include <tia/port.h>

/* A set of codes, laid out as EVIOCGKEY and EVIOCGBIT fill it. */
#define KEY_WORD_BITS (sizeof(unsigned long) * CHAR_BIT)
#define KEY_WORDS ((KEY_CNT + KEY_WORD_BITS - 1) / KEY_WORD_BITS)

struct key_set {
    unsigned long words[KEY_WORDS];
};

bool key_set_has(const struct key_set *set, unsigned code);
void key_set_add(struct key_set *set, unsigned code);
void key_set_remove(struct key_set *set, unsigned code);

/* Returns the key at this position (tia/port.h), or 0 for a modifier, a lock, a button or a media key. */
uint16_t key_at(unsigned code);

/* True for Ctrl, Shift, Alt and Meta, left and right. */
bool key_is_modifier(unsigned code);

/* Returns the number of the console that Ctrl-Alt and this key switch to, 1..12, or 0. */
unsigned key_console(unsigned code);

/* True if a device with these codes is a keyboard for typing: it has a letter or the space bar. */
bool key_set_types(const struct key_set *set);

/* The keys of one keyboard. All zero at first. */
struct key_state {
    struct key_set held;     /* keys that are down according to the keyboard */
    struct key_set reported; /* keys of `held` whose press was reported */
    bool interrupt;          /* C was reported as Ctrl-C */
    struct key_set ending;   /* keys of `reported` whose release is still to be reported */
    struct key_set missing;  /* keys that are down and whose press is still to be reported */
};

struct key_change {
    bool press; /* false: a release */
    uint16_t code, key;
};

/* Modifiers that are down on any keyboard. */
struct key_modifiers {
    bool ctrl, alt, shift;
};

/* Adds the modifiers of this keyboard. */
void key_state_modifiers(const struct key_state *state, struct key_modifiers *modifiers);

/* Processes an EV_KEY event; true if it is a change to report. */
bool key_state_take(struct key_state *state, unsigned code, int value, struct key_modifiers modifiers,
                    struct key_change *change);

/* Initialises the state with the keys `down`, whose presses and releases are not reported. The releases of all keys
 * that were reported as pressed become due. */
void key_state_begin(struct key_state *state, const struct key_set *down);

/* Corrects the state after events were lost: the keys `down` are pressed now. The changes that were missed become
 * due. */
void key_state_lost(struct key_state *state, const struct key_set *down);

/* Gives a change that is due after key_state_begin or key_state_lost, releases first; false if none is left. Call it
 * until it returns false, before processing more events. */
bool key_state_settle(struct key_state *state, struct key_modifiers modifiers, struct key_change *change);

#endif
