/* sheet.h - rows of characters in a terminal's window, over its picture or below it: a status row, notes, and a panel.
 * Uses no device. */
#ifndef PORT_TERMINAL_SHEET_H
#define PORT_TERMINAL_SHEET_H

#include "device.h"
#include "encode.h"

#define SHEET_STATUS_ROWS 3 /* least rows of a window that has one of them for the status */

/* The colours of the text: of 256; of 16; or none, but bold and reversed text. */
enum sheet_colours { SHEET_256, SHEET_16, SHEET_PLAIN };

/* What the sheet is laid out for. */
struct sheet_window {
    unsigned columns, rows;
    bool utf8; /* other characters than ASCII are sent too */
    enum sheet_colours colours;
    bool bare_back; /* an erased cell has the terminal's own background, else black */
};

struct sheet {
    struct sheet_window window;
    struct cover *covers; /* for each row of the window, the columns that its text covers */
    size_t *ends;         /* for each row, the end of its part of `text` */
    struct text text;     /* control sequences and characters, row by row */
    bool known;           /* the terminal shows the text */
};

/* Lays the text out for the window, of at least one column and row. text->first and text->more are set as the
 * declaration of struct port_text says. A control character, or a character that the window does not get, becomes '?'.
 * When memory is short, sheet->text.failed is set, and nothing is covered. */
void sheet_compose(struct sheet *sheet, struct port_text *text, const struct sheet_window *window);

/* Adds the text that erases what `before` covers and `now` covers in other columns, or not at all. */
void sheet_erase(const struct sheet *before, const struct sheet *now, struct text *text);
/* Adds the rows of `now` that differ from those of `before`, or all if the terminal does not show `before`. */
void sheet_draw(const struct sheet *before, struct sheet *now, struct text *text);

void sheet_free(struct sheet *sheet);

#endif
