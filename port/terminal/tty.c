/* tty.c - the terminal's keyboard as an input.
 *
 * The terminal is read byte by byte (termios without ICANON and ECHO), and Ctrl-C, Ctrl-Z and Ctrl-S are keys like any
 * other (without ISIG and IXON); but Ctrl-Z stops a program whose keys are the viewer's. VMIN is 1: with 0, a read
 * without input looks like the end of a file, and a shell exits if it finds the terminal in that state.
 */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "clock.h"
#include "console/console.h"
#include "console/guardian.h"
#include "console/node.h"
#include "descriptor.h"
#include "key_decoder.h"
#include "picture_place.h"
#include "terminal.h"
#include "terminal_colour.h"
#include "typed.h"
#include "window_signals.h"

/* Time limit for the rest of a sequence after an ESC. The bytes of one key are sent at once; 50 ms allow for a
 * network's packets, and are too short for a person's next key. */
#define SILENCE_US 50000

#define BEHIND_MS 100 /* time between two checks that the terminal is in front */

/* Bracketed paste: pasted text can be distinguished from typed keys. */
static const char paste_on[] = "\033[?2004h", paste_off[] = "\033[?2004l";

/* Bracketed paste, and reports of all movements of the mouse, with coordinates of any size. */
static const char mouse_on[] = "\033[?2004h\033[?1003h\033[?1006h", mouse_off[] = "\033[?1006l\033[?1003l\033[?2004l";

struct tty {
    const char *device;
    char *why;
    const char *on, *off; /* texts to be sent on open and on close */
    bool stops;           /* Ctrl-Z stops the program */
    int fd;               /* -1: closed */
    bool controlling;     /* `fd` is the controlling terminal, which the display may have queried */
    bool raw;             /* `before` holds the modes that close restores */
    struct termios before, now;
    struct terminal_stops since; /* counts of stops when `now` was last set */
    struct decoder decoder;
    uint64_t last_us;          /* time of the last byte */
    uint8_t bytes[TYPED_MOST]; /* bytes not yet decoded: [next, count) */
    size_t next, count;
};

static int failed(const struct tty *tty, const char *what, const char *why)
{
    (void)snprintf(tty->why, PORT_WHY, "%s: %s", what, why);
    return TIA_ERR_DEVICE;
}

static const char *name_of(const struct tty *tty)
{
    return tty->device ? tty->device : "terminal's keyboard";
}

static int open_terminal(struct tty *tty)
{
    char text[PORT_WHY];

    if (!tty->device && isatty(STDIN_FILENO))
        tty->fd = descriptor_copy(STDIN_FILENO, O_RDWR);
    else
        tty->fd = descriptor_open(tty->device ? tty->device : "/dev/tty", O_RDWR);
    if (tty->fd < 0 && !tty->device)
        return failed(tty, "terminal's keyboard", "standard input is not a terminal and there is no controlling one");
    if (tty->fd < 0)
        return failed(tty, tty->device, node_error(errno, text));
    return TIA_OK;
}

static int make_raw(struct tty *tty)
{
    struct termios *raw = &tty->now;
    char text[PORT_WHY];

    if (tcgetattr(tty->fd, &tty->before) != 0)
        return failed(tty, name_of(tty), "is not a terminal");
    *raw = tty->before;
    raw->c_iflag &= ~(tcflag_t)(IGNBRK | BRKINT | PARMRK | ISTRIP | INLCR | IGNCR | ICRNL | IXON);
    raw->c_lflag &= ~(tcflag_t)(ECHO | ECHONL | ICANON | ISIG | IEXTEN);
    raw->c_cflag &= ~(tcflag_t)(CSIZE | PARENB);
    raw->c_cflag |= CS8;
    raw->c_cc[VMIN] = 1;
    raw->c_cc[VTIME] = 0;
    terminal_signals_begin();
    tty->since = terminal_stops_now();
    (void)guardian_keep_terminal(tty->fd, raw);
    (void)guardian_keep_text(tty->fd, tty->off);
    tty->raw = true;
    if (tcsetattr(tty->fd, TCSANOW, raw) != 0)
        return failed(tty, name_of(tty), node_error(errno, text));
    return TIA_OK;
}

