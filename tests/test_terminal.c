/* test_terminal.c - keys from a terminal's bytes, and a terminal's bytes from pixels. */
#include <stdlib.h>

#include "check.h"
#include "terminal/colour.h"
#include "terminal/decode.h"
#include "terminal/encode.h"
#include "terminal_model.h"

/* ---- keys ---- */

/* The keys of `bytes`, then (with `silence`) of the silence after them, as text: letters and
 * digits themselves, arrows L R U D, page up and down ^ v, Escape E, Ctrl-C !, others ?. */
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
            text[n++] = "LRUD^v?"[key - TIA_KEY_LEFT];
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
        {" !,\t\r\n\b\x7f~", "?????????"},
        {"\x1a", "z"},
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
        {"\033[H\033[F\033[2~\033[3~\033[Z", "?????"},
        {"\033[27;5;97~a", "?a"}, /* xterm's modifyOtherKeys */
        {"\033OMa", "?a"},        /* Enter of the keypad */
        {"\xc3\xa9"
         "a",
         "?a"}, /* two, three and four bytes of UTF-8 */
        {"\xe2\x82\xac"
         "a",
         "?a"},
        {"\xf0\x9f\x98\x80"
         "a",
         "?a"},
        {"\xe2\x82"
         "a",
         "?a"},               /* cut short */
        {"\x80\xffs", "??s"}, /* no UTF-8 at all */
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

static unsigned next_random(void)
{
    static uint64_t state = 88172645463325252u;

    state = state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(state >> 33);
}

/* Bytes that sequences are made of, in any order: no key is made up, and Ctrl-C always counts. */
TEST(any_bytes_at_all)
{
    static const char common[] = "\033\033\033[[OP]^_?;;0125~ABCD200\a\\\x80\xc3\xe2\xf0 az";
    struct decoder d = {0};

    for (unsigned i = 0; i < 1000000; i++) {
        unsigned r = next_random();
        uint16_t key = decode_byte(&d, (uint8_t)(r % 8 ? common[r / 8 % (sizeof common - 1)] : (int)(r / 8 % 256)));
        CHECK_MSG(key <= TIA_KEY_OTHER && (key < 0x80 || key >= TIA_KEY_LEFT), "byte %u: key %u", i, key);
        if (i % 100 == 0)
            CHECK_EQ(decode_byte(&d, 3), TIA_KEY_INTERRUPT);
        if (i % 1000 == 0) {
            (void)decode_silence(&d);
            CHECK(!decode_pending(&d));
        }
    }
}

/* ---- colours ---- */

/* The nearest colour found by looking at all, in a palette that the test's terminal defines. */
static unsigned nearest_of_all(uint32_t c)
{
    unsigned best = 0, best_distance = UINT32_MAX;

    for (unsigned i = 16; i < 256; i++) {
        uint32_t p = model_palette(i);
        int r = (int)(p >> 16) - (int)(c >> 16), g = (int)(p >> 8 & 255) - (int)(c >> 8 & 255);
        int b = (int)(p & 255) - (int)(c & 255);
        unsigned distance = (unsigned)(r * r + g * g + b * b);
        if (distance < best_distance) {
            best_distance = distance;
            best = i;
        }
    }
    return best;
}

static uint32_t expanded(unsigned pixel)
{
    struct rgb8 c = colour_expand((tia_rgb565)pixel);

    return (uint32_t)c.r << 16 | (uint32_t)c.g << 8 | c.b;
}

TEST(colours_expand_by_bit_replication)
{
    CHECK_EQ(expanded(0x0000), 0x000000);
    CHECK_EQ(expanded(0xffff), 0xffffff);
    CHECK_EQ(expanded(0x8410), 0x848284); /* 10000 100000 10000 */
    CHECK_EQ(expanded(0x0841), 0x080808); /* 00001 000010 00001 */
}

TEST(the_nearest_colour_of_256)
{
    for (unsigned p = 0; p < 65536; p++) {
        uint32_t c = expanded(p);
        struct rgb8 rgb = colour_expand((tia_rgb565)p);
        CHECK_MSG(colour_nearest(rgb) == nearest_of_all(c), "%06x: %u, not %u", c, colour_nearest(rgb),
                  nearest_of_all(c));
    }
}

TEST(who_takes_24_bit_colours)
{
    CHECK(colour_is_direct("xterm-256color", "truecolor"));
    CHECK(colour_is_direct(NULL, "24bit"));
    CHECK(colour_is_direct("xterm-direct", NULL));
    CHECK(colour_is_direct("xterm-kitty", ""));
    CHECK(!colour_is_direct("xterm-256color", NULL));
    CHECK(!colour_is_direct("xterm-direct2", NULL));
    CHECK(!colour_is_direct("linux", "yes"));
    CHECK(!colour_is_direct(NULL, NULL));
}

/* ---- pictures ---- */

struct picture {
    unsigned width, height, columns, rows; /* and the window's cells */
    tia_rgb565 *pixels;
    struct grid grid;
    struct model model;
};

