/* display_window.c - the window of a terminal, and what it can show. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "console/node.h"
#include "descriptor.h"
#include "display_state.h"
#include "dither.h"
#include "picture_place.h"
#include "terminal_colour.h"
#include "utf8.h"

#define DEFAULT_COLUMNS 80 /* size of a window if its terminal reports none, such as a serial line */
#define DEFAULT_ROWS 24

int display_failed(const struct terminal *t, const char *why)
{
    (void)snprintf(t->why, PORT_WHY, "%s: %s", t->device ? t->device : "terminal", why);
    return TIA_ERR_DEVICE;
}

int display_failed_with(const struct terminal *t, int error)
{
    char text[PORT_WHY];

    return display_failed(t, node_error(error, text));
}

static unsigned smallest(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

void display_read_window(const struct terminal *t, unsigned *columns, unsigned *rows)
{
    struct winsize size;

    *columns = DEFAULT_COLUMNS;
    *rows = DEFAULT_ROWS;
    if (ioctl(t->output.fd, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
        *columns = size.ws_col;
        *rows = size.ws_row;
    }
}

unsigned display_pixels_across(const struct terminal *t, unsigned columns)
{
    return t->grid.spaces && columns > 1 ? columns / 2 : columns;
}
unsigned display_pixels_down(const struct terminal *t, unsigned rows)
{
    return t->grid.spaces ? rows : 2 * rows;
}

/* Returns the rows of the window that the picture may use: not the last one if that is for the status, unless the user
 * chose a picture that needs it. Pictures of sixel and kitty's protocol never use the last row. */
static unsigned rows_of_picture(const struct terminal *t, unsigned rows)
{
    if (t->in_line)
        return rows > 1 && t->max_height == TIA_SIZE_MAX ? rows - 1 : rows; /* one row is for the shell's prompt */
    bool characters = t->pictures <= PICTURES_SYMBOLS;
    unsigned height = t->pictures ? t->cell.height * (rows - 1) : display_pixels_down(t, rows - 1);

    return t->row && characters && rows >= SHEET_STATUS_ROWS &&
                   (t->max_height == TIA_SIZE_MAX || height >= t->max_height)
               ? rows - 1
               : rows;
}

int display_fit(struct terminal *t)
{
    unsigned columns, rows, used;

    display_read_window(t, &columns, &rows);
    if (columns == t->columns && rows == t->rows)
        return TIA_OK;
    used = rows_of_picture(t, rows);
    uint16_t width = (uint16_t)smallest(display_pixels_across(t, columns), t->max_width);
    uint16_t height = (uint16_t)smallest(display_pixels_down(t, used), t->max_height);
    if (t->pictures) {
        width = pictures_width(&t->cell, columns, t->max_width);
        height = pictures_height(t->pictures, &t->cell, used, t->max_height);
    }
    if (canvas_resize(&t->canvas, width, height) ||
        (t->pictures == PICTURES_SIXEL && shown_resize(&t->shown, &t->canvas)) ||
        (!t->pictures && grid_resize(&t->grid, width, height, columns, used))) {
        t->columns = t->rows = 0;
        (void)display_failed(t, "out of memory");
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

int display_open_window(struct terminal *t)
{
    if (!t->device && !isatty(STDOUT_FILENO))
        return display_failed(
            t, "standard output is not a terminal (-o FILE draws into a file, -o - --format ppm into a pipe)");
    t->output.fd = t->device ? descriptor_open(t->device, O_WRONLY) : descriptor_copy(STDOUT_FILENO, O_WRONLY);
    if (t->output.fd < 0 && errno == ENOENT && t->device && !strchr(t->device, '/'))
        return display_failed(t, "is not a device, nor " WAYS_NAMES);
    if (t->output.fd < 0)
        return display_failed_with(t, errno);
    return isatty(t->output.fd) ? TIA_OK : display_failed(t, "is not a terminal");
}

int display_environment(struct terminal *t)
{
    const char *term = getenv("TERM");

    if (terminal_is_dumb(term) && !t->in_line)
        return display_failed(t, "cannot place a cursor (--inline prints a picture; set TERM if it can)");
    t->colours = colours_of(term, getenv("COLORTERM"));
    t->grid.direct = t->colours == COLOURS_DIRECT;
    t->grid.letters = t->colours == COLOURS_NONE;
    t->grid.few = t->symbols.few = colours_are_few(t->colours);
    t->grid.dim_back = t->colours == COLOURS_CONSOLE;
    t->grid.spaces = !locale_is_utf8() && !t->grid.letters;
    t->titles = title_is_shown(term);
    return TIA_OK;
}

struct sheet_window display_sheet_window(const struct terminal *t)
{
    return (struct sheet_window){.columns = t->columns,
                                 .rows = t->rows,
                                 .utf8 = !t->grid.spaces && !t->grid.letters,
                                 .colours = t->grid.letters ? SHEET_PLAIN
                                            : t->grid.few   ? SHEET_16
                                                            : SHEET_256,
                                 .bare_back = t->pictures == PICTURES_KITTY};
}

/* Returns the reason why the terminal has no symbols, or NULL. */
static const char *symbols_need(const struct terminal *t)
{
    return t->grid.spaces ? "symbols need a locale with UTF-8" : t->grid.letters ? "symbols need colours" : NULL;
}

int display_choose_pictures(struct terminal *t)
{
    const char *why = NULL;

    t->pictures = t->way.pictures;
    if (t->way.chosen)
        why = pictures_need(t->output.fd, t->pictures, &t->cell);
    else if (!terminal_is_dumb(getenv("TERM")))
        t->pictures = pictures_find(t->output.fd, &t->cell);
    if (t->pictures == PICTURES_SYMBOLS && symbols_need(t) && !t->way.chosen)
        t->pictures = PICTURES_HALF_BLOCKS;
    else if (t->pictures == PICTURES_SYMBOLS && !why)
        why = symbols_need(t);
    if (why)
        return display_failed(t, why);
    bool palette = t->pictures == PICTURES_HALF_BLOCKS && !t->grid.direct && !t->grid.letters;
    if (palette && !t->grid.dither)
        t->grid.dither = dither_new(t->colours);
    return t->grid.dither || !palette ? TIA_OK : display_failed(t, "out of memory");
}
