/* test_evdev.c - the meaning of a keyboard's events. Devices themselves are tested in a guest. */
#include "check.h"
#include "evdev/key_codes.h"
#include "evdev/pointer.h"

/* Returns a key as text: letters and digits themselves, arrows L R U D, page up and down ^ v, Escape E, Home H, Tab T,
 * Space _, + and -, ? as /; Ctrl-C !, others ?, no key a dot. */
static char letter(uint16_t key)
{
    if (key == TIA_KEY_ESCAPE || key == TIA_KEY_INTERRUPT)
        return key == TIA_KEY_ESCAPE ? 'E' : '!';
    if (key == TIA_KEY_TAB || key == TIA_KEY_SPACE || key == TIA_KEY_HELP)
        return key == TIA_KEY_TAB ? 'T' : key == TIA_KEY_SPACE ? '_' : '/';
    if (key >= TIA_KEY_LEFT && key <= TIA_KEY_OTHER)
        return "LRUD^vH?"[key - TIA_KEY_LEFT];
    return key ? (char)key : '.';
}

/* The positions are those printed in linux/input-event-codes.h, code 0 first: 16 to a line. */
TEST(keys_by_position)
{
    static const char want[] = ".E1234567890-+?T" /* reserved, ESC, digits, - = backspace tab */
                               "qwertyuiop???.as" /* letters, [ ] enter, left ctrl, letters */
                               "dfghjkl???.?zxcv" /* ; ' `, left shift, backslash */
                               "bnm?"
                               "?/.?._.?????" /* , . /, right shift, KP*, left alt, space, caps, F1.. */
                               "?????..??"
                               "?-???+?"           /* F6.. F10, num lock, scroll lock, keypad */
                               "????.???????????"  /* keypad, 84 not used, 85 to 95: Asian, F11, F12 */
                               "?.??.?HU^LR?Dv??"; /* KP enter, right ctrl, KP/, SysRq, right alt, LF, Home .. */
    for (unsigned code = 0; code < 0x70; code++)
        CHECK_MSG(letter(key_at(code)) == want[code], "code %u is %c, not %c", code, letter(key_at(code)), want[code]);
}

TEST(keys_beyond_the_pc_keyboard)
{
    static const unsigned typing[] = {KEY_DELETE, KEY_KPEQUAL, KEY_PAUSE, KEY_KPCOMMA,
                                      KEY_YEN,    KEY_COMPOSE, KEY_F13,   KEY_F24};
    static const unsigned silent[] = {KEY_MUTE,    KEY_VOLUMEUP, KEY_POWER,     KEY_LEFTMETA,     KEY_RIGHTMETA,
                                      KEY_SLEEP,   KEY_FN,       BTN_LEFT,      BTN_TRIGGER,      BTN_TOUCH,
                                      KEY_WAKEUP,  KEY_RFKILL,   KEY_PLAYPAUSE, KEY_BRIGHTNESSUP, KEY_CNT,
                                      KEY_CNT + 1, UINT32_MAX};

    for (size_t i = 0; i < sizeof typing / sizeof typing[0]; i++)
        CHECK_MSG(key_at(typing[i]) == TIA_KEY_OTHER, "code %u", typing[i]);
    for (size_t i = 0; i < sizeof silent / sizeof silent[0]; i++)
        CHECK_MSG(key_at(silent[i]) == 0, "code %u", silent[i]);
}

TEST(console_numbers)
{
    CHECK_EQ(key_console(KEY_F1), 1);
    CHECK_EQ(key_console(KEY_F10), 10);
    CHECK_EQ(key_console(KEY_F11), 11);
    CHECK_EQ(key_console(KEY_F12), 12);
    CHECK_EQ(key_console(KEY_NUMLOCK), 0);
    CHECK_EQ(key_console(KEY_F13), 0);
}

/* Returns a set of keys, valid until the next call. */
static const struct key_set *set_of(const unsigned *codes, size_t count)
{
    static struct key_set set;

    set = (struct key_set){{0}};
    for (size_t i = 0; i < count; i++)
        key_set_add(&set, codes[i]);
    return &set;
}

#define SET(...) set_of((const unsigned[]){__VA_ARGS__}, sizeof((const unsigned[]){__VA_ARGS__}) / sizeof(unsigned))

TEST(what_is_a_keyboard)
{
    CHECK(key_set_types(SET(KEY_A)));
    CHECK(key_set_types(SET(KEY_SPACE)));
    CHECK(key_set_types(SET(KEY_POWER, KEY_M)));
    CHECK(!key_set_types(SET(KEY_POWER, KEY_SLEEP)));
    CHECK(!key_set_types(SET(BTN_LEFT, BTN_RIGHT)));
    CHECK(!key_set_types(SET(KEY_1, KEY_UP, KEY_ENTER, KEY_LEFTSHIFT)));
}

