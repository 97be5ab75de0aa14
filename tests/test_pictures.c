/* Pictures on terminals: a terminal that answers, and the bytes of sixel and kitty's protocol, decoded. */
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <time.h>

#include "pseudo.h"
#include "terminal/answers.h"
#include "terminal/pictures.h"
#include "terminal/terminal.h"
#include "terminal/terminal_colour.h"

#include "random.h"

#define KITTY_OK "\033_Gi=31;OK\033\\"

/* ---- a terminal that answers, or not ---- */

#ifdef TIA_HAVE_CHAFA
struct result {
    struct tia_mode mode;
    char format[40];
    long ms;
    bool same; /* the terminal's modes are the same as before */
};

static long now_ms(void)
{
    struct timespec t;

    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (long)t.tv_sec * 1000 + t.tv_nsec / 1000000;
}

static const char *chosen; /* the user's choice, the text after "terminal:" */

/* Runs the program: opens the display on its controlling terminal and reports its format. */
static void play_program(const char *name, const char *term, int out)
{
    char why[PORT_WHY] = "";
    struct port_wish wish = {.device = chosen, .why = why};
    struct result r = {.ms = now_ms()};
    struct termios after;

    (void)setsid();
    int fd = open(name, O_RDWR);
    (void)dup2(fd, STDIN_FILENO);
    (void)dup2(fd, STDOUT_FILENO);
    (void)setenv("TERM", term, 1);
    void *t = port_terminal_create(&wish);
    if (port_terminal_display.open(t, &r.mode))
        (void)snprintf(r.format, sizeof r.format, "%.39s", why);
    else
        (void)snprintf(r.format, sizeof r.format, "%.39s", r.mode.format);
    r.ms = now_ms() - r.ms;
    r.same = tcgetattr(fd, &after) == 0 && after.c_lflag == before.c_lflag;
    (void)!write(out, &r, sizeof r);
    port_terminal_display.close(t);
    _exit(0);
}

static bool kitty_asked;

/* Answers the query for the device's attributes with `text`, until the program has reported. */
static struct result play_terminal(const char *text, int in)
{
    struct pollfd two[2] = {{.fd = master, .events = POLLIN}, {.fd = in, .events = POLLIN}};
    struct result r = {.ms = -1};
    char c, seen[3] = "";

    kitty_asked = false;
    while (poll(two, 2, 5000) > 0 && !(two[1].revents & (POLLIN | POLLHUP))) {
        if (two[0].revents & POLLIN && read(master, &c, 1) == 1) {
            seen[0] = seen[1];
            seen[1] = seen[2];
            seen[2] = c;
            kitty_asked |= memcmp(seen, "\033_G", 3) == 0;
            if (memcmp(seen, "\033[c", 3) == 0)
                (void)!write(master, text, strlen(text));
        }
    }
    (void)!read(in, &r, sizeof r);
    return r;
}

static struct result opened(const char *answer, const char *term, struct winsize size)
{
    struct result r = {.ms = -1};
    int told[2];

    if (!open_terminal() || pipe(told) != 0)
        return r;
    (void)ioctl(terminal, TIOCSWINSZ, &size);
    pid_t child = fork();
    if (child == 0)
        play_program(ptsname(master), term, told[1]);
    (void)close(told[1]);
    r = play_terminal(answer, told[0]);
    (void)close(told[0]);
    close_terminal();
    (void)kill(child, SIGKILL);
    (void)waitpid(child, NULL, 0);
    CHECK(r.ms >= 0 && r.ms < 2000 && r.same);
    return r;
}

static void check_mode(const char *answer, const char *term, unsigned width, unsigned height, const char *format)
{
    struct result r = opened(answer, term, (struct winsize){24, 80, 800, 480});

    CHECK_MSG(r.mode.width == width && r.mode.height == height && !strcmp(r.format, format), "%s: %ux%u %s", answer,
              r.mode.width, r.mode.height, r.format);
    CHECK_MSG(kitty_asked == !strcmp(term, "xterm"), "%s", term);
}

/* Checks the user's choice, or the reason why it was refused. */
static void check_chosen(const char *answer, const char *term, const char *said)
{
    struct result r = opened(answer, term, (struct winsize){24, 80, 800, 480});

    CHECK_MSG(strstr(r.format, said) && !kitty_asked, "%s, chosen in %s: %s", chosen, term, r.format);
}

#endif

