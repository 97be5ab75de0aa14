/* test_ps2.c - PS/2 bytes, as a keyboard sends them, against the typed keys. */
#include "check.h"
#include "ps2/ps2.h"
#include "random.h"

static struct tia_ps2 keyboard; /* decoder of the bytes */
static char told[256];          /* its events: "+a -a" is a press and a release, "!" a tap */

static const char *name(uint16_t key)
{
    static char letter[2];
    switch (key) {
    case TIA_KEY_LEFT:
        return "left";
    case TIA_KEY_RIGHT:
        return "right";
    case TIA_KEY_UP:
        return "up";
    case TIA_KEY_DOWN:
        return "down";
    case TIA_KEY_PAGE_UP:
        return "pgup";
    case TIA_KEY_PAGE_DOWN:
        return "pgdn";
    case TIA_KEY_OTHER:
        return "other";
    case TIA_KEY_ESCAPE:
        return "esc";
    case TIA_KEY_INTERRUPT:
        return "int";
    default:
        letter[0] = (char)key;
        return letter;
    }
}

static void tell(const struct tia_event *event)
{
    size_t used = strlen(told);
    (void)snprintf(told + used, sizeof told - used, "%s%c%s", used ? " " : "", "+-!"[event->kind], name(event->key));
}

static const char *feed(const uint8_t *bytes, size_t count)
{
    struct tia_event event;
    told[0] = 0;
    for (size_t i = 0; i < count; i++) {
        if (tia_ps2_feed(&keyboard, bytes[i], &event))
            tell(&event);
        while (tia_ps2_owed(&keyboard, &event))
            tell(&event);
    }
    return told;
}

#define FEED(...) feed((const uint8_t[]){__VA_ARGS__}, sizeof((const uint8_t[]){__VA_ARGS__}))
#define START() memset(&keyboard, 0, sizeof keyboard)
#define CHECK_TOLD(want, ...) CHECK_MSG(strcmp(FEED(__VA_ARGS__), want) == 0, "told \"%s\", not \"%s\"", told, want)

/* The make codes in the order of the characters, from IBM's table of set 2. */
TEST(letters_and_digits)
{
    static const char typed[] = "abcdefghijklmnopqrstuvwxyz0123456789";
    static const uint8_t codes[] = {0x1c, 0x32, 0x21, 0x23, 0x24, 0x2b, 0x34, 0x33, 0x43, 0x3b, 0x42, 0x4b,
                                    0x3a, 0x31, 0x44, 0x4d, 0x15, 0x2d, 0x1b, 0x2c, 0x3c, 0x2a, 0x1d, 0x22,
                                    0x35, 0x1a, 0x45, 0x16, 0x1e, 0x26, 0x25, 0x2e, 0x36, 0x3d, 0x3e, 0x46};
    char want[8];
    START();
    CHECK_EQ(sizeof codes, strlen(typed));
    for (size_t i = 0; i < sizeof codes; i++) {
        (void)snprintf(want, sizeof want, "+%c -%c", typed[i], typed[i]);
        CHECK_TOLD(want, codes[i], 0xf0, codes[i]);
    }
}

TEST(arrows_need_their_prefix)
{
    START();
    CHECK_TOLD("+left -left", 0xe0, 0x6b, 0xe0, 0xf0, 0x6b);
    CHECK_TOLD("+right -right", 0xe0, 0x74, 0xe0, 0xf0, 0x74);
    CHECK_TOLD("+up -up", 0xe0, 0x75, 0xe0, 0xf0, 0x75);
    CHECK_TOLD("+down -down", 0xe0, 0x72, 0xe0, 0xf0, 0x72);
    CHECK_TOLD("+pgup -pgup", 0xe0, 0x7d, 0xe0, 0xf0, 0x7d);
    CHECK_TOLD("+pgdn -pgdn", 0xe0, 0x7a, 0xe0, 0xf0, 0x7a);
    CHECK_TOLD("+other -other", 0x6b, 0xf0, 0x6b); /* the keypad's 4 */
}

TEST(prefixed_and_plain_keys_are_two_keys)
{
    START();
    CHECK_TOLD("+left +other -left -other", 0xe0, 0x6b, 0x6b, 0xe0, 0xf0, 0x6b, 0xf0, 0x6b);
}

TEST(held_key_is_one_press)
{
    START();
    CHECK_TOLD("+a", 0x1c, 0x1c, 0x1c);
    CHECK_TOLD("+s", 0x1b, 0x1b);
    CHECK_TOLD("-a -s", 0xf0, 0x1c, 0xf0, 0x1b);
    CHECK_TOLD("", 0xf0, 0x1c); /* a key held before we listened */
}