TEST(sets_hold_every_code)
{
    struct key_set set = {{0}};

    for (unsigned code = 0; code < KEY_CNT; code++) {
        CHECK(!key_set_has(&set, code));
        key_set_add(&set, code);
        CHECK(key_set_has(&set, code));
        if (code % 3)
            key_set_remove(&set, code);
        CHECK_EQ(key_set_has(&set, code), code % 3 == 0);
    }
    key_set_add(&set, KEY_CNT);
    CHECK(!key_set_has(&set, KEY_CNT));
}

/* ---- a keyboard's state ---- */

static struct key_state state;
static char told[64];

static void tell(const struct key_change *change)
{
    size_t n = strlen(told);

    told[n] = change->press ? '+' : '-';
    told[n + 1] = letter(change->key);
    told[n + 2] = 0;
}

static void feed(unsigned code, int value)
{
    struct key_modifiers modifiers = {false, false};
    struct key_change change;

    key_state_modifiers(&state, &modifiers);
    if (key_state_take(&state, code, value, modifiers, &change))
        tell(&change);
}

static void settle(void)
{
    struct key_modifiers modifiers = {false, false};
    struct key_change change;

    while (key_state_settle(&state, modifiers, &change))
        tell(&change);
}

static void begin(void)
{
    memset(&state, 0, sizeof state);
    told[0] = 0;
}

#define CHECK_TOLD(want) CHECK_MSG(strcmp(told, want) == 0, "told \"%s\", not \"%s\"", told, want)

TEST(presses_and_releases)
{
    begin();
    feed(KEY_A, 1);
    feed(KEY_LEFT, 1);
    feed(KEY_A, 0);
    feed(KEY_LEFT, 0);
    feed(KEY_ENTER, 1);
    feed(KEY_ENTER, 0);
    CHECK_TOLD("+a+L-a-L+?-?");
}

TEST(repeats_and_doubles_are_nothing)
{
    begin();
    feed(KEY_A, 2);
    feed(KEY_A, 1);
    feed(KEY_A, 2);
    feed(KEY_A, 1);
    feed(KEY_A, 0);
    feed(KEY_A, 0);
    CHECK_TOLD("+a-a");
}

TEST(modifiers_and_locks_are_nothing)
{
    begin();
    for (int value = 1; value >= 0; value--) {
        feed(KEY_LEFTSHIFT, value);
        feed(KEY_CAPSLOCK, value);
        feed(KEY_NUMLOCK, value);
        feed(KEY_SCROLLLOCK, value);
        feed(KEY_RIGHTMETA, value);
        feed(KEY_RIGHTALT, value);
    }
    CHECK_TOLD("");
    feed(KEY_LEFTSHIFT, 1);
    feed(KEY_S, 1);
    CHECK_TOLD("+s");
}

TEST(ctrl_c_interrupts)
{
    begin();
    feed(KEY_RIGHTCTRL, 1);
    feed(KEY_C, 1);
    feed(KEY_RIGHTCTRL, 0);
    feed(KEY_C, 0);
    feed(KEY_C, 1);
    feed(KEY_LEFTCTRL, 1);
    feed(KEY_C, 0);
    feed(KEY_A, 1);
    CHECK_TOLD("+!-!+c-c+a");
}

/* Enter is still down from the shell when the keyboard is opened: it causes no event. */
TEST(keys_held_at_the_start_are_nothing)
{
    begin();
    key_state_begin(&state, SET(KEY_ENTER, KEY_LEFTCTRL));
    settle();
    feed(KEY_ENTER, 2);
    feed(KEY_C, 1);
    feed(KEY_ENTER, 0);
    feed(KEY_ENTER, 1);
    CHECK_TOLD("+!+?");
}

TEST(an_unplug_releases_what_was_told)
{
    begin();
    key_state_begin(&state, SET(KEY_ENTER));
    feed(KEY_LEFT, 1);
    feed(KEY_LEFTSHIFT, 1);
    feed(KEY_D, 1);
    key_state_begin(&state, SET(KEY_LEFT)); /* counts as released, physically down or not */
    settle();
    CHECK_TOLD("+L+d-d-L");
    feed(KEY_LEFT, 0);
    CHECK_TOLD("+L+d-d-L");
    feed(KEY_LEFT, 1);
    CHECK_TOLD("+L+d-d-L+L");
}

TEST(lost_events_are_made_up)
{
    begin();
    feed(KEY_LEFT, 1);
    feed(KEY_A, 1);
    feed(KEY_LEFTCTRL, 1);
    key_state_lost(&state, SET(KEY_A, KEY_W, KEY_LEFTSHIFT));
    settle();
    CHECK_TOLD("+L+a-L+w");
    feed(KEY_C, 1);
    feed(KEY_W, 0);
    feed(KEY_A, 0);
    CHECK_TOLD("+L+a-L+w+c-w-a");
}

/* ---- pointers ---- */

static bool sent(struct pointer *pointer, uint16_t type, uint16_t code, int32_t value, struct tia_event *event)
{
    struct input_event input = {.type = type, .code = code, .value = value};

    return pointer_take(pointer, &input, event);
}

