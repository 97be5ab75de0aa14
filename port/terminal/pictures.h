/* pictures.h - pixels as a terminal's pictures, symbols, sixel or kitty's, in builds that have libchafa. */
#ifndef PORT_TERMINAL_PICTURES_H
#define PORT_TERMINAL_PICTURES_H

#include <tia/port.h>

#include "answers.h"
#include "encode.h"

#define PICTURES_BAND 6 /* rows of pixels that sixel sends at once: heights of its pictures are multiples */

/* The size of a character in pixels. */
struct cell {
    unsigned width, height;
};

/* Queries the terminal for the pictures that it can show, and sets the size of its cells. A terminal that does not
 * report that size gets no query: a picture's size would be unknown. */
enum pictures pictures_find(int fd, struct cell *cell);

/* Sets the size of the cells for pictures that the user chose; returns NULL, or the reason why the terminal cannot show
 * them. */
const char *pictures_need(int fd, enum pictures pictures, struct cell *cell);

/* Returns the width of a picture, in pixels, in a window of `columns` columns: whole cells, `most` pixels at most, but
 * at least one cell. */
uint16_t pictures_width(const struct cell *cell, unsigned columns, unsigned most);
/* Returns the height of a picture, in pixels, in a window of `rows` rows: whole cells as for the width, and of sixel
 * whole bands. Only symbols use the last row: after a picture there, some terminals scroll. */
uint16_t pictures_height(enum pictures pictures, const struct cell *cell, unsigned rows, unsigned most);

/* Returns the strip from row `first` on of a picture of width x height pixels. Strips consist of whole cells and, for
 * sixel, whole bands, except the last strip. Encoding one takes some 30 ms at most. */
struct strip pictures_strip(enum pictures pictures, const struct cell *cell, unsigned first, unsigned width,
                            unsigned height);

/* Adds the text, of sixel or kitty's protocol, that shows a strip of a picture in the window's upper left corner;
 * symbols.h has the other kinds. The picture's rows have `width` pixels, which are not scaled if the strip covers whole
 * cells or, for sixel, the most bands that fit into the cells that it reaches. A frame's strips come from the top down.
 * Sets text->failed when memory is short. */
void pictures_draw(enum pictures pictures, const tia_rgb565 *pixels, unsigned width, struct strip strip,
                   const struct cell *cell, struct text *text);

#endif
