/* ps2.h - decodes the bytes of a PS/2 keyboard, scan code set 2, into key events. Touches no device.
 *
 * A key sends its code when it goes down (and repeatedly while it is held), and F0 and its code when it comes up. For
 * keys that the PC/XT lacked, E0 precedes each of these. Pause sends eight bytes, starting with E1, when pressed, and
 * nothing when released.
 */
#ifndef PORT_PS2_H
#define PORT_PS2_H

#include <tia/port.h>

#define TIA_PS2_ENABLE 0xf4u      /* command to the keyboard: start scanning */
#define TIA_PS2_ACKNOWLEDGE 0xfau /* answer of the keyboard: command accepted */
#define TIA_PS2_CODES 0x88        /* number of codes: 01..84 (hex), rounded up to a multiple of 8 */

/* State of a decoder. All zero: no key is held. */
struct tia_ps2 {
    uint8_t held[2][TIA_PS2_CODES / 8]; /* a bit per code: [0] plain, [1] after E0 */
    bool extended, released;            /* E0 or F0 was received, but not yet the code after it */
    uint8_t pause;                      /* number of bytes of Pause still to come */
    bool forget;                        /* replugged, or bytes were lost: all held keys are to be released */
};

/* Decodes a byte; returns 1 and *event (without a time), or 0 when there is no event: for a modifier or lock key, a key
 * that is held already, a part of a sequence, or the answer to a command. */
int tia_ps2_feed(struct tia_ps2 *ps2, uint8_t byte, struct tia_event *event);

/* Gives the releases of held keys after the keyboard was replugged or bytes were lost, since their release codes will
 * not come. Call it after each byte until it returns 0. */
int tia_ps2_owed(struct tia_ps2 *ps2, struct tia_event *event);

#endif
