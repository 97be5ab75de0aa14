/* key_codes.c - key codes by position, and the state of a keyboard. */
#include "key_codes.h"

#include <string.h>

bool key_set_has(const struct key_set *set, unsigned code)
{
    return code < KEY_CNT && (set->words[code / KEY_WORD_BITS] >> code % KEY_WORD_BITS & 1) != 0;
}

void key_set_add(struct key_set *set, unsigned code)
{
    if (code < KEY_CNT)
        set->words[code / KEY_WORD_BITS] |= 1ul << code % KEY_WORD_BITS;
}

void key_set_remove(struct key_set *set, unsigned code)
{
    if (code < KEY_CNT)
        set->words[code / KEY_WORD_BITS] &= ~(1ul << code % KEY_WORD_BITS);
}

/* Returns the letter or digit at a position of a US keyboard, or 0. The codes of a row of keys are consecutive. */
static uint16_t character_at(unsigned code)
{
    static const struct {
        unsigned first;
        const char *characters;
    } rows[] = {{KEY_1, "1234567890"}, {KEY_Q, "qwertyuiop"}, {KEY_A, "asdfghjkl"}, {KEY_Z, "zxcvbnm"}};

    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        if (code >= rows[i].first && code - rows[i].first < strlen(rows[i].characters))
            return (uint16_t)rows[i].characters[code - rows[i].first];
    return 0;
}

static uint16_t named_at(unsigned code)
{
    static const struct {
        unsigned code;
        uint16_t key;
    } names[] = {
        {KEY_ESC, TIA_KEY_ESCAPE},
        {KEY_LEFT, TIA_KEY_LEFT},
        {KEY_RIGHT, TIA_KEY_RIGHT},
        {KEY_UP, TIA_KEY_UP},
        {KEY_DOWN, TIA_KEY_DOWN},
        {KEY_PAGEUP, TIA_KEY_PAGE_UP},
        {KEY_PAGEDOWN, TIA_KEY_PAGE_DOWN},
        {KEY_HOME, TIA_KEY_HOME},
        {KEY_TAB, TIA_KEY_TAB},
        {KEY_SPACE, TIA_KEY_SPACE},
        {KEY_EQUAL, TIA_KEY_PLUS},
        {KEY_KPPLUS, TIA_KEY_PLUS},
        {KEY_MINUS, TIA_KEY_MINUS},
        {KEY_KPMINUS, TIA_KEY_MINUS},
        {KEY_SLASH, TIA_KEY_HELP},
    };

    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (code == names[i].code)
            return names[i].key;
    return 0;
}

bool key_is_modifier(unsigned code)
{
    static const unsigned modifiers[] = {KEY_LEFTCTRL, KEY_RIGHTCTRL, KEY_LEFTSHIFT, KEY_RIGHTSHIFT,
                                         KEY_LEFTALT,  KEY_RIGHTALT,  KEY_LEFTMETA,  KEY_RIGHTMETA};

    for (size_t i = 0; i < sizeof modifiers / sizeof modifiers[0]; i++)
        if (code == modifiers[i])
            return true;
    return false;
}

/* True for a key that types on any PC keyboard, including Asian ones, except modifiers. The codes between the ranges
 * belong to locks, media keys, buttons, and keys that only report an event (power, lid, rfkill). */
static bool is_typing_key(unsigned code)
{
    static const unsigned ranges[][2] = {
        {KEY_ESC, KEY_SPACE},       {KEY_F1, KEY_F10},        {KEY_KP7, KEY_KPDOT},   {KEY_ZENKAKUHANKAKU, KEY_SYSRQ},
        {KEY_LINEFEED, KEY_DELETE}, {KEY_KPEQUAL, KEY_PAUSE}, {KEY_KPCOMMA, KEY_YEN}, {KEY_COMPOSE, KEY_COMPOSE},
        {KEY_F13, KEY_F24},
    };

    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++)
        if (code >= ranges[i][0] && code <= ranges[i][1])
            return !key_is_modifier(code);
    return false;
}

