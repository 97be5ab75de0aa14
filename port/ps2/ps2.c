/* ps2.c - decodes scan code set 2, as the IBM PS/2 keyboard sends it. */
#include "ps2.h"

/* clang-format off */
enum {
    SILENT = 1,                         /* causes no event: a modifier, a lock, or a fake shift */
    CTRL = 0x14, ALT_GR = 0x11,
    SUPER_LEFT = 0x1f, SUPER_RIGHT = 0x27,
    FAKE_SHIFT_LEFT = 0x12, FAKE_SHIFT_RIGHT = 0x59,
    LAST_CODE = 0x84,
    EXTENDED = 0xe0, PAUSE = 0xe1, RELEASE = 0xf0,
    SELF_TEST_PASSED = 0xaa,            /* sent after power-on */
    OVERRUN = 0x00, KEY_ERROR = 0xff,   /* codes were lost */
    PAUSE_REST = 7                      /* bytes after E1 in E1 14 77 E1 F0 14 F0 77 */
};
/* clang-format on */

/* Keys without a prefix; 0 is any other key that types. */
static const uint8_t plain[TIA_PS2_CODES] = {
    /* clang-format off */
    [0x1c] = 'a', [0x32] = 'b', [0x21] = 'c', [0x23] = 'd', [0x24] = 'e', [0x2b] = 'f', [0x34] = 'g',
    [0x33] = 'h', [0x43] = 'i', [0x3b] = 'j', [0x42] = 'k', [0x4b] = 'l', [0x3a] = 'm', [0x31] = 'n',
    [0x44] = 'o', [0x4d] = 'p', [0x15] = 'q', [0x2d] = 'r', [0x1b] = 's', [0x2c] = 't', [0x3c] = 'u',
    [0x2a] = 'v', [0x1d] = 'w', [0x22] = 'x', [0x35] = 'y', [0x1a] = 'z',
    [0x45] = '0', [0x16] = '1', [0x1e] = '2', [0x26] = '3', [0x25] = '4',
    [0x2e] = '5', [0x36] = '6', [0x3d] = '7', [0x3e] = '8', [0x46] = '9',
    [0x76] = TIA_KEY_ESCAPE,
    [0x12] = SILENT, [0x59] = SILENT,                   /* Shift */
    [CTRL] = SILENT, [0x11] = SILENT,                   /* Ctrl, Alt */
    [0x58] = SILENT, [0x77] = SILENT, [0x7e] = SILENT   /* Caps, Num and Scroll Lock */
    /* clang-format on */
};

static uint16_t extended_key(uint8_t code)
{
    switch (code) {
    case 0x6b:
        return TIA_KEY_LEFT;
    case 0x74:
        return TIA_KEY_RIGHT;
    case 0x75:
        return TIA_KEY_UP;
    case 0x72:
        return TIA_KEY_DOWN;
    case 0x7d:
        return TIA_KEY_PAGE_UP;
    case 0x7a:
        return TIA_KEY_PAGE_DOWN;
    case CTRL:
    case ALT_GR:
    case SUPER_LEFT:
    case SUPER_RIGHT:
    case FAKE_SHIFT_LEFT: /* sent around the arrows while Num Lock is on */
    case FAKE_SHIFT_RIGHT:
        return SILENT;
    default:
        return TIA_KEY_OTHER;
    }
}

static bool is_held(const struct tia_ps2 *ps2, bool extended, uint8_t code)
{
    return ps2->held[extended][code / 8] >> (code % 8) & 1;
}

static uint16_t key_of(const struct tia_ps2 *ps2, bool extended, uint8_t code)
{
    if (extended)
        return extended_key(code);
    if (plain[code] == 'c' && (is_held(ps2, false, CTRL) || is_held(ps2, true, CTRL)))
        return TIA_KEY_INTERRUPT;
    return plain[code] ? plain[code] : (uint16_t)TIA_KEY_OTHER;
}

/* Records that a key went down or came up; returns 1 if that is a change, and the key is not silent. */
static int change(struct tia_ps2 *ps2, bool extended, uint8_t code, bool down, struct tia_event *event)
{
    if (is_held(ps2, extended, code) == down)
        return 0;
    ps2->held[extended][code / 8] = (uint8_t)(ps2->held[extended][code / 8] ^ 1u << code % 8);
    *event = (struct tia_event){.kind = down ? TIA_EVENT_PRESS : TIA_EVENT_RELEASE, .key = key_of(ps2, extended, code)};
    return event->key != SILENT;
}

static int feed_code(struct tia_ps2 *ps2, uint8_t code, struct tia_event *event)
{
    bool extended = ps2->extended, down = !ps2->released;
    ps2->extended = ps2->released = false;
    if (code == SELF_TEST_PASSED || code == OVERRUN || code == KEY_ERROR)
        ps2->forget = true;
    if (code == 0 || code > LAST_CODE)
        return 0;
    return change(ps2, extended, code, down, event);
}

int tia_ps2_feed(struct tia_ps2 *ps2, uint8_t byte, struct tia_event *event)
{
    if (ps2->pause) {
        if (--ps2->pause)
            return 0;
        *event = (struct tia_event){.kind = TIA_EVENT_TAP, .key = TIA_KEY_OTHER};
        return 1;
    }
    switch (byte) {
    case EXTENDED:
        ps2->extended = true;
        return 0;
    case RELEASE:
        ps2->released = true;
        return 0;
    case PAUSE:
        ps2->pause = PAUSE_REST;
        return 0;
    default:
        return feed_code(ps2, byte, event);
    }
}

int tia_ps2_owed(struct tia_ps2 *ps2, struct tia_event *event)
{
    for (unsigned i = 0; ps2->forget && i < 2 * TIA_PS2_CODES; i++) {
        bool extended = i >= TIA_PS2_CODES;
        if (change(ps2, extended, (uint8_t)(i % TIA_PS2_CODES), false, event))
            return 1;
    }
    ps2->forget = false;
    return 0;
}
