/* decode.h - turns the bytes that a terminal sends into keys. Uses no clock and no device.
 *
 * Reports of the mouse are those of xterm's SGR mode (CSI < button ; column ; row M or m).
 *
 * Keys are positions, as with evdev: 'A', Ctrl-A and Alt-A are the key 'a'. What a terminal sends by itself (reports,
 * focus changes, a bracketed paste) is not a key.
 */
#ifndef PORT_TERMINAL_DECODE_H
#define PORT_TERMINAL_DECODE_H

#include <stdbool.h>
#include <stdint.h>

/* What decode_byte returns for a report of the mouse. */
#define DECODED_POINTER 0xffffu

struct decoder {
    uint8_t state;        /* zero: between keys */
    uint8_t skip;         /* bytes of a UTF-8 character still to come */
    uint8_t private_mark; /* '<' '=' '>' '?' or 0: how the CSI sequence began */
    uint16_t number;      /* the CSI sequence's first parameter */
    uint16_t more[2];     /* and those after it; 0: there is none */
    uint8_t parameters;   /* how many have ended */
    bool more_parameters;
    bool shift;           /* the last key was typed with Shift, as far as the terminal says so */
    bool drag;            /* at the last report of the mouse its left button was down */
    uint16_t column, row; /* where that was, from 1 */
    bool in_paste;
};

/* Takes one byte; returns the key that it completes (tia/port.h), DECODED_POINTER or 0. */
uint16_t decode_byte(struct decoder *decoder, uint8_t byte);

/* Has a sequence begun that may still turn out to be a lone Escape? */
bool decode_pending(const struct decoder *decoder);

/* Call it when no more bytes came for a while; returns the key that this means, or 0. */
uint16_t decode_silence(struct decoder *decoder);

#endif
