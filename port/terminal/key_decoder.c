/* key_decoder.c - a state machine after ECMA-48 and the xterm control sequences. */
#include "key_decoder.h"

#include <stddef.h>

#include <tia/port.h>

enum { GROUND, ESCAPE, CSI, SS3, STRING, STRING_ESCAPE, LINUX_FUNCTION };

#define ESC 0x1b
#define BEL 0x07
#define DEL 0x7f
#define CTRL_Z 0x1a

/* Bits of a sequence's second parameter, less 1. Ctrl counts as Shift: xterm scrolls by Shift and page keys itself. */
enum { SHIFT = 1, CTRL = 4 };

#define PASTE_BEGIN 200
#define PASTE_END 201

/* True if the byte means Ctrl with a letter: it is the letter's code minus 0x60. Excludes Ctrl-H, I, M and J: their
 * bytes come far more often from the keys Backspace, Tab, Enter and Line Feed. */
static bool is_ctrl_letter(uint8_t byte)
{
    return byte >= 1 && byte <= 26 && byte != '\b' && byte != '\t' && byte != '\n' && byte != '\r';
}

/* Returns the key of a character that is no letter or digit, on a US keyboard, with or without Shift. */
static uint16_t sign_key(uint8_t byte)
{
    switch (byte) {
    case '\t':
        return TIA_KEY_TAB;
    case ' ':
        return TIA_KEY_SPACE;
    case '+':
    case '=':
        return TIA_KEY_PLUS;
    case '-':
    case '_':
        return TIA_KEY_MINUS;
    case '?':
    case '/':
        return TIA_KEY_HELP;
    default:
        return TIA_KEY_OTHER;
    }
}

static uint16_t plain_key(uint8_t byte)
{
    if (byte == TIA_KEY_INTERRUPT)
        return TIA_KEY_INTERRUPT;
    if (byte == CTRL_Z)
        return DECODED_STOP;
    if (byte >= 'A' && byte <= 'Z')
        return (uint16_t)(byte - 'A' + 'a');
    if (is_ctrl_letter(byte))
        return (uint16_t)(byte - 1 + 'a');
    if ((byte >= 'a' && byte <= 'z') || (byte >= '0' && byte <= '9'))
        return byte;
    return sign_key(byte);
}

static uint16_t arrow_key(uint8_t final)
{
    switch (final) {
    case 'H':
        return TIA_KEY_HOME;
    case 'A':
        return TIA_KEY_UP;
    case 'B':
        return TIA_KEY_DOWN;
    case 'C':
        return TIA_KEY_RIGHT;
    case 'D':
        return TIA_KEY_LEFT;
    default:
        return TIA_KEY_OTHER;
    }
}

/* Decodes a report of the mouse. Button 0 is the left one, 3 is none; 32 is added for a movement, 64 for the wheel, and
 * 4, 8 and 16 for Shift, Alt and Ctrl. */
static uint16_t mouse_report(struct decoder *d, uint8_t final)
{
    unsigned button = d->number & 0x43u;

    d->column = d->more[0];
    d->row = d->more[1];
    if (d->number & 64)
        return final == 'M' && button <= 65 ? (uint16_t)(button == 64 ? TIA_KEY_PLUS : TIA_KEY_MINUS) : 0;
    d->drag = button == 0 && final == 'M';
    return d->column && d->row ? DECODED_POINTER : 0;
}

static uint16_t csi_key(struct decoder *d, uint8_t final)
{
    bool focus = (final == 'I' || final == 'O') && d->number == 0 && !d->more_parameters;

    if (final == '~' && (d->number == PASTE_BEGIN || d->number == PASTE_END)) {
        d->in_paste = d->number == PASTE_BEGIN;
        return 0;
    }
    if (d->private_mark == '<' && (final == 'M' || final == 'm'))
        return mouse_report(d, final);
    if (d->private_mark || focus)
        return 0;
    d->shift = d->more[0] > 1 && ((d->more[0] - 1) & (SHIFT | CTRL));
    if (final == '~' && (d->number == 1 || d->number == 7))
        return TIA_KEY_HOME;
    if (final == '~' && d->number == 5)
        return TIA_KEY_PAGE_UP;
    if (final == '~' && d->number == 6)
        return TIA_KEY_PAGE_DOWN;
    return arrow_key(final);
}

static void begin_sequence(struct decoder *d, uint8_t state)
{
    d->state = state;
    d->number = 0;
    d->more[0] = d->more[1] = 0;
    d->parameters = 0;
    d->private_mark = 0;
    d->more_parameters = false;
}

/* Skips a UTF-8 character (RFC 3629): its lead byte announces one to three more. */
static uint16_t begin_utf8(struct decoder *d, uint8_t byte)
{
    if (byte >= 0xc2 && byte <= 0xf4)
        d->skip = (uint8_t)(byte < 0xe0 ? 1 : byte < 0xf0 ? 2 : 3);
    return TIA_KEY_OTHER;
}

