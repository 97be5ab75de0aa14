/* ps2.h - the bytes of a PS/2 keyboard, scan code set 2, as key events.
 *
 * A key sends its code when it goes down (and again and again while it is held), F0 and its code
 * when it comes up. Keys younger than the PC/XT have E0 in front of both. Pause sends eight
 * bytes that begin with E1, all at its press. Nothing here touches a device.
 */
#ifndef PORT_PS2_H
#define PORT_PS2_H

#include <tia/port.h>

#define PS2_ENABLE 0xf4u      /* to the keyboard: start telling keys */
#define PS2_ACKNOWLEDGE 0xfau /* from the keyboard: the command was taken */
#define PS2_CODES 0x88        /* codes are 01..84; rounded up to whole bytes of bits */

/* All zero: no key is held. */
struct ps2 {
    uint8_t held[2][PS2_CODES / 8]; /* a bit for each code: [0] plain, [1] behind E0 */
    bool extended, released;        /* E0 or F0 came, its code did not yet */
    uint8_t pause;                  /* bytes of Pause still to come */
    bool forget;                    /* plugged in anew, or bytes were lost: what was held may be up */
};

/* Takes a byte: 1 and *event (without a time), or 0 when it tells no event: a modifier or lock
 * key, a key that is held already, a part of a sequence, an answer to a command. */
int ps2_feed(struct ps2 *ps2, uint8_t byte, struct tia_event *event);

/* After each byte, until it returns 0: the releases that a keyboard plugged in anew, or too slowly read, owes. */
int ps2_owed(struct ps2 *ps2, struct tia_event *event);

#endif