TEST(terminals_are_asked)
{
#ifdef TIA_HAVE_CHAFA
    (void)unsetenv("COLORTERM");
    check_mode("\033[?62;4c", "xterm", 800, 456, "sixel");
    check_mode("\033[?2;0;303;207S\033[?62;4c", "xterm", 300, 198, "sixel"); /* whole cells and bands */
    check_mode(KITTY_OK "\033[?2;0;303;207S\033[?62;4c", "xterm", 800, 460, "kitty's pictures");
    check_mode("\033[?62;4c", "tmux-256color", 800, 456, "sixel");
    check_mode("\033[?62c", "screen", 320, 192, "symbols, 256 colours");
    check_mode("", "xterm", 80, 48, "256 colours");
    (void)setenv("COLORTERM", "truecolor", 1);
    check_mode("\033[?62c", "xterm", 320, 192, "symbols, 24-bit colours");
    struct result r = opened("\033[?62;4c", "xterm", (struct winsize){24, 80, 0, 0});
    CHECK(r.mode.width == 80 && r.mode.height == 48);
    chosen = "kitty";
    check_chosen("\033[?62c", "tmux-256color", "tmux and screen show no");
    check_chosen(KITTY_OK "\033[?62c", "screen", "tmux and screen show no");
    check_chosen("", "xterm", "kitty's pictures");
    chosen = "sixel";
    check_chosen("\033[?62c", "tmux-256color", "tmux or screen has no");
    check_chosen("\033[?62;4c", "tmux-256color", "sixel");
    check_chosen("", "xterm", "sixel");
    chosen = NULL;
#else
    SKIP("built without libchafa (libchafa-dev)");
#endif
}

/* ---- pictures, decoded ---- */

#ifdef TIA_HAVE_CHAFA
#define WIDTH 60
#define HEIGHT 40

static tia_rgb565 pixels[WIDTH * HEIGHT];
static uint8_t decoded[4 * WIDTH * HEIGHT + 4000];

static int base64(char c)
{
    const char *all = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/", *at = strchr(all, c);
    return c && at ? (int)(at - all) : -1;
}

/* Decodes all data of the APC sequences, one after another. */
static size_t decode_kitty(const char *text, unsigned *width, unsigned *height)
{
    unsigned bits = 0, have = 0;
    size_t count = 0;

    for (const char *s = strstr(text, "\033_G"); s; s = strstr(s, "\033_G")) {
        const char *end = strstr(s, "\033\\"), *payload = memchr(s, ';', (size_t)(end - s));
        const char *w = strstr(s, "s="), *h = strstr(s, "v=");
        if (w && w < end && h && h < end) {
            *width = (unsigned)strtoul(w + 2, NULL, 10);
            *height = (unsigned)strtoul(h + 2, NULL, 10);
        }
        have = 0; /* each sequence ends with its own padding */
        for (; payload && ++payload < end;) {
            if (base64(*payload) < 0)
                continue;
            bits = bits << 6 | (unsigned)base64(*payload);
            have += 6;
            if (have < 8)
                continue;
            if (count < sizeof decoded)
                decoded[count++] = (uint8_t)(bits >> (have - 8));
            have -= 8;
        }
        s = end;
    }
    return count;
}

static uint32_t palette[256];
static uint32_t shown[HEIGHT + 12][WIDTH + 12];

static unsigned number(const char **s)
{
    char *end;
    unsigned n = (unsigned)strtoul(*s, &end, 10);

    *s = end;
    return n;
}

/* Reads a colour: #n;2;r;g;b in per cent, or #n. */
static unsigned take_colour(const char **s)
{
    unsigned n = number(s) % 256, c[4] = {0};

    for (int i = 0; i < 4 && **s == ';'; i++) {
        ++*s;
        c[i] = number(s);
    }
    if (c[0] == 2)
        palette[n] = 1u << 24 | (c[1] * 255 + 50) / 100 << 16 | (c[2] * 255 + 50) / 100 << 8 | (c[3] * 255 + 50) / 100;
    return n;
}

/* Decodes sixels by the VT340's manual; true if all of them are valid. */
static bool decode_sixel(const char *text)
{
    const char *s = strstr(text, "\033P");
    unsigned x = 0, y = 0, colour = 0, repeat = 1;

    memset(shown, 0, sizeof shown);
    for (s = s ? strchr(s, 'q') + 1 : ""; *s && *s != '\033';) {
        char c = *s++;
        if (c == '#') {
            colour = take_colour(&s);
        } else if (c == '!') {
            repeat = number(&s);
        } else if (c == '$' || c == '-') {
            y += c == '-' ? 6 : 0;
            x = 0;
        } else if (c == '"') {
            while (*s == ';' || (*s >= '0' && *s <= '9'))
                s++;
        } else if (c >= '?' && c <= '~') {
            for (; repeat > 0; repeat--, x++)
                for (unsigned i = 0; i < 6; i++)
                    if ((unsigned)(c - '?') >> i & 1 && x < WIDTH + 12 && y + i < HEIGHT + 12)
                        shown[y + i][x] = palette[colour];
            repeat = 1;
        } else if (c != '\n' && c != '\r') {
            return false;
        }
    }
    return *s == '\033' && s[1] == '\\';
}

