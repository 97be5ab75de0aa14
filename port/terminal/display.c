/* display.c - a terminal's window as a display.
 *
 * Frames are drawn into memory; present encodes what changed and sends it in one write. What the terminal does not
 * accept at once is sent when it is ready. A signal may end that wait; then the rest is sent before the next frame,
 * since the grid counts it as shown.
 */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "clock.h"
#include "colour.h"
#include "console/console.h"
#include "console/guardian.h"
#include "console/node.h"
#include "descriptor.h"
#include "encode.h"
#include "pictures.h"
#include "pixels/canvas.h"
#include "place.h"
#include "signals.h"
#include "symbols.h"
#include "terminal.h"
#include "utf8.h"
#include "ways.h"

#define DEFAULT_COLUMNS 80 /* for a terminal that does not know its size, such as a serial line */
#define DEFAULT_ROWS 24
#define LAST_WRITE_MS 150 /* how long close waits for a terminal that accepts nothing */

/* The alternate screen, no cursor, no automatic wrap; and back, even from the middle of a sequence or of a picture's
 * string: CAN ends it on some terminals and ST on the others, and for kitty the picture's data end, too, without an
 * answer. A terminal without an alternate screen is cleared. */
#define CUT "\030\033\\"
#define LEAVE "\033[?2026l\033[0m\033[2J\033[H\033[?7h\033[?25h\033[?1049l"
static const char enter_text[] = "\033[?1049h\033[?25l\033[?7l", leave_text[] = CUT LEAVE,
                  leave_kitty[] = CUT "\033_Gm=0,q=2;\033\\" LEAVE;
static const char clear_direct[] = "\033[48;2;0;0;0m\033[2J", clear_256[] = "\033[48;5;16m\033[2J";

struct terminal {
    const char *device;
    char *why;
    unsigned max_width, max_height;
    int fd; /* -1: closed */
    bool entered;
    bool clear;             /* the next frame begins on an empty window */
    int resumes;            /* of signals.h, when the window was last drawn */
    unsigned columns, rows; /* of the window */
    struct way way;         /* as the user wants it */
    enum pictures pictures;
    struct symbols symbols;
    struct cell cell; /* where there are pictures */
    struct canvas canvas;
    struct grid grid;
    struct text text; /* what is to be sent: [sent, text.count) */
    size_t sent;
};

static int failed(const struct terminal *t, const char *why)
{
    (void)snprintf(t->why, PORT_WHY, "%s: %s", t->device ? t->device : "terminal", why);
    return TIA_ERR_DEVICE;
}

static int failed_with(const struct terminal *t, int error)
{
    char text[PORT_WHY];

    return failed(t, node_error(error, text));
}

/* Sends what the terminal accepts within timeout_ms in all (-1: no limit) and before a signal. */
static int send_text(struct terminal *t, int timeout_ms)
{
    uint64_t end = clock_now_us() + (uint64_t)(timeout_ms < 0 ? 0 : timeout_ms) * 1000;

    while (t->sent < t->text.count) {
        ssize_t n = write(t->fd, t->text.bytes + t->sent, t->text.count - t->sent);
        struct pollfd ready = {.fd = t->fd, .events = POLLOUT};
        if (n >= 0)
            t->sent += (size_t)n;
        else if (errno == EAGAIN && console_wait(&ready, 1, timeout_ms < 0 ? -1 : clock_left_ms(end)) <= 0)
            return TIA_OK;
        else if (errno != EAGAIN && errno != EINTR)
            return TIA_ERR_DEVICE;
    }
    t->sent = t->text.count = 0;
    return TIA_OK;
}

static int show(struct terminal *t)
{
    return !send_text(t, -1) ? TIA_OK : failed_with(t, errno);
}