uint16_t key_at(unsigned code)
{
    uint16_t key = character_at(code);

    if (key == 0)
        key = named_at(code);
    return key || !is_typing_key(code) ? key : TIA_KEY_OTHER;
}

unsigned key_console(unsigned code)
{
    if (code >= KEY_F1 && code <= KEY_F10)
        return code - KEY_F1 + 1;
    return code == KEY_F11 ? 11 : code == KEY_F12 ? 12 : 0;
}

bool key_set_types(const struct key_set *set)
{
    for (unsigned code = KEY_Q; code <= KEY_SPACE; code++)
        if (key_set_has(set, code) && (code == KEY_SPACE || character_at(code)))
            return true;
    return false;
}

void key_state_modifiers(const struct key_state *state, struct key_modifiers *modifiers)
{
    const struct key_set *held = &state->held;

    modifiers->ctrl |= key_set_has(held, KEY_LEFTCTRL) || key_set_has(held, KEY_RIGHTCTRL);
    modifiers->shift |= key_set_has(held, KEY_LEFTSHIFT) || key_set_has(held, KEY_RIGHTSHIFT);
    modifiers->alt |= key_set_has(held, KEY_LEFTALT) || key_set_has(held, KEY_RIGHTALT);
}

static bool pressed(struct key_state *state, unsigned code, struct key_modifiers modifiers, struct key_change *change)
{
    uint16_t key = key_at(code);
    bool again = key_set_has(&state->reported, code);

    key_set_add(&state->held, code);
    if (key == 0 || again)
        return false;
    if (code == KEY_C) {
        state->interrupt = modifiers.ctrl;
        if (modifiers.ctrl)
            key = TIA_KEY_INTERRUPT;
    }
    key_set_add(&state->reported, code);
    *change = (struct key_change){.press = true, .code = (uint16_t)code, .key = key};
    return true;
}

static bool released(struct key_state *state, unsigned code, struct key_change *change)
{
    bool reported = key_set_has(&state->reported, code);
    uint16_t key = code == KEY_C && state->interrupt ? (uint16_t)TIA_KEY_INTERRUPT : key_at(code);

    key_set_remove(&state->held, code);
    key_set_remove(&state->reported, code);
    *change = (struct key_change){.press = false, .code = (uint16_t)code, .key = key};
    return reported;
}

/* Updates the state by an event. The value 2, the kernel's repeat, changes nothing. */
bool key_state_take(struct key_state *state, unsigned code, int value, struct key_modifiers modifiers,
                    struct key_change *change)
{
    if (value == 1)
        return pressed(state, code, modifiers, change);
    return value == 0 && released(state, code, change);
}

void key_state_begin(struct key_state *state, const struct key_set *down)
{
    state->held = *down;
    state->ending = state->reported;
    state->missing = (struct key_set){{0}};
}

void key_state_lost(struct key_state *state, const struct key_set *down)
{
    for (size_t i = 0; i < KEY_WORDS; i++) {
        state->ending.words[i] |= state->reported.words[i] & ~down->words[i];
        state->missing.words[i] = down->words[i] & ~state->held.words[i];
    }
    state->held = *down;
}

/* Removes a code from the set and returns it; KEY_CNT when the set is empty. */
static unsigned take_one(struct key_set *set)
{
    for (unsigned code = 0; code < KEY_CNT; code++)
        if (key_set_has(set, code)) {
            key_set_remove(set, code);
            return code;
        }
    return KEY_CNT;
}

bool key_state_settle(struct key_state *state, struct key_modifiers modifiers, struct key_change *change)
{
    unsigned code;

    while ((code = take_one(&state->ending)) < KEY_CNT) {
        bool down = key_set_has(&state->held, code), reported = released(state, code, change);
        if (down)
            key_set_add(&state->held, code);
        if (reported)
            return true;
    }
    while ((code = take_one(&state->missing)) < KEY_CNT)
        if (pressed(state, code, modifiers, change))
            return true;
    return false;
}
