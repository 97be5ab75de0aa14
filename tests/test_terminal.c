/* test_terminal.c - keys from a terminal's bytes. */
#include "check.h"
#include "random.h"
#include "terminal/key_decoder.h"

#include <tia/port.h>

/* Returns the keys of `bytes` and, with `silence`, of the silence after them, as text: letters and digits as
 * themselves, arrows L R U D, page up and down ^ v, Home H, Tab T, Space _, + and -, ? as /, Escape E, Ctrl-C !, Ctrl-Z
 * Z, other keys ?, the mouse M; at the end ~ for an unfinished sequence. */
static const char *typed(const char *bytes, size_t count, bool silence)
{
    static char text[64];
    struct decoder d = {0};
    size_t n = 0;

    for (size_t i = 0; i <= count && n + 1 < sizeof text; i++) {
        uint16_t key = i < count ? decode_byte(&d, (uint8_t)bytes[i]) : silence ? decode_silence(&d) : 0;
        if (key == TIA_KEY_ESCAPE || key == TIA_KEY_INTERRUPT)
            text[n++] = key == TIA_KEY_ESCAPE ? 'E' : '!';
        else if (key >= TIA_KEY_LEFT && key <= TIA_KEY_OTHER)
            text[n++] = "LRUD^vH?"[key - TIA_KEY_LEFT];
        else if (key == TIA_KEY_TAB || key == TIA_KEY_SPACE || key == TIA_KEY_HELP)
            text[n++] = key == TIA_KEY_TAB ? 'T' : key == TIA_KEY_SPACE ? '_' : '/';
        else if (key == DECODED_POINTER)
            text[n++] = 'M';
        else if (key == DECODED_STOP)
            text[n++] = 'Z';
        else if (key)
            text[n++] = (char)key;
    }
    if (!silence && decode_pending(&d))
        text[n++] = '~';
    text[n] = 0;
    return text;
}

struct typing {
    const char *bytes, *keys;
};

static void check_typings(const struct typing *rows, size_t count, bool silence)
{
    for (size_t i = 0; i < count; i++) {
        const char *got = typed(rows[i].bytes, strlen(rows[i].bytes), silence);
        CHECK_MSG(strcmp(got, rows[i].keys) == 0, "row %zu: \"%s\", not \"%s\"", i, got, rows[i].keys);
    }
}

#define TYPINGS(rows, silence) check_typings(rows, sizeof rows / sizeof rows[0], silence)

TEST(letters_and_digits_are_themselves)
{
    static const struct typing rows[] = {
        {"adsw", "adsw"},
        {"0189", "0189"},
        {"ADSW", "adsw"},
        {"\x01\x13\x17\x04", "aswd"},
        {" !,\t\r\n\b\x7f~", "_??T?????"},
        {"+=-_?/", "++--//"},
        {"\x1a", "Z"},
        {"\x03", "!"},
        {"\x1c\x1d\x1f", "???"},
    };
    TYPINGS(rows, false);
}

TEST(a_zero_byte_is_one_other_key)
{
    CHECK(strcmp(typed("\0a", 2, false), "?a") == 0);
}

TEST(arrows_in_every_form)
{
    static const struct typing rows[] = {
        {"\033[A\033[B\033[C\033[D", "UDRL"},
        {"\033OA\033OB\033OC\033OD", "UDRL"},
        {"\033[1;2A\033[1;5B\033[1;3C\033[1;8D", "UDRL"},
        {"\033O5A\033O2D", "UL"},
        {"\033[5~\033[6~", "^v"},
        {"\033[5;2~\033[6;5~", "^v"},
        {"a\033[Da", "aLa"},
    };
    TYPINGS(rows, false);
}