static unsigned smallest(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

static void read_window(const struct terminal *t, unsigned *columns, unsigned *rows)
{
    struct winsize size;

    *columns = DEFAULT_COLUMNS;
    *rows = DEFAULT_ROWS;
    if (ioctl(t->fd, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
        *columns = size.ws_col;
        *rows = size.ws_row;
    }
}

/* Pixels in a window of so many columns and rows. */
static unsigned pixels_across(const struct terminal *t, unsigned columns)
{
    return t->grid.spaces && columns > 1 ? columns / 2 : columns;
}
static unsigned pixels_down(const struct terminal *t, unsigned rows)
{
    return t->grid.spaces ? rows : 2 * rows;
}

static void draw_picture(struct terminal *t)
{
    const struct cell *cell = &t->cell;

    if (t->pictures == PICTURES_SYMBOLS)
        symbols_draw(&t->symbols, t->canvas.pixels, t->canvas.width, t->canvas.height, t->grid.direct, &t->text);
    else
        pictures_draw(t->pictures, t->canvas.pixels, t->canvas.width, t->canvas.height, cell->width, cell->height,
                      &t->text);
}

/* Adapts to the window's current size. */
static int fit_window(struct terminal *t)
{
    unsigned columns, rows;

    read_window(t, &columns, &rows);
    if (columns == t->columns && rows == t->rows)
        return TIA_OK;
    uint16_t width = (uint16_t)smallest(pixels_across(t, columns), t->max_width);
    uint16_t height = (uint16_t)smallest(pixels_down(t, rows), t->max_height);
    if (t->pictures) {
        width = pictures_width(&t->cell, columns, t->max_width);
        height = pictures_height(t->pictures, &t->cell, rows, t->max_height);
    }
    if (canvas_resize(&t->canvas, width, height) ||
        (!t->pictures && grid_resize(&t->grid, width, height, columns, rows))) {
        t->columns = t->rows = 0;
        (void)failed(t, "out of memory");
        return TIA_ERR_MEMORY;
    }
    t->columns = columns;
    t->rows = rows;
    if (t->pictures)
        place_of_picture(&t->cell, width, height);
    else
        place_of_grid(&t->grid, width, height);
    t->clear = true;
    return TIA_OK;
}

static int open_window(struct terminal *t)
{
    if (!t->device && !isatty(STDOUT_FILENO))
        return failed(t, "standard output is no terminal");
    t->fd = t->device ? descriptor_open(t->device, O_WRONLY) : descriptor_copy(STDOUT_FILENO, O_WRONLY);
    if (t->fd < 0 && errno == ENOENT && t->device && !strchr(t->device, '/'))
        return failed(t, "is no device, nor " WAYS_NAMES);
    if (t->fd < 0)
        return failed_with(t, errno);
    return isatty(t->fd) ? TIA_OK : failed(t, "is no terminal");
}

static int look_at_environment(struct terminal *t)
{
    const char *term = getenv("TERM");

    if (!term || !*term || strcmp(term, "dumb") == 0)
        return failed(t, "cannot place a cursor (set TERM if it can)");
    t->grid.direct = colour_is_direct(term, getenv("COLORTERM"));
    t->grid.spaces = !locale_is_utf8();
    return TIA_OK;
}

/* Symbols need UTF-8. */
static int choose_pictures(struct terminal *t)
{
    const char *why = NULL;

    t->pictures = t->way.pictures;
    if (t->way.chosen)
        why = pictures_need(t->fd, t->pictures, &t->cell);
    else
        t->pictures = pictures_find(t->fd, &t->cell);
    if (t->pictures == PICTURES_SYMBOLS && t->grid.spaces && !t->way.chosen)
        t->pictures = PICTURES_HALF_BLOCKS;
    else if (t->pictures == PICTURES_SYMBOLS && t->grid.spaces && !why)
        why = "symbols need a locale with UTF-8";
    return why ? failed(t, why) : TIA_OK;
}

static const char *leaving(const struct terminal *t)
{
    return t->pictures == PICTURES_KITTY ? leave_kitty : leave_text;
}

static void enter(struct terminal *t)
{
    (void)guardian_keep_text(t->fd, leaving(t));
    terminal_signals_begin();
    t->resumes = terminal_resumes();
    text_add(&t->text, enter_text);
    t->entered = true;
}

/* Drops the rest of a frame, also what the kernel has of it: a slow terminal would take long to show it. */
static void drop_text(struct terminal *t)
{
    descriptor_drop_output(t->fd);
    t->sent = t->text.count = 0;
}

static void leave(struct terminal *t)
{
    uint64_t end = clock_now_us() + LAST_WRITE_MS * 1000;

    if (t->sent < t->text.count)
        drop_text(t);
    text_add(&t->text, leaving(t));
    do /* a signal ends a wait, too */
        (void)send_text(t, clock_left_ms(end));
    while (t->sent < t->text.count && clock_left_ms(end) > 0);
    terminal_signals_end();
    /* Otherwise the guardian sends it when the terminal accepts it. */
    if (t->sent == t->text.count)
        guardian_forget_text(t->fd, leaving(t));
    t->entered = false;
}

static void terminal_close(void *ctx)
{
    struct terminal *t = ctx;

    if (t->entered)
        leave(t);
    if (t->fd >= 0)
        (void)close(t->fd);
    t->fd = -1;
    t->columns = t->rows = 0;
    place_forget();
    t->sent = 0;
    text_free(&t->text);
    grid_free(&t->grid);
    symbols_free(&t->symbols);
    canvas_free(&t->canvas);
}

/* Encodes the canvas and sends what the terminal does not show already. */
static int draw(struct terminal *t)
{
    if (t->clear) {
        text_add(&t->text, t->grid.direct ? clear_direct : clear_256);
        grid_forget(&t->grid);
        symbols_forget(&t->symbols);
    }
    if (t->pictures)
        draw_picture(t);
    else
        grid_draw(&t->grid, t->canvas.pixels, t->canvas.height, &t->text);
    t->clear = t->text.failed;
    if (t->text.failed) {
        t->text.failed = false;
        (void)failed(t, "out of memory");
        return TIA_ERR_MEMORY;
    }
    return show(t);
}

/* After a stop the window shows what the shell wrote, so the last frame is drawn again. */
static int draw_again(struct terminal *t)
{
    t->resumes = terminal_resumes();
    t->clear = true;
    text_add(&t->text, enter_text);
    return draw(t);
}

static void describe(const struct terminal *t, struct tia_mode *mode)
{
    *mode = (struct tia_mode){
        .width = t->canvas.width,
        .height = t->canvas.height,
        .concurrent = true,
        .format = ways_format(t->pictures, t->grid.direct),
    };
}

static int terminal_mode(void *ctx, struct tia_mode *mode)
{
    struct terminal *t = ctx;
    int status = fit_window(t);

    if (!status && t->entered && t->resumes != terminal_resumes())
        status = draw_again(t);
    describe(t, mode);
    return status;
}

static int terminal_open(void *ctx, struct tia_mode *mode)
{
    struct terminal *t = ctx;
    int status = open_window(t);

    if (!status)
        status = look_at_environment(t);
    if (!status)
        status = choose_pictures(t);
    if (!status)
        status = fit_window(t);
    if (!status) {
        enter(t);
        status = show(t);
    }
    if (status)
        terminal_close(t);
    else
        describe(t, mode);
    return status;
}

static int terminal_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    return canvas_tile(&((struct terminal *)ctx)->canvas, tile, surface);
}

static int terminal_submit(void *ctx, struct tia_tile tile)
{
    const struct terminal *t = ctx;

    return tile_inside(tile, t->canvas.width, t->canvas.height) ? TIA_OK : TIA_ERR_ARGUMENT;
}

static int terminal_present(void *ctx)
{
    struct terminal *t = ctx;

    return t->entered ? draw(t) : TIA_ERR_ARGUMENT;
}

const struct tia_display port_terminal_display = {
    .open = terminal_open,
    .mode = terminal_mode,
    .acquire = terminal_acquire,
    .submit = terminal_submit,
    .present = terminal_present,
    .close = terminal_close,
};

void *port_terminal_create(const struct port_wish *wish)
{
    struct terminal *t = calloc(1, sizeof *t);

    if (!t) {
        (void)snprintf(wish->why, PORT_WHY, "terminal: out of memory");
        return NULL;
    }
    t->device = ways_find(wish->device, &t->way) ? NULL : wish->device;
    t->why = wish->why;
    t->max_width = wish->width ? wish->width : TIA_SIZE_MAX;
    t->max_height = wish->height ? wish->height : TIA_SIZE_MAX;
    t->fd = -1;
    return t;
}

void port_terminal_destroy(void *ctx)
{
    free(ctx);
}

void port_terminal_list(port_line *line, void *arg)
{
    char why[PORT_WHY] = "", text[PORT_WHY + 64];
    struct terminal t = {.why = why, .fd = -1};
    unsigned columns, rows;

    if (open_window(&t) || look_at_environment(&t)) {
        line(arg, why);
    } else {
        read_window(&t, &columns, &rows);
        (void)snprintf(text, sizeof text, "%ux%u, %s", pixels_across(&t, columns), pixels_down(&t, rows),
                       t.grid.direct ? "24-bit colours" : "256 colours (set COLORTERM=truecolor if it has more)");
        line(arg, text);
    }
    terminal_close(&t);
}