TEST(modifiers_and_locks_are_silent)
{
    START();
    CHECK_TOLD("", 0x12, 0xf0, 0x12, 0x59, 0xf0, 0x59);             /* Shift */
    CHECK_TOLD("", 0x14, 0xf0, 0x14, 0xe0, 0x14, 0xe0, 0xf0, 0x14); /* Ctrl */
    CHECK_TOLD("", 0x11, 0xf0, 0x11, 0xe0, 0x11, 0xe0, 0xf0, 0x11); /* Alt, AltGr */
    CHECK_TOLD("", 0xe0, 0x1f, 0xe0, 0xf0, 0x1f, 0xe0, 0x27, 0xe0, 0xf0, 0x27);
    CHECK_TOLD("", 0x58, 0xf0, 0x58, 0x77, 0xf0, 0x77, 0x7e, 0xf0, 0x7e);
    CHECK_TOLD("+a -a", 0x12, 0x1c, 0xf0, 0x1c, 0xf0, 0x12); /* Shift-A is the key a */
}

TEST(fake_shifts_around_an_arrow)
{
    START();
    CHECK_TOLD("+up -up", 0xe0, 0x12, 0xe0, 0x75, 0xe0, 0xf0, 0x75, 0xe0, 0xf0, 0x12);
    CHECK_TOLD("+other -other", 0xe0, 0x12, 0xe0, 0x7c, 0xe0, 0xf0, 0x7c, 0xe0, 0xf0, 0x12); /* Print Screen */
}

TEST(control_c_interrupts)
{
    START();
    CHECK_TOLD("+int -int", 0x14, 0x21, 0xf0, 0x21, 0xf0, 0x14);
    CHECK_TOLD("+int -int", 0xe0, 0x14, 0x21, 0xf0, 0x21, 0xe0, 0xf0, 0x14);
    CHECK_TOLD("+c -c", 0x21, 0xf0, 0x21);
}

TEST(other_keys)
{
    START();
    CHECK_TOLD("+esc -esc", 0x76, 0xf0, 0x76);
    CHECK_TOLD("+other -other", 0x29, 0xf0, 0x29);                                 /* space */
    CHECK_TOLD("+other -other", 0x83, 0xf0, 0x83);                                 /* F7, the only code above 7f */
    CHECK_TOLD("+other -other", 0xe0, 0x71, 0xe0, 0xf0, 0x71);                     /* Delete */
    CHECK_TOLD("!other +a", 0xe1, 0x14, 0x77, 0xe1, 0xf0, 0x14, 0xf0, 0x77, 0x1c); /* Pause, then a */
}

TEST(answers_are_no_keys)
{
    START();
    CHECK_TOLD("", 0xfa, 0xee, 0xfe, 0xfc, 0xfd, 0x00, 0xff, 0x85);
    CHECK_TOLD("+a", 0xe0, 0xff, 0x1c); /* an overrun ends a sequence */
}

TEST(keyboard_plugged_in_anew_holds_nothing)
{
    START();
    CHECK_TOLD("+a +left", 0x1c, 0xe0, 0x6b, 0x12);
    CHECK_TOLD("-a -left", 0xaa);
    CHECK_TOLD("+a", 0x1c);
    CHECK_TOLD("-a", 0x00); /* overrun: the release may be lost */
}

/* Random bytes: presses and releases alternate for each key, and the decoder stays valid. */
TEST(noise)
{
    int balance[TIA_KEY_OTHER + 1] = {0};
    struct tia_event event;
    START();
    for (int i = 0; i < 200000; i++) {
        int told_one = tia_ps2_feed(&keyboard, (uint8_t)random_bits(), &event);
        for (; told_one; told_one = tia_ps2_owed(&keyboard, &event)) {
            CHECK(event.key <= TIA_KEY_OTHER);
            if (event.key == TIA_KEY_OTHER || event.key == TIA_KEY_INTERRUPT || event.key == 'c')
                continue; /* several keys in one code, or a name that Ctrl changes */
            balance[event.key] += event.kind == TIA_EVENT_PRESS ? 1 : -1;
            CHECK(balance[event.key] == 0 || balance[event.key] == 1);
        }
        while (tia_ps2_owed(&keyboard, &event))
            if (event.key < TIA_KEY_OTHER)
                balance[event.key]--;
    }
}

int main(void)
{
    RUN(letters_and_digits);
    RUN(arrows_need_their_prefix);
    RUN(prefixed_and_plain_keys_are_two_keys);
    RUN(held_key_is_one_press);
    RUN(modifiers_and_locks_are_silent);
    RUN(fake_shifts_around_an_arrow);
    RUN(control_c_interrupts);
    RUN(other_keys);
    RUN(answers_are_no_keys);
    RUN(keyboard_plugged_in_anew_holds_nothing);
    RUN(noise);
    return check_status();
}
