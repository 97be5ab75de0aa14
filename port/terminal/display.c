/* display.c - a terminal's window as a display.
 *
 * Frames are drawn into memory. present encodes the changes strip by strip, and sends the text. After 20 ms of encoding
 * or of waiting for the terminal, the rest is left to go_on. The rest of a frame is sent before the next frame, since
 * the grid counts it as shown.
 */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "clock.h"
#include "console/node.h"
#include "descriptor.h"
#include "encode.h"
#include "output.h"
#include "picture_place.h"
#include "pictures.h"
#include "shown.h"
#include "symbols.h"
#include "terminal.h"
#include "terminal_colour.h"
#include "utf8.h"
#include "ways.h"
#include "window_signals.h"

#define DEFAULT_COLUMNS 80 /* size of a window if its terminal reports none, such as a serial line */
#define DEFAULT_ROWS 24

#define SLICE_MS 20 /* time limit of present and go_on */

static const char clear_direct[] = "\033[48;2;0;0;0m\033[2J", clear_256[] = "\033[48;5;16m\033[2J";

struct terminal {
    const char *device;
    char *why;
    unsigned max_width, max_height;
    bool clear;    /* the next frame clears the window first */
    bool fresh;    /* the canvas has a frame of which no row is encoded */
    bool encoding; /* a frame is encoded up to row `next` */
    bool begun;    /* text has been added for the frame being encoded */
    unsigned next;
    unsigned columns, rows; /* size of the window */
    struct way way;         /* the user's choice */
    enum pictures pictures;
    struct symbols symbols;
    struct cell cell; /* size of a character for pictures */
    struct canvas canvas;
    struct shown shown; /* sixel */
    struct grid grid;
    struct output output;
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

static unsigned smallest(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

static void read_window(const struct terminal *t, unsigned *columns, unsigned *rows)
{
    struct winsize size;

    *columns = DEFAULT_COLUMNS;
    *rows = DEFAULT_ROWS;
    if (ioctl(t->output.fd, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
        *columns = size.ws_col;
        *rows = size.ws_row;
    }
}

/* Returns the width in pixels of a window of `columns` columns. */
static unsigned pixels_across(const struct terminal *t, unsigned columns)
{
    return t->grid.spaces && columns > 1 ? columns / 2 : columns;
}
static unsigned pixels_down(const struct terminal *t, unsigned rows)
{
    return t->grid.spaces ? rows : 2 * rows;
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
        (t->pictures == PICTURES_SIXEL && shown_resize(&t->shown, &t->canvas)) ||
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
    t->encoding = false;
    return TIA_OK;
}

static int open_window(struct terminal *t)
{
    if (!t->device && !isatty(STDOUT_FILENO))
        return failed(t, "standard output is not a terminal");
    t->output.fd = t->device ? descriptor_open(t->device, O_WRONLY) : descriptor_copy(STDOUT_FILENO, O_WRONLY);
    if (t->output.fd < 0 && errno == ENOENT && t->device && !strchr(t->device, '/'))
        return failed(t, "is not a device, nor " WAYS_NAMES);
    if (t->output.fd < 0)
        return failed_with(t, errno);
    return isatty(t->output.fd) ? TIA_OK : failed(t, "is not a terminal");
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

/* Chooses the kind of pictures; symbols need UTF-8. */
static int choose_pictures(struct terminal *t)
{
    const char *why = NULL;

    t->pictures = t->way.pictures;
    if (t->way.chosen)
        why = pictures_need(t->output.fd, t->pictures, &t->cell);
    else
        t->pictures = pictures_find(t->output.fd, &t->cell);
    if (t->pictures == PICTURES_SYMBOLS && t->grid.spaces && !t->way.chosen)
        t->pictures = PICTURES_HALF_BLOCKS;
    else if (t->pictures == PICTURES_SYMBOLS && t->grid.spaces && !why)
        why = "symbols need a locale with UTF-8";
    return why ? failed(t, why) : TIA_OK;
}

static void terminal_close(void *ctx)
{
    struct terminal *t = ctx;

    if (t->output.entered)
        output_leave(&t->output);
    output_free(&t->output);
    t->columns = t->rows = 0;
    place_forget();
    grid_free(&t->grid);
    symbols_free(&t->symbols);
    shown_free(&t->shown);
    canvas_free(&t->canvas);
}

/* ---- frames ---- */

static void begin_frame(struct terminal *t)
{
    if (t->clear) {
        text_add(&t->output.text, t->grid.direct ? clear_direct : clear_256);
        grid_forget(&t->grid);
        symbols_forget(&t->symbols);
        shown_forget(&t->shown);
    }
    t->clear = t->fresh = t->begun = false;
    t->encoding = true;
    t->next = 0;
}

/* Encodes a strip; adds no text if nothing has changed. */
static void encode_strip(struct terminal *t)
{
    struct strip strip = pictures_strip(t->pictures, &t->cell, t->next, t->canvas.width, t->canvas.height);
    struct text *text = &t->output.text;
    size_t before = text->count, begun;

    if (!t->begun)
        text_add(text, FRAME_BEGIN);
    begun = text->count;
    if (t->pictures == PICTURES_SYMBOLS)
        symbols_draw(&t->symbols, t->canvas.pixels, t->canvas.width, t->canvas.height, strip, t->grid.direct, text);
    else if (t->pictures != PICTURES_SIXEL || shown_update(&t->shown, &t->canvas, strip))
        pictures_draw(t->pictures, t->canvas.pixels, t->canvas.width, strip, &t->cell, text);
    t->begun = t->begun || text->count > begun;
    if (!t->begun)
        text->count = before;
    t->next += strip.rows;
}

static void encode_next(struct terminal *t)
{
    if (!t->pictures) {
        grid_draw(&t->grid, t->canvas.pixels, t->canvas.height, &t->output.text);
        t->encoding = false;
        return;
    }
    encode_strip(t);
    t->encoding = t->next < t->canvas.height;
    if (!t->encoding && t->begun)
        text_add(&t->output.text, FRAME_END);
}

static int encode(struct terminal *t)
{
    if (!t->encoding)
        begin_frame(t);
    encode_next(t);
    if (!t->output.text.failed)
        return TIA_OK;
    t->output.text.failed = t->encoding = false;
    t->clear = true;
    (void)failed(t, "out of memory");
    return TIA_ERR_MEMORY;
}

/* True if the process has the window; false in the background. After a stop, the last frame is shown again, since the
 * shell has used the window. */
static bool has_window(struct terminal *t)
{
    if (!output_is_lost(&t->output))
        return true;
    if (!output_take(&t->output))
        return false;
    t->clear = t->fresh = true;
    t->encoding = false;
    return true;
}

/* Continues to send a frame. A frame that is not encoded yet waits until the previous one is sent. A frame that was cut
 * off by a stop is shown again only after the viewer has polled the keys, since the terminal may have hung up. */
static int terminal_go_on(void *ctx)
{
    struct terminal *t = ctx;
    uint64_t end = clock_now_us() + SLICE_MS * 1000;
    int status = TIA_OK;

    while (!status && has_window(t)) {
        if (output_send(&t->output, clock_left_ms(end)))
            return failed_with(t, errno);
        if (output_is_left(&t->output) || clock_left_ms(end) == 0)
            return TIA_BUSY;
        if (output_is_lost(&t->output)) {
            terminal_resume_again();
            return TIA_OK;
        }
        if (!t->encoding && !t->fresh)
            return TIA_OK;
        status = encode(t);
    }
    return status;
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

    describe(t, mode);
    bool again = t->output.entered && output_is_lost(&t->output) && descriptor_in_front(t->output.fd);
    return !status && again ? TIA_BUSY : status;
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
        t->output.kitty = t->pictures == PICTURES_KITTY;
        output_enter(&t->output);
        t->clear = true;
        status = output_send(&t->output, SLICE_MS) ? failed_with(t, errno) : TIA_OK;
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

    if (!t->output.entered)
        return TIA_ERR_ARGUMENT;
    t->fresh = true;
    return terminal_go_on(t);
}

const struct tia_display port_terminal_display = {
    .open = terminal_open,
    .mode = terminal_mode,
    .acquire = terminal_acquire,
    .submit = terminal_submit,
    .present = terminal_present,
    .close = terminal_close,
    .go_on = terminal_go_on,
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
    t->output.fd = -1;
    return t;
}

void port_terminal_destroy(void *ctx)
{
    free(ctx);
}

void port_terminal_list(port_line *line, void *arg)
{
    char why[PORT_WHY] = "", text[PORT_WHY + 64];
    struct terminal t = {.why = why, .output.fd = -1};
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
