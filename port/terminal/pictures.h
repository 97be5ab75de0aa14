/* pictures.h - pixels as a terminal's pictures, symbols, sixel or kitty's, in builds that have libchafa. */
#ifndef PORT_TERMINAL_PICTURES_H
#define PORT_TERMINAL_PICTURES_H

#include <tia/port.h>

#include "answers.h"
#include "encode.h"

#define PICTURES_BAND 6 /* rows of pixels that sixel sends at once: the height of its pictures is a multiple */

/* The size of a character, pixels. */
struct cell {
    unsigned width, height;
};

/* Queries the terminal for the pictures that it can show, and sets the size of its cells. A terminal that does not
 * report that size gets no query: a picture's size would be unknown. */
enum pictures pictures_find(int fd, struct cell *cell);

/* Sets the size of the cells for pictures that the user chose; NULL, or why they cannot be shown. */
const char *pictures_need(int fd, enum pictures pictures, struct cell *cell);

/* Pixels of a picture in a window of so many columns and rows: whole cells, but of symbols not in the last row, where
 * some terminals scroll; `most` at most, but one cell. */
uint16_t pictures_width(const struct cell *cell, unsigned columns, unsigned most);
uint16_t pictures_height(enum pictures pictures, const struct cell *cell, unsigned rows, unsigned most);

/* Sixel and kitty's; symbols.h has the others. Adds the text that shows width x height pixels in the window's upper
 * left corner, whose cells have that size in pixels. They are not scaled if the picture covers whole cells or, of
 * sixel, the most bands that fit into the cells it reaches. Without memory text->failed gets set. */
void pictures_draw(enum pictures pictures, const tia_rgb565 *pixels, unsigned width, unsigned height,
                   unsigned cell_width, unsigned cell_height, struct text *text);

#endif
