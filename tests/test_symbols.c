/* Symbols on terminals: the text sent, decoded by Unicode's description of the block elements; the names of formats;
 * and keys typed during the terminal's query. */
#include <sys/ioctl.h>
#include <sys/wait.h>

#include "pseudo.h"
#include "terminal/symbols.h"
#include "terminal/terminal.h"
#include "terminal/terminal_colour.h"
#include "terminal/ways.h"

#include "random.h"

TEST(ways_by_name)
{
    static const struct {
        const char *name;
        bool chosen;
        enum pictures pictures;
    } names[] = {{"automatic", false, PICTURES_HALF_BLOCKS},
                 {"halfblocks", true, PICTURES_HALF_BLOCKS},
                 {"symbols", true, PICTURES_SYMBOLS},
                 {"sixel", true, PICTURES_SIXEL},
                 {"kitty", true, PICTURES_KITTY}};
    struct way way;

    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        CHECK(ways_find(names[i].name, &way) && way.chosen == names[i].chosen && way.pictures == names[i].pictures &&
              strstr(WAYS_NAMES, names[i].name));
    CHECK(!ways_find(NULL, &way) && !ways_find("", &way) && !ways_find("six", &way) && !ways_find("sixels", &way));
}

#ifdef TIA_HAVE_CHAFA
/* ---- the text sent ---- */

#define COLUMNS 20
#define ROWS 12
#define WIDTH (COLUMNS * SYMBOLS_WIDTH)
#define HEIGHT (ROWS * SYMBOLS_HEIGHT)

struct cell {
    uint32_t code, fore, back; /* character; colours: 0xrrggbb, or an index below 256 */
};

static tia_rgb565 pixels[WIDTH * HEIGHT];
static struct cell screen[ROWS][COLUMNS];
static unsigned written; /* number of cells of the last text */

/* The quadrants of U+2596 to U+259F: upper left 1, upper right 2, lower left 4, lower right 8. */
static const uint8_t quadrants[] = {4, 8, 1, 13, 9, 7, 11, 2, 6, 14};

/* Returns 1 if a block element inks this point, in eighths of the cell, by Unicode, else 0; -1 for other characters. */
static int is_inked(uint32_t code, unsigned x, unsigned y)
{
    if (code == ' ')
        return 0;
    if (code == 0x2580)
        return y < 4;
    if (code >= 0x2581 && code <= 0x2588)
        return 8 - y <= code - 0x2580;
    if (code >= 0x2589 && code <= 0x258f)
        return x < 0x2590 - code;
    if (code == 0x2590)
        return x >= 4;
    if (code == 0x2594)
        return y == 0;
    if (code == 0x2595)
        return x == 7;
    if (code >= 0x2596 && code <= 0x259f)
        return quadrants[code - 0x2596] >> ((x >= 4 ? 1 : 0) + (y >= 4 ? 2 : 0)) & 1;
    return -1;
}

static unsigned parameters(const char **s, unsigned *list)
{
    unsigned count = 0;

    do {
        char *end;
        list[count++ % 6] = (unsigned)strtoul(*s, &end, 10);
        *s = end;
    } while (*(*s)++ == ';');
    return count;
}

static uint32_t take_utf8(const char **s)
{
    const uint8_t *b = (const uint8_t *)*s;

    *s += *b < 0x80 ? 1 : 3;
    return *b < 0x80 ? *b : (*b & 15u) << 12 | (b[1] & 63u) << 6 | (b[2] & 63u);
}

