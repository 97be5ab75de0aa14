/* key_decoder.h - turns the bytes that a terminal sends into keys. Uses no clock and no device.
 *
 * Reports of the mouse are those of xterm's SGR mode (CSI < button ; column ; row M or m).
 *
 * Keys are positions, as in evdev: 'A', Ctrl-A and Alt-A are all the key 'a', but Ctrl-C and Ctrl-Z are their own.
 * Bytes that a terminal sends by itself (reports, focus changes, a bracketed paste) are not keys.
 */
#ifndef PORT_TERMINAL_KEY_DECODER_H
#define PORT_TERMINAL_KEY_DECODER_H

#include <stdbool.h>
#include <stdint.h>

/* Result of decode_byte for a report of the mouse. */
#define DECODED_POINTER 0xffffu
/* Result of decode_byte for Ctrl-Z, by which terminals stop programs. */
#define DECODED_STOP 0xfffeu

struct decoder {
    uint8_t state;        /* 0: between keys */
    uint8_t skip;         /* bytes of a UTF-8 character still to come */
    uint8_t private_mark; /* mark after CSI: '<' '=' '>' '?' or 0 */
    uint16_t number;      /* the CSI sequence's first parameter */
    uint16_t more[2];     /* second and third parameter; 0: not given */
    uint8_t parameters;   /* number of complete parameters, 3 at most */
    bool more_parameters;
    bool shift;           /* the last key was typed with Shift or Ctrl, as far as the terminal reports it */
    bool drag;            /* the mouse's left button was down in its last report */
    uint16_t column, row; /* position in the mouse's last report, from 1 */
    bool in_paste;
};

/* Processes one byte; returns the key that it completes (tia/port.h), DECODED_POINTER, DECODED_STOP or 0. */
uint16_t decode_byte(struct decoder *decoder, uint8_t byte);

/* True if a sequence has begun and not ended: a pause may end it, see decode_silence. */
bool decode_pending(const struct decoder *decoder);

/* Ends a sequence after a pause without bytes; returns the key that the sequence then means, or 0. */
uint16_t decode_silence(struct decoder *decoder);

#endif