/* Sends a text; false when the terminal accepts nothing now. Other failures do not matter: the terminal is read-only,
 * or has hung up. */
static bool send(const struct tty *tty, const char *text)
{
    ssize_t n = terminal_write(tty->fd, text, strlen(text));

    return n == (ssize_t)strlen(text) || (n < 0 && errno != EAGAIN);
}

/* Restores the modes, unless the guardian restored them at a stop: then the shell has the terminal. */
static void make_cooked(const struct tty *tty)
{
    /* If the text cannot be sent now, the guardian sends it later. */
    if (terminal_is_put_back(&tty->since) || send(tty, tty->off))
        guardian_forget_text(tty->fd, tty->off);
    if (!terminal_is_put_back(&tty->since)) {
        (void)tcflush(tty->fd, TCIFLUSH); /* keys typed for the picture are not for the shell */
        (void)tcsetattr(tty->fd, TCSANOW, &tty->before);
    }
    terminal_signals_end();
    guardian_forget_terminal(tty->fd);
}

static void tty_close(void *ctx)
{
    struct tty *tty = ctx;

    if (tty->fd < 0)
        return;
    if (tty->raw)
        make_cooked(tty);
    tty->raw = false;
    (void)close(tty->fd);
    tty->fd = -1;
}

static int tty_open(void *ctx)
{
    struct tty *tty = ctx;
    int status = open_terminal(tty);

    if (!status)
        status = make_raw(tty);
    if (status) {
        tty_close(tty);
        return status;
    }
    (void)send(tty, tty->on);
    tty->controlling = tcgetpgrp(tty->fd) != -1;
    tty->decoder = (struct decoder){0};
    tty->next = tty->count = 0;
    return TIA_OK;
}

static bool has_typed(const struct tty *tty)
{
    return tty->controlling && typed_any();
}

static int take_typed(struct tty *tty)
{
    tty->next = 0;
    tty->count = typed_take(tty->bytes);
    tty->last_us = clock_now_us();
    return 1;
}

/* Reads the bytes that have come; returns 1, or 0 when there are none. */
static int read_bytes(struct tty *tty)
{
    struct pollfd ready = {.fd = tty->fd, .events = POLLIN};

    if (has_typed(tty))
        return take_typed(tty);
    if (poll(&ready, 1, 0) <= 0)
        return 0;
    ssize_t n = read(tty->fd, tty->bytes, sizeof tty->bytes);
    if (n < 0 && (errno == EINTR || errno == EAGAIN))
        return 0;
    if (n < 0 || (n == 0 && ready.revents & (POLLHUP | POLLERR | POLLNVAL)))
        return failed(tty, name_of(tty), "the terminal hung up");
    if (n == 0)
        return 0;
    tty->next = 0;
    tty->count = (size_t)n;
    tty->last_us = clock_now_us();
    return 1;
}

/* Does what Ctrl-Z does: stops all processes of the group, as the terminal would with ISIG. The guardian then restores
 * the terminal. Returns the key that it is if it stops nothing, or 0. */
static uint16_t stop(const struct tty *tty)
{
    if (!tty->stops)
        return 'z';
    (void)kill(0, SIGTSTP);
    return 0;
}

static uint16_t next_key(struct tty *tty)
{
    uint16_t key = 0;

    while (key == 0 && tty->next < tty->count) {
        key = decode_byte(&tty->decoder, tty->bytes[tty->next++]);
        if (key == DECODED_STOP)
            key = stop(tty);
    }
    return key;
}