/* Decodes positions, colours and characters onto the screen; an unknown sequence is an error. */
static void play(const struct text *text)
{
    char *whole = calloc(1, text->count + 1);
    unsigned x = 0, y = 0, p[6];
    struct cell pen = {0, 0, 0};

    memcpy(whole, text->bytes, text->count);
    written = 0;
    for (const char *s = whole; *s;) {
        if (strncmp(s, "\033[?2026", 7) == 0) {
            s += 8;
            continue;
        }
        if (*s == '\033') {
            s += 2;
            unsigned n = parameters(&s, p);
            uint32_t colour = n == 5 ? p[2] << 16 | p[3] << 8 | p[4] : p[2];
            CHECK((s[-1] == 'H' && n == 2) || (s[-1] == 'm' && n == 5 && p[1] == 2) ||
                  (s[-1] == 'm' && n == 3 && p[1] == 5));
            if (s[-1] == 'H')
                y = p[0] - 1, x = p[1] - 1;
            else if (p[0] == 38)
                pen.fore = colour;
            else
                pen.back = colour;
            continue;
        }
        pen.code = take_utf8(&s);
        CHECK(x < COLUMNS && y < ROWS);
        if (x < COLUMNS && y < ROWS)
            screen[y][x++] = pen;
        written++;
    }
    free(whole);
}

static struct symbols symbols;

static void add_frame(bool direct, struct text *text)
{
    const unsigned part = 5 * SYMBOLS_HEIGHT;
    symbols_draw(&symbols, pixels, WIDTH, HEIGHT, (struct strip){0, part}, direct, text);
    symbols_draw(&symbols, pixels, WIDTH, HEIGHT, (struct strip){part, HEIGHT - part}, direct, text);
}

static void draw(bool direct)
{
    struct text text = {0};

    add_frame(direct, &text);
    CHECK(!text.failed);
    play(&text);
    text_free(&text);
}

static uint32_t code_of(tia_rgb565 pixel)
{
    struct rgb8 c = colour_expand(pixel);

    return (uint32_t)c.r << 16 | (uint32_t)c.g << 8 | c.b;
}

/* Draws two colours in each cell: halves, quarters of the height or quadrants. */
static void draw_patches(void)
{
    for (unsigned cell = 0; cell < COLUMNS * ROWS; cell++) {
        tia_rgb565 a = (tia_rgb565)random_u32(), b = (tia_rgb565)~a;
        unsigned set = cell % 17, left = cell % COLUMNS * SYMBOLS_WIDTH, top = cell / COLUMNS * SYMBOLS_HEIGHT;
        for (unsigned i = 0; i < SYMBOLS_WIDTH * SYMBOLS_HEIGHT; i++) {
            unsigned x = i % SYMBOLS_WIDTH, y = i / SYMBOLS_WIDTH;
            bool is_a = set == 16 ? y >= 2 : set >> ((x >= 2 ? 1 : 0) + (y >= 4 ? 2 : 0)) & 1;
            pixels[(top + y) * WIDTH + left + x] = is_a ? a : b;
        }
    }
}

/* Checks each point's colour; a palette's colours are dithered, so only that they are of the palette. */
static void check_patches(bool direct)
{
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++) {
            struct cell c = screen[y / SYMBOLS_HEIGHT][x / SYMBOLS_WIDTH];
            int inked = is_inked(c.code, x % SYMBOLS_WIDTH * 2, y % SYMBOLS_HEIGHT);
            uint32_t got = inked ? c.fore : c.back, want = code_of(pixels[y * WIDTH + x]);
            bool right = direct ? got == want : got >= 16 && got < 256;
            CHECK_MSG(inked >= 0 && right, "(%u, %u): U+%04x %06x, not %06x", x, y, (unsigned)c.code, (unsigned)got,
                      (unsigned)want);
        }
}

TEST(two_colours_in_a_cell)
{
    for (int n = 0; n < 6; n++) {
        symbols_forget(&symbols);
        draw_patches();
        draw(n % 2 == 0);
        CHECK_EQ(written, COLUMNS * ROWS);
        check_patches(n % 2 == 0);
    }
    symbols_free(&symbols);
}

/* Draws the halves of one cell, and checks that no other cell is sent. */
static void draw_halves(tia_rgb565 upper, tia_rgb565 lower)
{
    for (unsigned y = 0; y < SYMBOLS_HEIGHT; y++)
        for (unsigned x = 0; x < SYMBOLS_WIDTH; x++)
            pixels[(5 * SYMBOLS_HEIGHT + y) * WIDTH + 7 * SYMBOLS_WIDTH + x] = y < SYMBOLS_HEIGHT / 2 ? upper : lower;
    draw(true);
    CHECK_EQ(written, 1);
    check_patches(true);
}

