/* encode.h - turns pixels into text that makes a terminal show them. Uses no device.
 *
 * A character cell shows two pixels: the upper half block U+2580 in the upper pixel's colour on a background of the
 * lower pixel's. Without UTF-8 a pixel is two spaces, which together are about square. Without colours a cell of two
 * pixels is a letter. Only cells that changed are written.
 */
#ifndef PORT_TERMINAL_ENCODE_H
#define PORT_TERMINAL_ENCODE_H

#include <tia/port.h>

/* A growable string. When memory is short, it stays unchanged, and `failed` becomes true. */
struct text {
    char *bytes;
    size_t count, capacity;
    bool failed;
};

void text_add(struct text *text, const char *string);

/* Begins a synchronised update: terminals that support it show the whole frame at once, others ignore it. */
#define FRAME_BEGIN "\033[?2026h"
/* Ends a synchronised update. */
#define FRAME_END "\033[?2026l"
/* Ends a line in a terminal's own colours. */
#define LINE_END "\033[0m\r\n"
void text_free(struct text *text);

/* A strip: some pixel rows of a picture. */
struct strip {
    unsigned first, rows;
};

struct dither;

/* Columns of a row of the window that text covers; width 0: none. */
struct cover {
    unsigned left, width;
};

/* The terminal's contents, cell by cell, as last written. */
struct grid {
    unsigned columns, rows; /* size in cells: the picture's width and (height + 1)/2 or, with `spaces`, its height */
    unsigned left, top;     /* position of the grid in the window, columns and rows from 0 */
    bool direct;            /* 24-bit colours, else 256 or 16 */
    bool few;               /* 16 colours, if not direct */
    bool dim_back;          /* 16 colours: only the first 8 as backgrounds */
    struct dither *dither;  /* how to show a pixel by the palette; NULL: the nearest of the 256 colours */
    bool letters;           /* no colours: a cell is two pixels, drawn as a letter */
    bool spaces;            /* a cell is one pixel, drawn as two spaces; else two pixels, drawn as a half block */
    bool known;             /* the terminal shows `cells` */
    uint64_t *cells;        /* codes of a cell's colours: upper << 16 | lower; or its letter, or GRID_HIDDEN */
    const struct cover *covers; /* NULL, or for each row of the window what is not drawn */
};

#define GRID_HIDDEN UINT64_MAX /* a cell below text */

/* The longest text for one cell: a cursor movement (14 bytes at 5-digit coordinates), two 24-bit colours (36) and the
 * block (3). */
#define GRID_CELL_BYTES 56

/* Makes the grid for a width x height picture in the middle of a window of window_columns x window_rows; its contents
 * are unknown. Returns TIA_OK or TIA_ERR_MEMORY. */
int grid_resize(struct grid *grid, unsigned width, unsigned height, unsigned window_columns, unsigned window_rows);
/* Adds the picture at the cursor: rows of cells, each with the end of a line. */
void grid_print(struct grid *grid, const tia_rgb565 *pixels, unsigned height, struct text *text);

void grid_forget(struct grid *grid); /* Marks the contents as unknown: the window may show anything. */
void grid_free(struct grid *grid);

/* Adds the text that changes the terminal from the contents of the grid to the picture, and updates the grid. Adds
 * nothing if the two agree. `pixels` has `height` rows of the grid's width. If text->failed becomes true, nothing is
 * added, and the contents of the grid are unknown. */
void grid_draw(struct grid *grid, const tia_rgb565 *pixels, unsigned height, struct text *text);

#endif