static uint16_t after_ground(struct decoder *d, uint8_t byte)
{
    d->state = GROUND;
    if (byte == ESC) {
        begin_sequence(d, ESCAPE);
        return 0;
    }
    return byte >= 0x80 ? begin_utf8(d, byte) : plain_key(byte);
}

static uint16_t after_escape(struct decoder *d, uint8_t byte)
{
    switch (byte) {
    case ESC:
        return TIA_KEY_ESCAPE; /* the second ESC begins a new sequence */
    case '[':
        begin_sequence(d, CSI);
        return 0;
    case 'O':
        begin_sequence(d, SS3);
        return 0;
    case ']': /* OSC, DCS, SOS, PM and APC: a string up to BEL or ESC \ */
    case 'P':
    case 'X':
    case '^':
    case '_':
        begin_sequence(d, STRING);
        d->number = byte;
        return 0;
    default:
        return after_ground(d, byte); /* Alt and a key */
    }
}

/* Adds a digit to a parameter. In the first parameter, digits count only at the beginning of the sequence, or after the
 * mark <. */
static void add_digit(struct decoder *d, uint8_t digit)
{
    uint16_t *number = d->parameters == 0 ? &d->number : d->parameters < 3 ? &d->more[d->parameters - 1] : NULL;
    bool first = d->parameters == 0 && d->more_parameters && d->private_mark != '<';

    if (number && !first && *number < 6000)
        *number = (uint16_t)(*number * 10 + digit - '0');
}

static uint16_t after_csi(struct decoder *d, uint8_t byte)
{
    if (byte >= '0' && byte <= '9') {
        add_digit(d, byte);
        return 0;
    }
    if (byte >= 0x20 && byte <= 0x3f) {
        if (byte >= '<')
            d->private_mark = byte;
        d->parameters = (uint8_t)(d->parameters + (byte == ';' && d->parameters < 3));
        d->more_parameters = true;
        return 0;
    }
    if (byte == '[' && d->number == 0 && !d->more_parameters) {
        d->state = LINUX_FUNCTION; /* the Linux console's F1..F5 are ESC [ [ A..E */
        return 0;
    }
    if (byte < 0x40 || byte >= DEL)
        return after_ground(d, byte);
    d->state = GROUND;
    return csi_key(d, byte);
}

static uint16_t after_ss3(struct decoder *d, uint8_t byte)
{
    if ((byte >= '0' && byte <= '9') || byte == ';')
        return 0; /* an old form of modifiers */
    if (byte < 0x40 || byte >= DEL)
        return after_ground(d, byte);
    d->state = GROUND;
    return arrow_key(byte);
}

static uint16_t after_string(struct decoder *d, uint8_t byte)
{
    if (d->state == STRING_ESCAPE && byte != '\\')
        return after_escape(d, byte);
    if (byte == TIA_KEY_INTERRUPT)
        return after_ground(d, byte);
    d->number = 0; /* a string, not Alt and its first character */
    if (byte == ESC)
        d->state = STRING_ESCAPE;
    else if (byte == BEL || d->state == STRING_ESCAPE)
        d->state = GROUND;
    return 0;
}

static uint16_t step(struct decoder *d, uint8_t byte)
{
    switch (d->state) {
    case ESCAPE:
        return after_escape(d, byte);
    case CSI:
        return after_csi(d, byte);
    case SS3:
        return after_ss3(d, byte);
    case STRING:
    case STRING_ESCAPE:
        return after_string(d, byte);
    case LINUX_FUNCTION:
        d->state = GROUND;
        return byte >= 'A' && byte <= 'E' ? (uint16_t)TIA_KEY_OTHER : after_ground(d, byte);
    default:
        return after_ground(d, byte);
    }
}

uint16_t decode_byte(struct decoder *d, uint8_t byte)
{
    bool pasted = d->in_paste;

    if (d->skip > 0 && (byte & 0xc0) == 0x80) {
        d->skip--;
        return 0;
    }
    d->skip = 0;
    d->shift = false;
    uint16_t key = step(d, byte);
    return pasted && key != TIA_KEY_INTERRUPT ? 0 : key;
}

bool decode_pending(const struct decoder *d)
{
    return d->state != GROUND;
}

uint16_t decode_silence(struct decoder *d)
{
    uint8_t state = d->state;
    bool lone = d->number == 0 && !d->more_parameters;

    d->state = GROUND;
    if (d->in_paste)
        return 0;
    switch (state) {
    case ESCAPE:
        return TIA_KEY_ESCAPE;
    case SS3: /* Alt-O: SS3 without its letter */
        return 'o';
    case CSI:
        return lone ? TIA_KEY_OTHER : 0;
    case STRING:
        return d->number ? plain_key((uint8_t)d->number) : 0;
    default:
        return 0;
    }
}