TEST(what_did_not_change_is_not_sent)
{
    struct text text = {0};

    draw_patches();
    draw(true);
    add_frame(true, &text);
    CHECK_EQ(text.count, 0);
    draw_halves(0x1234, 0x1234); /* next, only the background changes, or only the foreground */
    draw_halves(0x1234, 0xffff);
    draw_halves(0x1234, 0xf800);
    draw_halves(0x001f, 0xf800);
    symbols_forget(&symbols);
    draw(true);
    CHECK_EQ(written, COLUMNS * ROWS);
    symbols_free(&symbols);
    text_free(&text);
}

/* Pictures are drawn in blocks, box drawing and Braille, each one column wide. */
TEST(any_picture)
{
    unsigned lines = 0;

    for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
        pixels[i] = i % WIDTH < WIDTH / 2 ? (tia_rgb565)random_u32() : i / WIDTH % 8 == 3 ? 0xffff : 0;
    draw(true);
    for (unsigned i = 0; i < COLUMNS * ROWS; i++) {
        uint32_t code = screen[i / COLUMNS][i % COLUMNS].code;
        CHECK_MSG(code == ' ' || (code >= 0x2500 && code <= 0x259f) || (code >= 0x2800 && code <= 0x28ff), "U+%04x",
                  (unsigned)code);
        lines += code >= 0x2500 && code < 0x2580;
    }
    CHECK(lines > 0);
    symbols_free(&symbols);
}

/* ---- on a terminal ---- */

struct told {
    struct tia_mode mode;
    char format[40], why[80], keys[40]; /* keys: letters themselves, ^ for all others */
};

/* Opens the program's keyboard and display, and reports the keys up to z. */
static void play_program(const char *name, const char *device, int out)
{
    char why[PORT_WHY] = "";
    struct port_wish wish = {.why = why}, wish_display = {.why = why, .device = device};
    struct told r = {.format = ""};
    struct tia_event event;
    size_t count = 0;

    (void)setsid();
    int fd = open(name, O_RDWR);
    (void)dup2(fd, STDIN_FILENO);
    (void)dup2(fd, STDOUT_FILENO);
    void *keyboard = port_tty_create(&wish), *t = port_terminal_create(&wish_display);
    if (port_tty_input.open(keyboard) || port_terminal_display.open(t, &r.mode))
        (void)snprintf(r.why, sizeof r.why, "%.79s", why);
    else
        (void)snprintf(r.format, sizeof r.format, "%.39s", r.mode.format);
    for (int i = 0; i < 200 && !*r.why && !strchr(r.keys, 'z'); i++) {
        (void)port_tty_input.wait(keyboard, 20);
        while (port_tty_input.poll(keyboard, &event) > 0 && count < sizeof r.keys - 1)
            r.keys[count++] = event.key >= 'a' && event.key <= 'z' ? (char)event.key : '^';
    }
    (void)!write(out, &r, sizeof r);
    port_terminal_display.close(t);
    port_tty_input.close(keyboard);
    _exit(0);
}

static bool asked;

/* Types `text` when the terminal's attributes are queried, and `later` when the alternate screen is entered. */
static void play_terminal(const char *text, const char *later, int in)
{
    struct pollfd two[2] = {{.fd = master, .events = POLLIN}, {.fd = in, .events = POLLIN}};
    char c, seen[9] = "";

    asked = false;
    while (poll(two, 2, 5000) > 0 && !(two[1].revents & (POLLIN | POLLHUP))) {
        if (!(two[0].revents & POLLIN) || read(master, &c, 1) != 1)
            continue;
        memmove(seen, seen + 1, 7);
        seen[7] = c;
        if (memcmp(seen + 5, "\033[c", 3) == 0) {
            asked = true;
            (void)!write(master, text, strlen(text));
        }
        if (memcmp(seen, "\033[?1049h", 8) == 0)
            (void)!write(master, later, strlen(later));
    }
}

