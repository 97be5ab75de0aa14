/* display_state.h - the state of a terminal as a display, for the files that make it up: display.c is the port,
 * display_window.c finds the window and what it can show, display_frame.c encodes frames. */
#ifndef PORT_TERMINAL_DISPLAY_STATE_H
#define PORT_TERMINAL_DISPLAY_STATE_H

#include "device.h"
#include "encode.h"
#include "output.h"
#include "pictures.h"
#include "pixels/canvas.h"
#include "sheet.h"
#include "shown.h"
#include "symbols.h"
#include "terminal_colour.h"
#include "ways.h"
#include "window_title.h"

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
    bool in_line;           /* frames are printed at the cursor */
    bool row;               /* a row is left below the picture if the window has room for it */
    struct way way;         /* the user's choice */
    enum pictures pictures;
    struct symbols symbols;
    struct cell cell; /* size of a character for pictures */
    struct canvas canvas;
    struct shown shown; /* sixel */
    enum colours colours;
    struct grid grid;
    struct port_text *text;     /* NULL: none was set */
    bool titles;                /* the window has a title */
    char title[TITLE_SIZE];     /* the sequence that has set it; empty: none has */
    struct sheet sheet, before; /* the text of the frame being encoded, and of the frame before */
    struct output output;
};

/* Stores the reason for a failure and returns TIA_ERR_DEVICE. */
int display_failed(const struct terminal *t, const char *why);
/* Stores the reason for a failure with this errno and returns TIA_ERR_DEVICE. */
int display_failed_with(const struct terminal *t, int error);

/* Opens the terminal for writing. */
int display_open_window(struct terminal *t);
/* Finds the terminal's colours and characters by TERM, COLORTERM and the locale. */
int display_environment(struct terminal *t);
/* Chooses the kind of pictures; symbols need UTF-8 and colours. */
int display_choose_pictures(struct terminal *t);

/* Returns what text is laid out for in the window. */
struct sheet_window display_sheet_window(const struct terminal *t);

/* Gives the size of the window in characters. */
void display_read_window(const struct terminal *t, unsigned *columns, unsigned *rows);
/* Returns the width in pixels of a window of `columns` columns in half blocks or spaces. */
unsigned display_pixels_across(const struct terminal *t, unsigned columns);
/* Returns the height in pixels of `rows` rows of it. */
unsigned display_pixels_down(const struct terminal *t, unsigned rows);
/* Adapts to the window's current size. Returns TIA_OK or TIA_ERR_MEMORY. */
int display_fit(struct terminal *t);

/* Encodes the frame in the canvas, or a part of it; t->encoding is true while a part is left. Returns TIA_OK or
 * TIA_ERR_MEMORY. */
int display_encode(struct terminal *t);
/* Encodes the frame in the canvas at the cursor, followed by the end of a line. Returns TIA_OK or TIA_ERR_MEMORY. */
int display_print(struct terminal *t);

#endif