TEST(other_keys_are_one_event_each)
{
    static const struct typing rows[] = {
        {"\033OP\033OQ\033OS", "???"},        /* F1, F2, F4 */
        {"\033[15~\033[24~\033[1;5P", "???"}, /* F5, F12, Ctrl-F1 */
        {"\033[[A\033[[Ea", "??a"},           /* F1 and F5 of the Linux console */
        {"\033[F\033[2~\033[3~\033[4~\033[Z", "?????"},
        {"\033[H\033OH\033[1~\033[7~\033[1;2H", "HHHHH"},
        {"\033[27;5;97~a", "?a"}, /* xterm's modifyOtherKeys */
        {"\033OMa", "?a"},        /* Enter of the keypad */
        {"\xc3\xa9"
         "a",
         "?a"}, /* UTF-8 of two, three and four bytes */
        {"\xe2\x82\xac"
         "a",
         "?a"},
        {"\xf0\x9f\x98\x80"
         "a",
         "?a"},
        {"\xe2\x82"
         "a",
         "?a"},               /* UTF-8 that is cut short */
        {"\x80\xffs", "??s"}, /* no valid UTF-8 */
    };
    TYPINGS(rows, false);
}

TEST(alt_means_the_key)
{
    static const struct typing rows[] = {
        {"\033a\033S\033[A", "asU"},
        {"\033\xc3\xa9"
         "a",
         "?a"},
        {"\033\033[A", "EU"},
        {"\033\033\033", "EE~"},
        {"\033\x03", "!"},
    };
    TYPINGS(rows, false);
}

TEST(a_lone_escape_waits_for_silence)
{
    static const struct typing early[] = {{"\033", "~"}, {"\033[", "~"}, {"\033[1;5", "~"}, {"\033O", "~"}};
    static const struct typing late[] = {
        {"\033", "E"},  {"a\033", "aE"},  {"\033[", "?"},     {"\033O", "o"}, {"\033P", "p"},
        {"\033]", "?"}, {"\033[1;5", ""}, {"\033]11;rg", ""}, {"a", "a"},     {"\033[A", "U"},
    };
    TYPINGS(early, false);
    TYPINGS(late, true);
}

TEST(reports_and_strings_are_no_keys)
{
    static const struct typing rows[] = {
        {"\033[?62;c"
         "a",
         "a"}, /* device attributes */
        {"\033[?2026;2$y"
         "a",
         "a"}, /* a mode report */
        {"\033[>1;2;3ca", "a"},
        {"\033[I\033[Oa", "a"},                     /* the window got and lost the focus */
        {"\033]11;rgb:0000/0000/0000\033\\a", "a"}, /* a colour, ended by ST or BEL */
        {"\033]11;rgb:0000/0000/0000\aa", "a"},
        {"\033P1$r0m\033\\a", "a"},
        {"\033]junk\x03"
         "a",
         "!a"},
    };
    TYPINGS(rows, false);
}

TEST(a_bracketed_paste_is_no_typing)
{
    static const struct typing rows[] = {
        {"\033[200~adsw q \xc3\xa9 \033[A\r\n\033[201~d", "d"},
        {"a\033[200~\033[201~s", "as"},
        {"\033[200~x\x03", "!"},
    };
    TYPINGS(rows, false);
}

TEST(a_broken_sequence_ends)
{
    static const struct typing rows[] = {
        {"\033[1\033[A", "U"},
        {"\033[\x03", "!"},
        {"\033[1;\xc3\xa9"
         "a",
         "?a"},
        {"\033[99999999999999999999~a", "?a"},
        {"\033O\033OA", "U"},
    };
    TYPINGS(rows, false);
}

/* The bytes of sequences in any order: no key is invented, and Ctrl-C always counts. */
TEST(any_bytes_at_all)
{
    static const char common[] = "\033\033\033[[OP]^_?;;0125~ABCD200\a\\\x80\xc3\xe2\xf0 az";
    struct decoder d = {0};

    for (unsigned i = 0; i < 1000000; i++) {
        unsigned r = random_u32();
        uint16_t key = decode_byte(&d, (uint8_t)(r % 8 ? common[r / 8 % (sizeof common - 1)] : (int)(r / 8 % 256)));
        CHECK_MSG(key == DECODED_STOP || (key <= TIA_KEY_OTHER && (key < 0x80 || key >= TIA_KEY_LEFT)),
                  "byte %u: key %u", i, key);
        if (i % 100 == 0)
            CHECK_EQ(decode_byte(&d, 3), TIA_KEY_INTERRUPT);
        if (i % 1000 == 0) {
            (void)decode_silence(&d);
            CHECK(!decode_pending(&d));
        }
    }
}

