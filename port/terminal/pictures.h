/* pictures.h - pixels as a terminal's pictures (symbols, sixel or kitty's), in builds that have libchafa. */
#ifndef PORT_TERMINAL_PICTURES_H
#define PORT_TERMINAL_PICTURES_H

#include <tia/port.h>

#include "answers.h"
#include "encode.h"

#define PICTURES_BAND 6 /* rows of pixels in a band of sixel: a picture's height is a multiple */

/* The size of a character in pixels. */
struct cell {
    unsigned width, height;
};

/* Queries the terminal for the pictures that it can show, and sets the size of its cells. A terminal that does not
 * report that size gets no query: a picture's size would be unknown. */
enum pictures pictures_find(int fd, struct cell *cell);

/* Sets the size of the cells for pictures that the user chose; returns NULL, or the reason why they cannot be shown. */
const char *pictures_need(int fd, enum pictures pictures, struct cell *cell);

/* Returns a picture's width in pixels in a window of so many columns: whole cells, `most` pixels at most, but at least
 * one cell. */
uint16_t pictures_width(const struct cell *cell, unsigned columns, unsigned most);
/* Returns its height: whole cells, `most` at most, but at least one; symbols leave out the last row, where some
 * terminals scroll. */
uint16_t pictures_height(enum pictures pictures, const struct cell *cell, unsigned rows, unsigned most);

/* Returns the strip that begins with row `first` of a picture of width x height pixels: whole cells, and for sixel
 * whole bands, except for the last strip. It takes a processor some 30 ms at most. */
struct strip pictures_strip(enum pictures pictures, const struct cell *cell, unsigned first, unsigned width,
                            unsigned height);

/* Adds the text that shows a strip of a picture in the window's upper left corner, for sixel and kitty's (symbols.h has
 * the others). Its rows have `width` pixels. The strip is not scaled if it covers whole cells or, for sixel, the most
 * bands that fit into the cells it reaches. A frame's strips come from the top down. Without memory text->failed gets
 * set. */
void pictures_draw(enum pictures pictures, const tia_rgb565 *pixels, unsigned width, struct strip strip,
                   const struct cell *cell, struct text *text);

#endif