/* Takes the terminal again after a stop, during which the shell has set its own modes. */
static void after_stop(struct tty *tty)
{
    if (!terminal_is_lost(&tty->since) || !descriptor_await_front(tty->fd))
        return;
    tty->since = terminal_stops_now();
    guardian_keep_again(tty->fd);
    (void)guardian_keep_text(tty->fd, tty->off);
    guardian_sync();
    (void)tcsetattr(tty->fd, TCSANOW, &tty->now);
    (void)send(tty, tty->on);
}

/* Fills in the event; a pointer's position is the middle of its cell. */
static void set_event(const struct tty *tty, uint16_t key, struct tia_event *event)
{
    const struct decoder *d = &tty->decoder;
    struct winsize size = {.ws_col = 0};

    *event = (struct tia_event){.kind = TIA_EVENT_TAP, .key = key, .shift = d->shift, .time_us = tty->last_us};
    if (key != DECODED_POINTER)
        return;
    if (ioctl(tty->fd, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0)
        size = (struct winsize){.ws_col = d->column, .ws_row = d->row};
    *event = (struct tia_event){.kind = TIA_EVENT_POINT,
                                .drag = d->drag,
                                .x = place_across(d->column, size.ws_col),
                                .y = place_down(d->row, size.ws_row)};
}

static int tty_poll(void *ctx, struct tia_event *event)
{
    struct tty *tty = ctx;
    uint16_t key;

    after_stop(tty);
    key = next_key(tty);
    while (key == 0) {
        int status = read_bytes(tty);
        if (status < 0)
            return status;
        if (status == 0)
            break;
        key = next_key(tty);
    }
    if (key == 0 && decode_pending(&tty->decoder) && clock_now_us() - tty->last_us >= SILENCE_US)
        key = decode_silence(&tty->decoder);
    set_event(tty, key, event);
    return key != 0;
}

static int smaller(int limit_ms, int timeout_ms)
{
    return timeout_ms < 0 || limit_ms < timeout_ms ? limit_ms : timeout_ms;
}

/* Returns the time to wait, timeout_ms at most. A sequence that stays unfinished becomes a lone Escape after
 * SILENCE_US. A lost terminal is taken again soon: the SIGCONT that would end the wait may have been counted
 * already. */
static int limit_ms(const struct tty *tty, int timeout_ms)
{
    if (terminal_is_lost(&tty->since))
        timeout_ms = smaller(descriptor_in_front(tty->fd) ? 0 : BEHIND_MS, timeout_ms);
    if (!decode_pending(&tty->decoder))
        return timeout_ms;
    uint64_t end = tty->last_us + SILENCE_US, now = clock_now_us();
    return smaller(end > now ? (int)((end - now + 999) / 1000) : 0, timeout_ms);
}

static int tty_wait(void *ctx, int timeout_ms)
{
    struct tty *tty = ctx;
    struct pollfd ready = {.fd = tty->fd, .events = POLLIN};
    bool decoded = tty->next == tty->count && !has_typed(tty);

    return console_wait(&ready, 1, decoded ? limit_ms(tty, timeout_ms) : 0) < 0 ? TIA_ERR_DEVICE : TIA_OK;
}

const struct tia_input port_tty_input = {
    .open = tty_open,
    .poll = tty_poll,
    .wait = tty_wait,
    .close = tty_close,
};

void *port_tty_create(const struct port_wish *wish)
{
    struct tty *tty = calloc(1, sizeof *tty);

    if (!tty) {
        (void)snprintf(wish->why, PORT_WHY, "memory: exhausted");
        return NULL;
    }
    tty->device = wish->device;
    tty->why = wish->why;
    bool dumb = terminal_is_dumb(getenv("TERM"));
    tty->on = dumb ? "" : wish->pointer ? mouse_on : paste_on;
    tty->off = dumb ? "" : wish->pointer ? mouse_off : paste_off;
    tty->stops = wish->pointer;
    tty->fd = -1;
    return tty;
}

void port_tty_destroy(void *ctx)
{
    free(ctx);
}