/* Draws patches of eleven colours, some a pixel high or wide. */
static void draw_patches(void)
{
    tia_rgb565 colours[11];

    for (int i = 0; i < 11; i++)
        colours[i] = (tia_rgb565)random_u32();
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++)
            pixels[y * WIDTH + x] = colours[(x / 7 + y / 5 + (x == 13 ? 1u : 0u) + (y == 22 ? 3u : 0u)) % 11];
}

static const struct cell cell = {10, 20};

/* Checks a strip of a picture: its position and its pixels. */
static void check_kitty(unsigned columns, struct strip strip)
{
    struct text text = {0};
    unsigned across = 10 * columns, down = strip.rows, width = 0, height = 0;
    const tia_rgb565 *want = pixels + strip.first * across;
    char place[16];

    for (size_t i = 0; i < WIDTH * HEIGHT; i++)
        pixels[i] = (tia_rgb565)random_u32();
    pictures_draw(PICTURES_KITTY, pixels, across, strip, &cell, &text);
    char *whole = calloc(1, text.count + 1);
    memcpy(whole, text.bytes, text.count);
    size_t count = decode_kitty(whole, &width, &height);
    CHECK(width == across && height == down);
    (void)snprintf(place, sizeof place, "\033[%uH", strip.first / 20 + 1);
    CHECK(strstr(whole, place));
    CHECK(!strip.first == !!strstr(whole, "a=d")); /* the picture before is removed once */
    CHECK_EQ(count, 4 * across * down);
    for (size_t i = 0; i < across * down; i++) {
        const struct rgb8 c = colour_expand(want[i]);
        const uint8_t *d = decoded + 4 * i;
        CHECK_MSG(d[0] == c.r && d[1] == c.g && d[2] == c.b && d[3] == 255,
                  "%ux%u, %zu: %02x%02x%02x %02x, not %02x%02x%02x", across, down, i, d[0], d[1], d[2], d[3], c.r, c.g,
                  c.b);
    }
    free(whole);
    text_free(&text);
}

/* The last part may have one byte or two in its last group. */
TEST(kittys_pictures)
{
    for (unsigned columns = 1; columns <= 6; columns++) {
        check_kitty(columns, (struct strip){0, 20});
        check_kitty(columns, (struct strip){0, 40});
        check_kitty(columns, (struct strip){20, 20});
    }
}

static unsigned apart(uint32_t a, uint32_t b)
{
    return a > b ? a - b : b - a;
}

/* Sixel's channels have 101 levels: 255/100 apart, and one more for libchafa's own palette. */
TEST(sixel)
{
    for (int n = 0; n < 5; n++) {
        struct text text = {0};
        draw_patches();
        pictures_draw(PICTURES_SIXEL, pixels, WIDTH, (struct strip){0, 36}, &cell, &text);
        char *whole = calloc(1, text.count + 1);
        memcpy(whole, text.bytes, text.count);
        CHECK(decode_sixel(whole));
        for (unsigned y = 0; y < 36; y++)
            for (unsigned x = 0; x < WIDTH; x++) {
                struct rgb8 c = colour_expand(pixels[y * WIDTH + x]);
                uint32_t got = shown[y][x];
                CHECK_MSG(got >> 24 && apart(got >> 16 & 255, c.r) < 5 && apart(got >> 8 & 255, c.g) < 5 &&
                              apart(got & 255, c.b) < 5,
                          "(%u, %u): %06x, not %02x%02x%02x", x, y, (unsigned)got, c.r, c.g, c.b);
            }
        free(whole);
        text_free(&text);
    }
}
#else
TEST(kittys_pictures)
{
    SKIP("built without libchafa (libchafa-dev)");
}

TEST(sixel)
{
    SKIP("built without libchafa (libchafa-dev)");
}
#endif

int main(void)
{
    (void)setenv("LC_ALL", "C.UTF-8", 1); /* symbols need UTF-8 */
    RUN(terminals_are_asked);
    RUN(kittys_pictures);
    RUN(sixel);
    return check_status();
}
