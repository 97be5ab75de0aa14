/* symbols.h - pixels as characters in two colours each, chosen by libchafa: blocks, lines and Braille. */
#ifndef PORT_TERMINAL_SYMBOLS_H
#define PORT_TERMINAL_SYMBOLS_H

#include <tia/port.h>

#include "encode.h"

/* Size of a character in pixels. libchafa compares 8 x 8 points; a character is about twice as high as it is wide. */
#define SYMBOLS_WIDTH 4
#define SYMBOLS_HEIGHT 8

struct symbol;

/* The terminal's contents, from its upper left corner. Zero: unknown. */
struct symbols {
    struct symbol *cells;
    unsigned columns, rows;
    bool known;
    bool few;                   /* 16 colours, if not direct */
    bool prints;                /* characters are sent at the cursor, each row with the end of a line */
    const struct cover *covers; /* NULL, or for each row of the window what is not drawn */
};

/* Adds the text that shows a strip of a picture of width x height pixels, in whole characters, with 24-bit colours
 * (`direct`) or 256 or 16, by libchafa's ordered dithering. Characters that have not changed are left out. A frame's
 * strips come from the top down. When text->failed is set, the contents are unknown. */
void symbols_draw(struct symbols *symbols, const tia_rgb565 *pixels, unsigned width, unsigned height,
                  struct strip strip, bool direct, struct text *text);
void symbols_forget(struct symbols *symbols); /* Marks the contents as unknown: the window may show anything. */
void symbols_free(struct symbols *symbols);

#endif