/* Returns the result of the last byte; *d is the decoder after it. */
static uint16_t decoded(const char *bytes, struct decoder *d)
{
    uint16_t key = 0;

    *d = (struct decoder){0};
    for (; *bytes; bytes++)
        key = decode_byte(d, (uint8_t)*bytes);
    return key;
}

TEST(shift_is_told_with_keys_that_move)
{
    static const struct {
        const char *bytes;
        uint16_t key;
        bool shift;
    } rows[] = {
        {"\033[A", TIA_KEY_UP, false},          {"\033[1;2A", TIA_KEY_UP, true},
        {"\033[1;5D", TIA_KEY_LEFT, true},      {"\033[1;3D", TIA_KEY_LEFT, false},
        {"\033[1;6D", TIA_KEY_LEFT, true},      {"\033[5;5~", TIA_KEY_PAGE_UP, true},
        {"\033[5;2~", TIA_KEY_PAGE_UP, true},   {"\033[6~", TIA_KEY_PAGE_DOWN, false},
        {"\033[1;2A\033[A", TIA_KEY_UP, false}, {"\033[1;2Aa", 'a', false},
    };
    struct decoder d;

    for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++)
        CHECK_MSG(decoded(rows[i].bytes, &d) == rows[i].key && d.shift == rows[i].shift, "row %u", i);
}

/* Reports of the mouse in SGR mode, see xterm's ctlseqs. */
TEST(the_mouse_in_sgr_reports)
{
    static const struct {
        const char *bytes;
        uint16_t result, column, row;
        bool drag;
    } rows[] = {
        {"\033[<35;10;20M", DECODED_POINTER, 10, 20, false},      /* moved without a button */
        {"\033[<0;1;1M", DECODED_POINTER, 1, 1, true},            /* the left button is pressed */
        {"\033[<32;80;24M", DECODED_POINTER, 80, 24, true},       /* moved with the left button */
        {"\033[<36;300;1000M", DECODED_POINTER, 300, 1000, true}, /* the same with Shift */
        {"\033[<0;80;24m", DECODED_POINTER, 80, 24, false},       /* the left button is released */
        {"\033[<2;80;24M", DECODED_POINTER, 80, 24, false},       /* the right button */
        {"\033[<64;8;9M", TIA_KEY_PLUS, 8, 9, false},             /* the wheel */
        {"\033[<65;8;9M", TIA_KEY_MINUS, 8, 9, false},
        {"\033[<66;8;9M", 0, 8, 9, false},
        {"\033[<35;0;4M", 0, 0, 4, false}, /* without a valid position */
        {"\033[<35M", 0, 0, 0, false},
    };
    struct decoder d;

    for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++)
        CHECK_MSG(decoded(rows[i].bytes, &d) == rows[i].result && d.column == rows[i].column && d.row == rows[i].row &&
                      d.drag == rows[i].drag,
                  "row %u: %u, %u", i, d.column, d.row);
}

int main(void)
{
    RUN(letters_and_digits_are_themselves);
    RUN(a_zero_byte_is_one_other_key);
    RUN(arrows_in_every_form);
    RUN(other_keys_are_one_event_each);
    RUN(alt_means_the_key);
    RUN(a_lone_escape_waits_for_silence);
    RUN(reports_and_strings_are_no_keys);
    RUN(a_bracketed_paste_is_no_typing);
    RUN(a_broken_sequence_ends);
    RUN(any_bytes_at_all);
    RUN(shift_is_told_with_keys_that_move);
    RUN(the_mouse_in_sgr_reports);
    return check_status();
}