static struct picture picture_new(unsigned width, unsigned height, unsigned columns, unsigned rows, bool direct)
{
    struct picture p = {width, height, columns, rows, calloc((size_t)width * height, sizeof(tia_rgb565)), {0}, {0}};

    p.grid.direct = direct;
    CHECK_EQ(grid_resize(&p.grid, width, height, columns, rows), TIA_OK);
    p.model = model_new(columns, rows);
    p.model.wrap = false;
    return p;
}

static void picture_free(struct picture *p)
{
    free(p->pixels);
    grid_free(&p->grid);
    model_free(&p->model);
}

/* Draws a frame: how many bytes it took. */
static size_t show(struct picture *p)
{
    struct text text = {0};

    grid_draw(&p->grid, p->pixels, p->height, &text);
    CHECK(!text.failed);
    model_feed(&p->model, text.bytes, text.count);
    CHECK_EQ(p->model.unknown, 0);
    CHECK(!p->model.synchronised);
    size_t count = text.count;
    text_free(&text);
    return count;
}

static uint32_t wanted(const struct picture *p, unsigned x, unsigned y)
{
    unsigned left = (p->columns - p->width) / 2, top = (p->rows - (p->height + 1) / 2) / 2 * 2;

    if (x < left || x >= left + p->width || y < top || y >= top + p->height)
        return 0;
    uint32_t c = expanded(p->pixels[(size_t)(y - top) * p->width + x - left]);
    return p->grid.direct ? c : model_palette(nearest_of_all(c));
}

static void check_shown(const struct picture *p)
{
    for (unsigned y = 0; y < 2 * p->rows; y++)
        for (unsigned x = 0; x < p->columns; x++)
            CHECK_MSG(model_pixel(&p->model, x, y) == wanted(p, x, y), "pixel %u,%u is %06x, not %06x", x, y,
                      model_pixel(&p->model, x, y), wanted(p, x, y));
}

/* Random changes of random pixels, some of them to what they are. */
static void scribble(struct picture *p, unsigned count)
{
    static const tia_rgb565 few[] = {0xffff, 0x0000, 0xf800, 0x07e0, 0x001f};

    while (count-- > 0) {
        unsigned r = next_random();
        tia_rgb565 colour = r % 3 == 0 ? (tia_rgb565)next_random() : few[next_random() % 5];
        p->pixels[next_random() % (p->width * p->height)] = colour;
    }
}

static void check_pictures(bool direct)
{
    static const unsigned sizes[][4] = {{1, 1, 1, 1},   {1, 2, 1, 1},   {80, 48, 80, 24}, {79, 47, 80, 24},
                                        {3, 7, 80, 24}, {5, 4, 6, 100}, {300, 10, 300, 5}};

    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        struct picture p = picture_new(sizes[i][0], sizes[i][1], sizes[i][2], sizes[i][3], direct);
        for (unsigned frame = 0; frame < 30; frame++) {
            (void)show(&p);
            check_shown(&p);
            scribble(&p, next_random() % (p.width * p.height / (1 + frame) + 2));
        }
        picture_free(&p);
    }
}

TEST(pictures_in_24_bit)
{
    check_pictures(true);
}
TEST(pictures_in_256_colours)
{
    check_pictures(false);
}

TEST(a_white_picture_is_drawn_at_first)
{
    struct picture p = picture_new(4, 4, 4, 2, true);

    memset(p.pixels, 0xff, 4 * 4 * sizeof *p.pixels);
    CHECK(show(&p) > 0);
    check_shown(&p);
    picture_free(&p);
}

TEST(only_changes_are_written)
{
    struct picture p = picture_new(80, 48, 80, 24, true);

    (void)show(&p);
    CHECK_EQ(show(&p), 0);
    p.model.printed = 0;
    p.pixels[5 * 80 + 7] = 0xf800;
    p.pixels[30 * 80 + 79] = 0x07e0;
    p.pixels[32 * 80 + 0] = 0x001f;
    (void)show(&p);
    CHECK_EQ(p.model.printed, 3);
    check_shown(&p);
    grid_forget(&p.grid);
    (void)show(&p);
    CHECK_EQ(p.model.printed, 3 + 80 * 24);
    picture_free(&p);
}

/* One colour: 80 spaces a row, one movement of at most 6 bytes a row, one colour, two brackets. */
TEST(a_plain_picture_is_short)
{
    struct picture p = picture_new(80, 48, 80, 24, true);
    size_t count = show(&p);

    CHECK_MSG(count <= 24 * (80 + 6) + 30, "%zu bytes", count);
    picture_free(&p);
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
    RUN(colours_expand_by_bit_replication);
    RUN(the_nearest_colour_of_256);
    RUN(who_takes_24_bit_colours);
    RUN(pictures_in_24_bit);
    RUN(pictures_in_256_colours);
    RUN(a_white_picture_is_drawn_at_first);
    RUN(only_changes_are_written);
    RUN(a_plain_picture_is_short);
    return check_status();
}