TEST(a_mouse_tells_how_far_it_has_moved)
{
    struct pointer mouse = {.fd = -1};
    struct tia_event event;

    CHECK(!sent(&mouse, EV_REL, REL_X, 3, &event));
    CHECK(!sent(&mouse, EV_REL, REL_Y, -5, &event));
    CHECK(!sent(&mouse, EV_REL, REL_X, 4, &event));
    CHECK(sent(&mouse, EV_SYN, SYN_REPORT, 0, &event));
    CHECK(event.kind == TIA_EVENT_MOVE && event.x == 7 && event.y == -5 && !event.drag);
    CHECK(!sent(&mouse, EV_SYN, SYN_REPORT, 0, &event)); /* the mouse has not moved since */
    CHECK(!sent(&mouse, EV_KEY, BTN_LEFT, 1, &event));
    CHECK(!sent(&mouse, EV_KEY, BTN_RIGHT, 0, &event));
    CHECK(!sent(&mouse, EV_REL, REL_X, INT32_MAX, &event));
    CHECK(!sent(&mouse, EV_REL, REL_X, INT32_MAX, &event));
    CHECK(sent(&mouse, EV_SYN, SYN_REPORT, 0, &event));
    CHECK(event.drag && event.x == 32767 && event.y == 0);
}

TEST(a_wheel_zooms)
{
    struct pointer mouse = {.fd = -1};
    struct tia_event event;

    CHECK(!sent(&mouse, EV_REL, REL_WHEEL, -2, &event));
    CHECK(!sent(&mouse, EV_SYN, SYN_REPORT, 0, &event));
    for (int i = 0; i < 2; i++)
        CHECK(pointer_wheel(&mouse, &event) && event.kind == TIA_EVENT_TAP && event.key == TIA_KEY_MINUS);
    CHECK(!pointer_wheel(&mouse, &event));
    CHECK(!sent(&mouse, EV_REL, REL_WHEEL, 1, &event));
    CHECK(pointer_wheel(&mouse, &event) && event.key == TIA_KEY_PLUS);
}

/* A tablet with a range from 100 to 300 across and from -10 to 10 down. */
TEST(a_tablet_tells_where_it_is)
{
    struct pointer tablet = {.fd = -1, .absolute = true, .low = {100, -10}, .high = {300, 10}, .at = {100, -10}};
    static const struct {
        int32_t x, y, want_x, want_y;
    } rows[] = {{100, -10, 0, 0}, {300, 10, 65535, 65535}, {200, 0, 32767, 32767}, {50, 99, 0, 65535}};
    struct tia_event event;

    for (unsigned i = 0; i < 4; i++) {
        CHECK(!sent(&tablet, EV_ABS, ABS_X, rows[i].x, &event));
        CHECK(!sent(&tablet, EV_ABS, ABS_Y, rows[i].y, &event));
        CHECK(!sent(&tablet, EV_KEY, BTN_TOUCH, i & 1, &event));
        CHECK(sent(&tablet, EV_SYN, SYN_REPORT, 0, &event));
        CHECK_MSG(event.kind == TIA_EVENT_POINT && event.x == rows[i].want_x && event.y == rows[i].want_y &&
                      event.drag == (i & 1),
                  "row %u: %d, %d", i, (int)event.x, (int)event.y);
    }
    CHECK(!sent(&tablet, EV_KEY, BTN_LEFT, 0, &event)); /* a drag ends and begins at its position */
    CHECK(sent(&tablet, EV_SYN, SYN_REPORT, 0, &event) && !event.drag && event.x == 0 && event.y == 65535);
    CHECK(!sent(&tablet, EV_KEY, BTN_LEFT, 1, &event));
    CHECK(sent(&tablet, EV_SYN, SYN_REPORT, 0, &event) && event.drag && event.x == 0);
    CHECK(!sent(&tablet, EV_SYN, SYN_REPORT, 0, &event));
    tablet.high[0] = tablet.low[0]; /* an axis without a range */
    CHECK(!sent(&tablet, EV_ABS, ABS_X, 5, &event));
    CHECK(sent(&tablet, EV_SYN, SYN_REPORT, 0, &event) && event.x == 32768);
}

int main(void)
{
    RUN(keys_by_position);
    RUN(keys_beyond_the_pc_keyboard);
    RUN(console_numbers);
    RUN(what_is_a_keyboard);
    RUN(sets_hold_every_code);
    RUN(presses_and_releases);
    RUN(repeats_and_doubles_are_nothing);
    RUN(modifiers_and_locks_are_nothing);
    RUN(ctrl_c_interrupts);
    RUN(keys_held_at_the_start_are_nothing);
    RUN(an_unplug_releases_what_was_told);
    RUN(lost_events_are_made_up);
    RUN(a_mouse_tells_how_far_it_has_moved);
    RUN(a_wheel_zooms);
    RUN(a_tablet_tells_where_it_is);
    return check_status();
}
