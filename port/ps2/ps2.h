/* ps2.h - decodes the bytes of a PS/2 keyboard, scan code set 2, into key events. Touches no device.
 *
 * A key sends its code when it goes down (and repeatedly while it is held), and F0 and its code when it comes up.
 * Keys that the PC/XT did not have put E0 before both. Pause sends eight bytes, starting with E1, when pressed, and
 * nothing when released.
 */
#ifndef PORT_PS2_H
#define PORT_PS2_H

#include <tia/port.h>

#define TIA_PS2_ENABLE 0xf4u      /* to the keyboard: start scanning */
#define TIA_PS2_ACKNOWLEDGE 0xfau /* from the keyboard: command accepted */
#define TIA_PS2_CODES 0x88        /* codes are 01..84 (hex), rounded up to whole bytes of bits */

/* All zero: no key is held. */
struct tia_ps2 {
    uint8_t held[2][TIA_PS2_CODES / 8]; /* a bit per code: [0] plain, [1] after E0 */
    bool extended, released;            /* E0 or F0 was received, its code not yet */
    uint8_t pause;                      /* bytes of Pause left */
    bool forget;                        /* replugged, or bytes were lost: release all held keys */
};

/* Decodes a byte: 1 and *event (without a time), or 0 when there is no event: for a modifier or lock key, a key that is
 * held already, a part of a sequence, or the answer to a command. */
int tia_ps2_feed(struct tia_ps2 *ps2, uint8_t byte, struct tia_event *event);

/* Call after each byte until it returns 0. Releases the held keys after the keyboard was replugged or bytes were lost,
 * since their release codes will not come. */
int tia_ps2_owed(struct tia_ps2 *ps2, struct tia_event *event);

#endif