static struct told opened(const char *device, const char *text, const char *later, unsigned cell_width)
{
    struct winsize size = {24, 80, (unsigned short)(80 * cell_width), 480};
    struct told r = {.why = "told nothing"};
    int pipes[2];

    if (!open_terminal() || pipe(pipes) != 0)
        return r;
    (void)ioctl(terminal, TIOCSWINSZ, &size);
    pid_t child = fork();
    if (child == 0)
        play_program(ptsname(master), device, pipes[1]);
    (void)close(pipes[1]);
    play_terminal(text, later, pipes[0]);
    (void)!read(pipes[0], &r, sizeof r);
    (void)close(pipes[0]);
    close_terminal();
    (void)kill(child, SIGKILL);
    (void)waitpid(child, NULL, 0);
    return r;
}

static void check_way(const char *device, unsigned cell_width, unsigned width, unsigned height, const char *format)
{
    struct told r = opened(device, "\033[?62;4c", "z", cell_width);

    CHECK_MSG(r.mode.width == width && r.mode.height == height && !strcmp(r.format, format), "%s: %ux%u %s%s", device,
              r.mode.width, r.mode.height, r.format, r.why);
    CHECK_MSG(asked == !strcmp(device, "automatic"), "%s", device);
}

static void check_refused(const char *device, const char *why)
{
    struct told r = opened(device, "", "", 0);

    CHECK_MSG(!strcmp(r.why, why), "%s: %s", device, r.why);
}

TEST(ways_that_are_chosen)
{
    check_way("halfblocks", 10, 80, 48, "24-bit colours");
    check_way("symbols", 0, 320, 192, "symbols, 24-bit colours");
    check_way("sixel", 10, 800, 456, "sixel");
    check_way("kitty", 10, 800, 460, "kitty's pictures");
    check_way("automatic", 10, 800, 456, "sixel");
    check_refused("sixel", "terminal: does not report its size in pixels");
    check_refused("braille", "braille: is not a device, nor " WAYS_NAMES);
    (void)setenv("LC_ALL", "C", 1);
    check_refused("symbols", "terminal: symbols need a locale with UTF-8");
    struct told r = opened(NULL, "\033[?62c", "z", 10);
    CHECK(asked && r.mode.width == 40 && r.mode.height == 24 && !strcmp(r.format, "24-bit colours"));
    (void)setenv("LC_ALL", "C.UTF-8", 1);
}

static void check_keys(const char *text, const char *later, const char *keys)
{
    struct told r = opened(NULL, text, later, 10);

    CHECK_MSG(asked && !strcmp(r.keys, keys), "%s then %s: %s, not %s %s", text, later, r.keys, keys, r.why);
}

#define KITTY_OK "\033_Gi=31;OK\033\\"

/* Keys typed before, between and after the answers arrive, also on a terminal that does not answer. */
TEST(keys_while_it_is_asked)
{
    check_keys("ab" KITTY_OK "c\033[A\033[?62;4cd", "ez", "abc^dez");
    check_keys("q", "z", "qz");
    check_keys("\033[?62;4c", "z", "z");
    check_keys("", "kz", "kz");
}
#else
#define NOT_BUILT(name)                                                                                                \
    TEST(name)                                                                                                         \
    {                                                                                                                  \
        SKIP("built without libchafa (libchafa-dev)");                                                                 \
    }
NOT_BUILT(two_colours_in_a_cell)
NOT_BUILT(what_did_not_change_is_not_sent)
NOT_BUILT(any_picture)
NOT_BUILT(ways_that_are_chosen)
NOT_BUILT(keys_while_it_is_asked)
#endif

int main(void)
{
    (void)setenv("COLORTERM", "truecolor", 1);
    (void)setenv("TERM", "xterm", 1);
    (void)setenv("LC_ALL", "C.UTF-8", 1);
    RUN(ways_by_name);
    RUN(two_colours_in_a_cell);
    RUN(what_did_not_change_is_not_sent);
    RUN(any_picture);
    RUN(ways_that_are_chosen);
    RUN(keys_while_it_is_asked);
    return check_status();
}
